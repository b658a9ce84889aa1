#pragma once
#include <set>

#include "scene/keys/build_scene.h"
#include "scene/keys/builder.h"

namespace flatray {

/// Builds a shape of which some numbers are curves, `arguments` the table of its kind; nullopt where
/// it is wrong at a key of a curve, or in a frame up to the last key, were it beyond the last one of
/// the scene.
///
/// Cost    a shape for each key, and where several numbers change, or nothing is there at a key, or the
///         kind says so (ShapeType), for each frame between the first key and the last: LoadLimits::max_corners
///         corners in all shapes together.
std::optional<ShapeId> build_changing_shape(Builder& builder, const ShapeType& type,
                                            const Field& arguments);

/// Whether `holds(time)` in every frame between the first of `times` and the last, whichever is asked for; ends
/// with the first in which it does not.
template <class Holds>
bool holds_in_frames_between(const std::set<double>& times, double fps, const Holds& holds) {
  for (unsigned frame = 1; frame <= kLastFrame && !times.empty(); ++frame) {
    const double time = (frame - 1) / fps;
    if (time >= *times.rbegin()) return true;
    if (time > *times.begin() && !holds(time)) return false;
  }
  return true;
}

/// The shape at a time in seconds; without anything in it where its numbers leave nothing.
Shape shape_at(const Scene& scene, const ChangingShape& changing, double time);

}  // namespace flatray
