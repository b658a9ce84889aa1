#include "render/gl/renderer.h"

namespace flatray {

extern const Backend osmesa_backend = {
    "osmesa", "OpenGL by software Mesa, through OSMesa",
    [](const BackendChoice& choice) { return gl::open_renderer("osmesa", choice); }};

}  // namespace flatray
