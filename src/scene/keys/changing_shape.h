#pragma once
#include "scene/keys/builder.h"

namespace flatray {

/// Builds a shape of which some numbers are curves, `arguments` the table of its kind; nullopt where
/// it is wrong at a key of a curve, or in a frame up to the last key, were it beyond the last one of
/// the scene.
///
/// Cost    a shape for each key, and where several numbers change, or nothing is there at a key, for
///         each frame between the first key and the last: LoadLimits::max_corners corners in all
///         shapes together.
std::optional<ShapeId> build_changing_shape(Builder& builder, const ShapeType& type,
                                            const Field& arguments);

/// The shape at a time in seconds; without anything in it where its numbers leave nothing.
Shape shape_at(const Scene& scene, const ChangingShape& changing, double time);

}  // namespace flatray
