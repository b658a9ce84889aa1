#pragma once
#include <span>
#include <vector>

#include "anim/world.h"
#include "scene/scatterer.h"
#include "transport/light/light_ray.h"

namespace flatray {

/// The closed shapes that light goes slower in, or gets fainter.
class Bodies {
 public:
  /// Needs   scatterers by surface; they and `world` outlive it.
  Bodies(const World& world, std::span<const Scatterer* const> scatterers);

  bool any() const { return !scatterers_.empty(); }
  /// Whether the index of any of them differs between wavelengths.
  bool disperse() const { return disperse_; }
  /// Whether light gets fainter in any of them.
  bool absorb() const { return absorb_; }
  /// Of the innermost of the bodies that light is in: Scatterer::absorption.
  const std::array<double, 3>& absorption_in(const Media& media) const {
    static constexpr std::array<double, 3> kNone{0, 0, 0};
    const std::uint32_t body = media.around(Media::kNone);
    return body == Media::kNone ? kNone : absorptions_[body];
  }
  /// What is left there after a length.
  std::array<double, 3> left_after(double length, const Media& media) const;
  /// By surface; Media::kNone for what is no wall of one.
  std::uint32_t of(std::uint32_t surface) const { return bodies_[surface]; }
  /// Of refraction, in the body of a wall.
  double index_in(std::uint32_t body, double nm) const { return scatterers_[body]->index(nm); }
  /// Of the innermost body around `body`, or of nothing.
  double index_around(const Media& media, std::uint32_t body, double nm) const {
    const std::uint32_t around = media.around(body);
    return around == Media::kNone ? 1 : scatterers_[around]->index(nm);
  }
  /// Whether light of all wavelengths must have one to go through a wall.
  bool disperse_at(std::uint32_t surface, const Media& media) const {
    const std::uint32_t body = of(surface), around = media.around(body);
    return disperse_ && body != Media::kNone &&
           (scatterers_[body]->disperses() ||
            (around != Media::kNone && scatterers_[around]->disperses()));
  }
  /// The bodies that a point lies in, those on whose walls it lies left out. Exact.
  Media around(const Vec2& point) const;

 private:
  bool holds(std::uint32_t body, const Vec2& point) const;

  const Surfaces& walls_;
  std::vector<std::uint32_t> bodies_;                 // by surface
  std::vector<const Scatterer*> scatterers_;          // by body
  std::vector<std::array<double, 3>> absorptions_;    // by body
  std::vector<std::vector<std::uint32_t>> surfaces_;  // by body
  std::vector<Bounds> bounds_;                        // by body
  std::vector<std::uint32_t> outermost_first_;
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
