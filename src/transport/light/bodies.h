#pragma once
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "anim/world.h"
#include "geom/box_tree.h"
#include "scene/scatterer.h"
#include "transport/light/light_ray.h"

namespace flatray {

/// The closed shapes that light goes slower in, or gets fainter.
///
/// Where several lie over one another, the smallest in area is the innermost, and of areas alike to
/// 2^-26 the last in the scene: so that of two bodies of which one lies in the other, it is that one,
/// and where they lie over one another in part, light goes the same way to and fro.
class Bodies {
 public:
  /// Needs   scatterers by surface; they and `world` outlive it.
  Bodies(const World& world, std::span<const Scatterer* const> scatterers);

  bool any() const { return !all_.empty(); }
  /// Whether the index of any of them differs between wavelengths.
  bool disperse() const { return disperse_; }
  /// Whether light gets fainter in any of them.
  bool absorb() const { return absorb_; }
  /// Of the innermost of the bodies that light is in: Scatterer::absorption.
  const std::array<double, 3>& absorption_in(const Media& media) const {
    static constexpr std::array<double, 3> kNone{0, 0, 0};
    const std::uint32_t body = media.around(Media::kNone);
    return body == Media::kNone ? kNone : all_[body].absorption;
  }
  /// What is left there after a length.
  std::array<double, 3> left_after(double length, const Media& media) const;
  /// By surface; Media::kNone for what is no wall of one. Numbers ascend from the outermost.
  std::uint32_t of(std::uint32_t surface) const { return bodies_[surface]; }
  /// Of refraction, in the body of a wall.
  double index_in(std::uint32_t body, double nm) const { return all_[body].scatterer->index(nm); }
  /// Of refraction, outside of a wall of `body`: that of the innermost body there, or of nothing. Where
  /// a wall lies within an inner body, light goes straight on: it is that of `body` itself.
  double index_around(const Media& media, std::uint32_t body, double nm) const {
    const std::uint32_t around = media.around(body);
    return around == Media::kNone ? 1 : index_in(std::min(around, body), nm);
  }
  /// Whether light of all wavelengths must have one to go through a wall.
  bool disperse_at(std::uint32_t surface, const Media& media) const {
    const std::uint32_t body = of(surface), around = media.around(body);
    if (!disperse_ || body == Media::kNone) return false;
    return around == Media::kNone ? disperses(body)
                                  : around < body && (disperses(body) || disperses(around));
  }
  /// The bodies that a point lies in, those on whose walls it lies left out. Exact.
  Media around(const Vec2& point) const;
  /// The bodies that a ray is in which sets off, or goes on, from a wall or from between them.
  Media at(const Ray& ray, const DepartedSurface& departed) const;

 private:
  struct Body {
    const Scatterer* scatterer;
    std::array<double, 3> absorption;
    std::vector<std::uint32_t> surfaces{};
    Bounds bounds{};
    std::pair<int, double> area{};  ///< the power of two it is below, and 2^26 of its parts
  };
  bool disperses(std::uint32_t body) const { return all_[body].scatterer->disperses(); }
  bool holds(const Body& body, const Vec2& point) const;

  const Surfaces& walls_;
  std::vector<std::uint32_t> bodies_;  // by surface
  std::vector<Body> all_;              // the outermost first
  BoxTree boxes_{{}};                  // of all_
  bool disperse_ = false, absorb_ = false;
};

/// What part of light is left after a length, and the mean of that over the length.
struct Fading {
  double left, mean;
};
/// Needs   both at least 0. Error   of either below 10^-12 of it.
Fading fading(double absorption, double length);

/// Whether a ray goes on inside a closed shape, having left a wall of it.
bool goes_inside(const Surfaces& walls, const DepartedSurface& departed, const Vec2& direction);

}  // namespace flatray
