// Reading FlatBuffers without trusting them: every offset is checked against the file. A reading that leaves
// the file gives nothing (an absent table, zero, an empty vector) and is remembered in `bad_byte`, so that
// readers stay free of error plumbing and ask once at the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>

namespace posecoach {

class FlatTable;

class Flatbuffer {
 public:
  explicit Flatbuffer(std::string_view bytes) : bytes_(bytes) {}

  // The file must outlive its tables.
  FlatTable root() const;
  // "TFL3" and the like: the four bytes that name the kind of file.
  std::string_view identifier() const { return bytes_.size() < 8 ? "" : bytes_.substr(4, 4); }
  // Where the first reading outside the file was tried.
  std::optional<std::size_t> bad_byte() const { return bad_byte_; }

  // For tables and vectors.
  template <typename T>
  T read(std::size_t at) const {
    static_assert(std::is_arithmetic_v<T>);
    T value{};
    if (has(at, sizeof(T))) std::memcpy(&value, bytes_.data() + at, sizeof(T));
    return value;
  }
  bool has(std::size_t at, std::size_t count) const;
  // Follows the unsigned offset stored at `at`; 0 when it leads nowhere.
  std::size_t follow(std::size_t at) const;
  std::string_view bytes(std::size_t at, std::size_t count) const;

 private:
  std::string_view bytes_;
  mutable std::optional<std::size_t> bad_byte_;
};

// A vector of numbers, tables, or bytes.
class FlatVector {
 public:
  FlatVector() = default;
  FlatVector(const Flatbuffer& file, std::size_t at, std::size_t element_bytes);

  std::size_t size() const { return size_; }
  template <typename T>
  T number(std::size_t i) const {
    return i < size_ ? file_->read<T>(begin_ + i * sizeof(T)) : T{};
  }
  FlatTable table(std::size_t i) const;
  std::string_view bytes() const { return size_ == 0 ? std::string_view() : file_->bytes(begin_, size_); }

 private:
  const Flatbuffer* file_ = nullptr;
  std::size_t begin_ = 0;
  std::size_t size_ = 0;
};

// A table; its fields are named by their slot, the number in the schema's order. An absent table answers like
// one whose fields are all absent.
class FlatTable {
 public:
  FlatTable() = default;
  FlatTable(const Flatbuffer& file, std::size_t at);

  explicit operator bool() const { return file_ != nullptr; }
  template <typename T>
  T number(int slot, T when_absent = T{}) const {
    const std::size_t at = field(slot);
    return at == 0 ? when_absent : file_->read<T>(at);
  }
  FlatTable table(int slot) const;
  template <typename T>
  FlatVector numbers(int slot) const {
    return vector(slot, sizeof(T));
  }
  FlatVector tables(int slot) const { return vector(slot, sizeof(std::uint32_t)); }
  std::string_view text(int slot) const { return vector(slot, 1).bytes(); }

 private:
  std::size_t field(int slot) const;
  FlatVector vector(int slot, std::size_t element_bytes) const;

  const Flatbuffer* file_ = nullptr;
  std::size_t at_ = 0;
  std::size_t field_offsets_ = 0;  // position of the table's list of field offsets
  std::size_t field_count_ = 0;
  std::size_t table_bytes_ = 0;
};

}  // namespace posecoach
