#pragma once
#include <memory>

#include "render/backend.h"

namespace flatray::gl {

/// The renderer behind the back ends gl, osmesa and egl. `maker`: "osmesa", "egl", or "gl" for the first of
/// these that works.
Result<std::unique_ptr<Renderer>> open_renderer(const char* maker, const BackendChoice& choice);

}  // namespace flatray::gl
