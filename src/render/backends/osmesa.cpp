#include "render/gl/renderer.h"

namespace flatray::osmesa_backend {

extern const Backend entry = {
    "osmesa", "OpenGL by software Mesa, through OSMesa",
    [](const BackendChoice& choice) { return gl::open_renderer("osmesa", choice); }};

}  // namespace flatray::osmesa_backend
