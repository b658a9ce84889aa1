#pragma once
#include <memory>
#include <span>
#include <vector>

#include "anim/lamps.h"
#include "transport/light/lit_walls.h"

namespace flatray {

using LightSum = std::array<double, 3>;

/// The lamps of a frame as paths from pixels find them.
class SeenLamps {
 public:
  /// Needs   lamps that can be seen, and walls; both outlive it.
  SeenLamps(std::span<const LampState> lamps, const LitWalls& walls);

  /// Light of lamp `lamp` that comes to a point from one direction, if nothing is in the way.
  struct Sighted {
    Vec2 from;  ///< where it left the lamp, in the world
    LightSum fluence;
  };
  std::size_t size() const { return lamps_.size(); }
  std::optional<Sighted> sight(std::size_t lamp, const Vec2& at) const;
  /// Whether light from a lamp reaches the far end, at t = 1, of a ray that looks towards it, given
  /// the first wall the ray meets; and what part of it, through walls that let it pass.
  std::array<float, 3> passes(std::size_t lamp, const Ray& ray, const Left& left,
                              const NearestHit& hit) const;

  /// Whether any lamp is a line.
  bool any_lines() const { return lines_.size() != 0; }
  /// Adds the light of lines that each ray crosses up to its wall: radiance, power per length and
  /// radian.
  void add_lines(std::span<const LightRay> rays, std::span<const LightLanding> landings,
                 std::span<LightSum> radiance) const;

 private:
  bool ends_at(std::size_t lamp, const Ray& ray, const NearestHit& hit) const;

  struct Glow {
    LightSum radiance;
    bool left, right;
  };
  std::span<const LampState> lamps_;
  const LitWalls& walls_;
  std::vector<std::vector<std::uint32_t>> stood_on_;  // walls, by lamp
  Surfaces lines_;
  std::vector<Glow> glows_;  // by line
  std::unique_ptr<Accelerator> tracer_;
};

}  // namespace flatray
