#pragma once
#include "collide/meetings.h"
#include "support/pictures.h"

namespace flatray {

/// From the first frame of a scene to its last.
inline std::vector<Meeting> meetings(const Scene& scene, Outline outline = Outline::own) {
  return find_meetings(Timeline(scene, 0, scene.frames), scene.frames, outline).value();
}
inline std::vector<Meeting> meetings(const std::string& text, Outline outline = Outline::own) {
  return meetings(scene_of(text), outline);
}

}  // namespace flatray
