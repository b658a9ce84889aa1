#pragma once
#include "anim/frame_state.h"

namespace flatray {

/// Box around everything a frame shows, strokes of world width included. Empty for a scene without
/// content.
Bounds content_bounds(const Scene& scene, const std::vector<EntityState>& entities);

/// Whether the window is made of the content: nothing else says where or how large it is.
bool is_window_of_content(const Scene& scene);

/// World shown at `time`, of the film's aspect, where the followed entity stands at `followed`.
///
/// Gives   the size of camera.height, else of film.world, else of the content and 5 % on each side,
///         divided by camera.zoom;
///         centred on the followed entity, else on camera.at, else where film.world or the content
///         is. Without curves the size is the same at all times: only `low` moves and `high` goes
///         with it.
Bounds camera_window(const Timeline& timeline, double time, const Vec2& followed);

}  // namespace flatray
