#pragma once
#include <optional>
#include <vector>

#include "anim/world.h"

namespace flatray {

/// What of a frame has an inside that rays bounce in or off: chambers, their pillars, and entities
/// with a material.
class Solids {
 public:
  Solids(const Scene& scene, const FrameState& state);

  /// The first entity or pillar that holds a point. Closed and exact for the doubles of the world.
  std::optional<SurfaceOwner> holder(const Vec2& point) const;
  /// Whether a chamber holds it; true for scenes without one, and where one is lines alone, which has no
  /// inside.
  bool in_chamber(const Vec2& point) const;

  bool has_chamber() const { return !chambers_.empty(); }
  /// Of the chambers less that of their pillars, which must lie apart inside them; of those in copies once.
  double free_area() const;
  /// Of one of these pillars.
  double pillar_area(std::uint32_t chamber, std::uint32_t pillar) const;

 private:
  struct Solid {
    SurfaceOwner owner;
    std::vector<std::vector<Vec2>> pieces;  // convex, counter-clockwise
    std::vector<Circle> circles;
    std::vector<ArcPath> paths;  // closed, in the world
    World outline;               // of these
    bool copy = false;           // of another pillar, so that its area is counted
    bool holds(const Vec2& point) const;
    double area() const;
  };
  static Solid solid(const Shape& shape, const Pose& place, const SurfaceOwner& owner);

  std::vector<Solid> chambers_, obstacles_;
};

}  // namespace flatray
