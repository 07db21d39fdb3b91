#include "core/vision/flatbuffer.h"

namespace posecoach {

bool Flatbuffer::has(std::size_t at, std::size_t count) const {
  if (at <= bytes_.size() && count <= bytes_.size() - at) return true;
  if (!bad_byte_) bad_byte_ = at;
  return false;
}

std::size_t Flatbuffer::follow(std::size_t at) const {
  const std::size_t offset = read<std::uint32_t>(at);
  if (offset == 0 || !has(at + offset, 4)) return 0;
  return at + offset;
}

std::string_view Flatbuffer::bytes(std::size_t at, std::size_t count) const {
  return has(at, count) ? bytes_.substr(at, count) : std::string_view();
}

FlatTable Flatbuffer::root() const {
  const std::size_t at = follow(0);
  return at == 0 ? FlatTable() : FlatTable(*this, at);
}

FlatVector::FlatVector(const Flatbuffer& file, std::size_t at, std::size_t element_bytes) : file_(&file) {
  const std::size_t count = file.read<std::uint32_t>(at);
  begin_ = at + sizeof(std::uint32_t);
  if (file.has(begin_, count * element_bytes)) size_ = count;
}

FlatTable FlatVector::table(std::size_t i) const {
  if (i >= size_) return {};
  const std::size_t at = file_->follow(begin_ + i * sizeof(std::uint32_t));
  return at == 0 ? FlatTable() : FlatTable(*file_, at);
}

FlatTable::FlatTable(const Flatbuffer& file, std::size_t at) {
  const std::int64_t offsets = static_cast<std::int64_t>(at) - file.read<std::int32_t>(at);
  // A negative position becomes one far behind the file's end, which no file has.
  const auto list = static_cast<std::size_t>(offsets);
  if (!file.has(list, 4)) return;
  const std::size_t list_bytes = file.read<std::uint16_t>(list);
  const std::size_t table_bytes = file.read<std::uint16_t>(list + 2);
  if (list_bytes < 4 || !file.has(list, list_bytes) || !file.has(at, table_bytes)) return;
  file_ = &file;
  at_ = at;
  field_offsets_ = list + 4;
  field_count_ = (list_bytes - 4) / 2;
  table_bytes_ = table_bytes;
}

std::size_t FlatTable::field(int slot) const {
  const auto i = static_cast<std::size_t>(slot);
  if (file_ == nullptr || i >= field_count_) return 0;
  const std::size_t offset = file_->read<std::uint16_t>(field_offsets_ + 2 * i);
  if (offset == 0) return 0;
  if (offset >= table_bytes_) {
    file_->has(at_ + offset, ~std::size_t{0});  // remember it as a bad byte
    return 0;
  }
  return at_ + offset;
}

FlatTable FlatTable::table(int slot) const {
  const std::size_t at = field(slot);
  const std::size_t target = at == 0 ? 0 : file_->follow(at);
  return target == 0 ? FlatTable() : FlatTable(*file_, target);
}

FlatVector FlatTable::vector(int slot, std::size_t element_bytes) const {
  const std::size_t at = field(slot);
  const std::size_t target = at == 0 ? 0 : file_->follow(at);
  return target == 0 ? FlatVector() : FlatVector(*file_, target, element_bytes);
}

}  // namespace posecoach
