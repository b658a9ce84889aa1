#include "render/gl/renderer.h"

namespace flatray::egl_backend {

extern const Backend entry = {
    "egl", "OpenGL by software Mesa, through EGL without a surface",
    [](const BackendChoice& choice) { return gl::open_renderer("egl", choice); }};

}  // namespace flatray::egl_backend
