#include "render/gl/renderer.h"

namespace flatray {

extern const Backend egl_backend = {
    "egl", "OpenGL by software Mesa, through EGL without a surface",
    [](const BackendChoice& choice) { return gl::open_renderer("egl", choice); }};

}  // namespace flatray
