#include <memory>
#include <stdexcept>

#include "render/gl/module/maker.h"

#ifdef FLATRAY_HAVE_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

namespace flatray::gl {

#ifdef FLATRAY_HAVE_EGL
namespace {

struct Functions {
  const InstalledLibrary library{"libEGL.so.1", "libegl1 and libegl-mesa0"};
  decltype(&eglGetProcAddress) function =
      library.find<decltype(eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglInitialize) initialise = library.find<decltype(eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) bind_api = library.find<decltype(eglBindAPI)>("eglBindAPI");
  decltype(&eglChooseConfig) choose_config =
      library.find<decltype(eglChooseConfig)>("eglChooseConfig");
  decltype(&eglCreateContext) create = library.find<decltype(eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy =
      library.find<decltype(eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current = library.find<decltype(eglMakeCurrent)>("eglMakeCurrent");
  decltype(&eglReleaseThread) release_thread =
      library.find<decltype(eglReleaseThread)>("eglReleaseThread");
  PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display = library.needed(
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(function("eglGetPlatformDisplayEXT")));
};

class EglContext final : public Maker::Context {
 public:
  EglContext(const Functions& functions, EGLDisplay display, EGLContext context)
      : functions_(functions), display_(display), context_(context) {}
  ~EglContext() override { functions_.destroy(display_, context_); }

  bool enter() override {
    return functions_.bind_api(EGL_OPENGL_API) == EGL_TRUE &&
           functions_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  void leave() override {
    functions_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    functions_.release_thread();
  }

 private:
  const Functions& functions_;
  EGLDisplay display_;
  EGLContext context_;
};

// The display is one for the whole process, and others may have contexts of it: it is never
// terminated.
class EglMaker final : public Maker {
 public:
  EglMaker()
      : display_(functions_.platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY,
                                             nullptr)) {
    if (display_ == EGL_NO_DISPLAY || functions_.initialise(display_, nullptr, nullptr) != EGL_TRUE)
      throw std::runtime_error("EGL opens no surfaceless display: install libegl-mesa0");
  }

  const char* name() const override { return "EGL"; }
  std::unique_ptr<Context> create() override {
    constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                  EGL_NONE};
    constexpr EGLint kContext[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   3,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   3,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (functions_.bind_api(EGL_OPENGL_API) == EGL_TRUE &&
        functions_.choose_config(display_, kConfig, &config, 1, &count) == EGL_TRUE && count == 1)
      if (EGLContext context = functions_.create(display_, config, EGL_NO_CONTEXT, kContext))
        return std::make_unique<EglContext>(functions_, display_, context);
    throw std::runtime_error("EGL makes no context of OpenGL 3.3");
  }
  void* function(const char* name) const override {
    return reinterpret_cast<void*>(functions_.function(name));
  }

 private:
  const Functions functions_{};
  const EGLDisplay display_;
};

}  // namespace

std::unique_ptr<Maker> open_egl() { return std::make_unique<EglMaker>(); }
#else
std::unique_ptr<Maker> open_egl() {
  throw std::runtime_error(
      "EGL is not in this build: install libegl-dev and libegl-mesa0 and build again");
}
#endif

}  // namespace flatray::gl
