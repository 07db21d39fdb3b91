#include "ui/render/osmesa_context.h"

#include <GL/osmesa.h>

#include <array>

namespace posecoach {
namespace {

class OsmesaContext : public OffscreenContext {
 public:
  explicit OsmesaContext(::OSMesaContext context) : context_(context) {}
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }

  Result<void> make_current() override {
    // The context's own frame buffer is never drawn into.
    if (OSMesaMakeCurrent(context_, own_buffer_.data(), GL_UNSIGNED_BYTE, 4, 4) == GL_FALSE)
      return fail(ErrorCode::Unsupported, "OSMesaMakeCurrent failed");
    return {};
  }
  std::string renderer_name() const override {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name == nullptr ? "unknown" : reinterpret_cast<const char*>(name);
  }

 private:
  ::OSMesaContext context_;
  std::array<unsigned char, 64> own_buffer_{};
};

}  // namespace

Result<std::unique_ptr<OffscreenContext>> make_osmesa_context() {
  constexpr std::array<int, 11> kAttributes = {OSMESA_FORMAT,
                                               OSMESA_RGBA,
                                               OSMESA_DEPTH_BITS,
                                               0,
                                               OSMESA_PROFILE,
                                               OSMESA_CORE_PROFILE,
                                               OSMESA_CONTEXT_MAJOR_VERSION,
                                               3,
                                               OSMESA_CONTEXT_MINOR_VERSION,
                                               3,
                                               0};
  ::OSMesaContext context = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
  if (context == nullptr) return fail(ErrorCode::Unsupported, "OSMesa has no OpenGL 3.3 core context");
  auto made = std::make_unique<OsmesaContext>(context);
  if (const Result<void> current = made->make_current(); !current) return tl::unexpected(current.error());
  return made;
}

}  // namespace posecoach
