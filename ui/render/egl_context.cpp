#include "ui/render/egl_context.h"

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <array>
#include <cstdio>

namespace posecoach {
namespace {

tl::unexpected<Error> egl_failure(const char* call) {
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "0x%04x", static_cast<unsigned>(eglGetError()));
  return fail(ErrorCode::Unsupported, std::string("drawing without a window is not possible here: ") + call +
                                          " failed with EGL error " + code.data() +
                                          "; install Mesa (libegl-mesa0, libgl1-mesa-dri)");
}

class EglContext : public OffscreenContext {
 public:
  EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    // The display is one for the whole process; others may still use it.
  }

  Result<void> make_current() override {
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      return egl_failure("eglMakeCurrent");
    return {};
  }
  std::string renderer_name() const override {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name == nullptr ? "unknown" : reinterpret_cast<const char*>(name);
  }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

}  // namespace

Result<std::unique_ptr<OffscreenContext>> make_egl_context() {
  EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display == EGL_NO_DISPLAY) return egl_failure("eglGetPlatformDisplay");
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return egl_failure("eglInitialize");
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return egl_failure("eglBindAPI");
  constexpr std::array<EGLint, 5> kConfig = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                             EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  // Without a surface any configuration will do; some drivers have none at all.
  if (eglChooseConfig(display, kConfig.data(), &config, 1, &count) == EGL_FALSE || count == 0)
    config = EGL_NO_CONFIG_KHR;
  constexpr std::array<EGLint, 7> kContext = {EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, kContext.data());
  if (context == EGL_NO_CONTEXT) return egl_failure("eglCreateContext (OpenGL 3.3)");
  auto made = std::make_unique<EglContext>(display, context);
  if (const Result<void> current = made->make_current(); !current) return tl::unexpected(current.error());
  return made;
}

}  // namespace posecoach
