#include "base/shared_library.h"
#include "render/gl/module/maker.h"

#ifdef FLATRAY_HAVE_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

namespace flatray::gl {

#ifdef FLATRAY_HAVE_EGL
namespace {

struct Functions {
  decltype(&eglGetProcAddress) function;
  decltype(&eglInitialize) initialise;
  decltype(&eglBindAPI) bind_api;
  decltype(&eglChooseConfig) choose_config;
  decltype(&eglCreateContext) create;
  decltype(&eglDestroyContext) destroy;
  decltype(&eglMakeCurrent) make_current;
  decltype(&eglReleaseThread) release_thread;
  PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display = nullptr;

  explicit Functions(const SharedLibrary& library)
      : function(library.find<decltype(eglGetProcAddress)>("eglGetProcAddress")),
        initialise(library.find<decltype(eglInitialize)>("eglInitialize")),
        bind_api(library.find<decltype(eglBindAPI)>("eglBindAPI")),
        choose_config(library.find<decltype(eglChooseConfig)>("eglChooseConfig")),
        create(library.find<decltype(eglCreateContext)>("eglCreateContext")),
        destroy(library.find<decltype(eglDestroyContext)>("eglDestroyContext")),
        make_current(library.find<decltype(eglMakeCurrent)>("eglMakeCurrent")),
        release_thread(library.find<decltype(eglReleaseThread)>("eglReleaseThread")) {
    if (function != nullptr)
      platform_display =
          reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(function("eglGetPlatformDisplayEXT"));
  }
  bool complete() const {
    return function && initialise && bind_api && choose_config && create && destroy &&
           make_current && release_thread && platform_display;
  }
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
  EglMaker(const Functions& functions, EGLDisplay display)
      : functions_(functions), display_(display) {}

  const char* name() const override { return "EGL"; }
  std::unique_ptr<Context> create(std::string& error) override {
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
    error = "EGL makes no context of OpenGL 3.3";
    return nullptr;
  }
  void* function(const char* name) const override {
    return reinterpret_cast<void*>(functions_.function(name));
  }

 private:
  const Functions functions_;
  EGLDisplay display_;
};

}  // namespace

std::unique_ptr<Maker> open_egl(std::string& error) {
  const SharedLibrary library("libEGL.so.1");
  error = library.problem() + ": install libegl1 and libegl-mesa0";
  if (!library) return nullptr;
  error = "libEGL.so.1 lacks what flatray calls: install libegl1 and libegl-mesa0";
  const Functions functions(library);
  if (!functions.complete()) return nullptr;
  error = "EGL opens no surfaceless display: install libegl-mesa0";
  EGLDisplay display =
      functions.platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || functions.initialise(display, nullptr, nullptr) != EGL_TRUE)
    return nullptr;
  return std::make_unique<EglMaker>(functions, display);
}
#else
std::unique_ptr<Maker> open_egl(std::string& error) {
  error = "EGL is not in this build: install libegl-dev and libegl-mesa0 and build again";
  return nullptr;
}
#endif

}  // namespace flatray::gl
