#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "anim/responses.h"
#include "collide/box_grid.h"
#include "collide/outline_contact.h"

namespace flatray {

/// Which of many bodies may meet in a while, by the boxes they sweep, while some of them change their
/// ways.
///
/// Cost    that of a grid of boxes, made anew for each while.
class NearBodies {
 public:
  /// A box around each body as seen from its origin, empty for one that plays no part.
  explicit NearBodies(std::vector<Bounds> shapes) : shapes_(std::move(shapes)) {}

  /// A new while: from one time to another, the last of its stages what each body does at its beginning.
  void open(double from, double to, std::span<const std::vector<Stage>> stages);
  /// A body goes on by another stage from its time on.
  void change(std::uint32_t body, const Stage& stage) {
    ways_.change(body, way_of(body, stage, stage.from));
  }

  /// Calls `take(pair)` once for all pairs that may meet in the while as it was opened.
  template <class Take>
  void each_pair(const Take& take) {
    for (std::uint32_t i = 0; i < shapes_.size(); ++i)
      each_near(i, [&](std::uint32_t k) {
        if (k < i) take(IndexPair(k, i));
      });
  }
  /// Calls `take(k)` once for all others that a body may meet in the rest of the while.
  template <class Take>
  void each_near(std::uint32_t body, const Take& take) {
    ways_.each_near(ways_.boxes()[body], [&](std::uint32_t k) {
      if (k != body) take(k);
    });
  }

 private:
  Bounds way_of(std::uint32_t body, const Stage& stage, double from) const;

  const std::vector<Bounds> shapes_;
  BoxGrid ways_{{}};
  double to_ = 0;
};

/// Box around the parts of a body.
Bounds bounds_of(std::span<const ShapePart> parts);

}  // namespace flatray
