#include "ui/render/gl/objects.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <string>
#include <vector>

namespace posecoach::gl {
namespace {

std::string info_log(unsigned object, void(APIENTRY* read)(GLuint, GLsizei, GLsizei*, GLchar*)) {
  std::string text(2000, '\0');
  GLsizei length = 0;
  read(object, static_cast<GLsizei>(text.size()), &length, text.data());
  text.resize(static_cast<std::size_t>(length));
  return text;
}

Result<Handle> compile(std::string_view name, unsigned kind, std::string_view source) {
  Handle shader(glCreateShader(kind), [](unsigned id) { glDeleteShader(id); });
  const char* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  glShaderSource(shader.id(), 1, &text, &length);
  glCompileShader(shader.id());
  GLint compiled = 0;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE)
    return fail(ErrorCode::Unsupported, "the graphics driver refuses the shader " + std::string(name) + ": " +
                                            info_log(shader.id(), glGetShaderInfoLog));
  return shader;
}

}  // namespace

Handle make_buffer() {
  unsigned id = 0;
  glGenBuffers(1, &id);
  return {id, [](unsigned i) { glDeleteBuffers(1, &i); }};
}
Handle make_vertex_array() {
  unsigned id = 0;
  glGenVertexArrays(1, &id);
  return {id, [](unsigned i) { glDeleteVertexArrays(1, &i); }};
}
Handle make_texture() {
  unsigned id = 0;
  glGenTextures(1, &id);
  return {id, [](unsigned i) { glDeleteTextures(1, &i); }};
}
Handle make_framebuffer() {
  unsigned id = 0;
  glGenFramebuffers(1, &id);
  return {id, [](unsigned i) { glDeleteFramebuffers(1, &i); }};
}
Handle make_renderbuffer() {
  unsigned id = 0;
  glGenRenderbuffers(1, &id);
  return {id, [](unsigned i) { glDeleteRenderbuffers(1, &i); }};
}

Result<Program> Program::make(std::string_view name, std::string_view vertex, std::string_view fragment) {
  Result<Handle> vertex_shader = compile(name, GL_VERTEX_SHADER, vertex);
  if (!vertex_shader) return tl::unexpected(vertex_shader.error());
  Result<Handle> fragment_shader = compile(name, GL_FRAGMENT_SHADER, fragment);
  if (!fragment_shader) return tl::unexpected(fragment_shader.error());
  Handle program(glCreateProgram(), [](unsigned id) { glDeleteProgram(id); });
  glAttachShader(program.id(), vertex_shader->id());
  glAttachShader(program.id(), fragment_shader->id());
  glLinkProgram(program.id());
  GLint linked = 0;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE)
    return fail(ErrorCode::Unsupported, "the graphics driver refuses the shader " + std::string(name) + ": " +
                                            info_log(program.id(), glGetProgramInfoLog));
  return Program(std::move(program));
}

void Program::use() const {
  glUseProgram(handle_.id());
}

int Program::uniform(const char* name) const {
  return glGetUniformLocation(handle_.id(), name);
}

void upload(const Handle& buffer, std::span<const std::byte> bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
}

void describe(const Handle& buffer, std::size_t stride, std::span<const Attribute> attributes,
              unsigned divisor, std::size_t first) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  for (const Attribute& attribute : attributes) {
    glEnableVertexAttribArray(attribute.location);
    glVertexAttribPointer(attribute.location, attribute.floats, GL_FLOAT, GL_FALSE,
                          static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(
                              first * stride + attribute.offset));  // NOLINT: OpenGL's way to say offset
    glVertexAttribDivisor(attribute.location, divisor);
  }
}

namespace {

Handle make_clamped_texture() {
  Handle texture = make_texture();
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

Handle make_rgba_texture(int width, int height) {
  Handle texture = make_clamped_texture();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  return texture;
}

Handle make_coverage_texture(int width, int height) {
  Handle texture = make_clamped_texture();
  const std::vector<unsigned char> zeros(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, zeros.data());
  return texture;
}

}  // namespace posecoach::gl
