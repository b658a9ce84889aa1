#include "render/gl/renderer.h"

namespace flatray::gl_backend {

extern const Backend entry = {
    "gl", "OpenGL by software Mesa, through OSMesa or else EGL",
    [](const BackendChoice& choice) { return gl::open_renderer("gl", choice); }};

}  // namespace flatray::gl_backend
