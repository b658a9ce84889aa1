#include "render/gl/renderer.h"

namespace flatray {

extern const Backend gl_backend = {
    "gl", "OpenGL by software Mesa, through OSMesa or else EGL",
    [](const BackendChoice& choice) { return gl::open_renderer("gl", choice); }};

}  // namespace flatray
