#pragma once
#include <string>

#include "render/view.h"
#include "support/pictures.h"

namespace flatray {

inline const View& view_called(const std::string& name) {
  for (const View* view : views())
    if (name == view->name) return *view;
  ADD_FAILURE() << "no view is called " << name;
  return *views().front();
}

/// The first frame by a view.
inline Image view_of(const Scene& scene, const std::string& name, const Vec2& point = {0, 0},
                     const Tracer* tracer = find_tracer("brute"),
                     const FrameOptions& options = {}) {
  const Timeline timeline(scene, scene.seed, 1);
  return draw_view({&view_called(name), point}, tracer, scene, at(timeline, 1), options);
}

/// Every centre of a picture from -4 to 4 against a rule of what `point` lights.
template <class Lit>
void expect_lit(const std::string& text, const Vec2& point, const Lit& lit) {
  const Image seen = view_of(scene_of(text), "visibility", point);
  ASSERT_GT(seen.width, 0);
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      const double side = 8.0 / seen.width;
      const Vec2 centre((x + 0.5) * side - 4, 4 - (y + 0.5) * side);
      EXPECT_EQ(seen.at(x, y)[0] == 255, lit(centre)) << centre.transpose();
    }
}

}  // namespace flatray
