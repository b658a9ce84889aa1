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
    return {finite((world.x() - left_) * scale_), finite((top_ - world.y()) * scale_)};
  }
  /// A difference of points.
  Vec2 direction(const Vec2& world) const {
    return {finite(world.x() * scale_), finite(-world.y() * scale_)};
  }
  double length(double world) const { return finite(world * scale_); }  ///< in pixels
  /// World of the upper left corner, and pixels of a world unit.
  Vec2 corner() const { return {left_, top_}; }
  double scale() const { return scale_; }

 private:
  // What lies farther off, up to where a window of 1e-300 puts a world of 1e300, is drawn as if it
  // lay there; so written that a NaN is, too.
  static double finite(double px) {
    constexpr double kFarthest_px = 0x1p500;
    return px > -kFarthest_px ? (px < kFarthest_px ? px : kFarthest_px) : -kFarthest_px;
  }

  double left_, top_, scale_;
};

}  // namespace flatray
