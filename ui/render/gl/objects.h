// OpenGL objects with owners. A context must be current wherever they are made, used or destroyed. Included
// by ui/render only.
#pragma once

#include <span>
#include <string_view>
#include <utility>

#include "core/base/error.h"

namespace posecoach::gl {

// One object's name, deleted with its owner.
class Handle {
 public:
  using Deleter = void (*)(unsigned);
  Handle() = default;
  Handle(unsigned id, Deleter deleter) : id_(id), deleter_(deleter) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)), deleter_(other.deleter_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(deleter_, other.deleter_);
    return *this;
  }
  ~Handle() {
    if (id_ != 0) deleter_(id_);
  }
  unsigned id() const { return id_; }

 private:
  unsigned id_ = 0;
  Deleter deleter_ = nullptr;
};

Handle make_buffer();
Handle make_vertex_array();
Handle make_texture();
Handle make_framebuffer();
Handle make_renderbuffer();

class Program {
 public:
  Program() = default;
  // Errors: Unsupported with the compiler's words.
  static Result<Program> make(std::string_view name, std::string_view vertex, std::string_view fragment);
  void use() const;
  int uniform(const char* name) const;

 private:
  explicit Program(Handle handle) : handle_(std::move(handle)) {}
  Handle handle_;
};

// Floats of one vertex or instance attribute within an array of structs.
struct Attribute {
  unsigned location;
  int floats;
  std::size_t offset;
};

// Uploads, replacing the old contents, and describes them for the bound vertex array; `divisor` 1 for
// instances.
void upload(const Handle& buffer, std::span<const std::byte> bytes);
void describe(const Handle& buffer, std::size_t stride, std::span<const Attribute> attributes,
              unsigned divisor, std::size_t first = 0);

// 8-bit RGBA, filtered linearly, clamped at the edge; contents undefined.
Handle make_rgba_texture(int width, int height);
// 8-bit coverage, all zero.
Handle make_coverage_texture(int width, int height);

}  // namespace posecoach::gl
