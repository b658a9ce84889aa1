#pragma once
#include "anim/frame_state.h"

namespace flatray {

/// film_from_world of one frame: pixels, y down. The window has the film's aspect, so pixels are
/// square.
class FilmTransform {
 public:
  FilmTransform(const Film& film, const FrameState& state)
      : left_(state.window.low.x()),
        top_(state.window.high.y()),
        scale_(film.width / state.window.size().x()) {}

  Vec2 operator()(const Vec2& world) const {
    return {(world.x() - left_) * scale_, (top_ - world.y()) * scale_};
  }
  double scale() const { return scale_; }  ///< pixels in a world unit

 private:
  double left_, top_, scale_;
};

}  // namespace flatray
