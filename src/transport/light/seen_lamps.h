#pragma once
#include <memory>
#include <span>
#include <vector>

#include "anim/lamps.h"
#include "transport/light/lit_walls.h"

namespace flatray {

using LightSum = std::array<double, 3>;

/// Of a lamp whose rays set off from a line, the segments and circles that it lies along but for rounding.
WallsBeside walls_beside(const LampState& lamp, const Surfaces& walls);
std::vector<WallsBeside> walls_beside(std::span<const LampState> lamps, const Surfaces& walls);

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
  /// What part of the light that left a lamp at `from` comes to the start of a ray that looks there,
  /// at t = 1, given the first wall the ray meets: at most `most` walls may let some of it pass.
  std::array<float, 3> passes(const Vec2& from, const Ray& ray, const DepartedSurface& departed,
                              const NearestHit& hit, std::uint32_t most) const;

  /// Whether any lamp is a line.
  bool any_lines() const { return lines_.size() != 0; }
  /// Adds the light of lines that each ray crosses up to its wall: radiance, power per length and
  /// radian.
  void add_lines(std::span<const LightRay> rays, std::span<const LightHit> met,
                 std::span<LightSum> radiance) const;

 private:
  struct Glow {
    LightSum radiance;
    bool left, right;
  };
  std::span<const LampState> lamps_;
  const LitWalls& walls_;
  Surfaces lines_;
  std::vector<Glow> glows_;  // by line
  std::unique_ptr<Accelerator> tracer_;
};

}  // namespace flatray
