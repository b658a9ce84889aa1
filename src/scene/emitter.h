#pragma once
#include <memory>
#include <optional>

#include "geom/bounds.h"
#include "scene/scene.h"

namespace flatray {

/// How a ray leaves a lamp, in coordinates of the lamp: at angle 0 it looks along x.
struct Emitted {
  Vec2 at{0, 0};
  Vec2 direction{1, 0};  ///< of length 1
};

/// What a point sees of a lamp whose light comes to it from one direction.
struct Sight {
  Vec2 from;       ///< where that light has left the lamp
  double fluence;  ///< of power 1
};

/// A lamp that is a line, as bright from all directions on a side of it that shines.
struct LampLine {
  Segment ends;                  ///< along an arc counter-clockwise
  std::optional<Circle> circle;  ///< that it is a part of; none: it is straight
  bool whole = false;            ///< all of the circle
  double length = 0;
  bool left = true, right = false;  ///< which sides shine; the left of an arc is towards the centre
};

/// Sends out rays that all carry the same power.
class Emitter {
 public:
  virtual ~Emitter() = default;
  /// Needs   `u`: as many numbers as LampType::numbers says, in [0, 1), angles first, then places.
  virtual Emitted emit(const double* u) const = 0;
  /// Of lamps that LampType::seen calls `points`; none where no light comes to `at`.
  virtual std::optional<Sight> sight(const Vec2& /*at*/) const { return std::nullopt; }
  /// Whether all its light leaves as one ray: no point sees it but by chance.
  virtual bool is_one_ray() const { return false; }
  /// Of lamps that LampType::seen calls `line`.
  virtual std::optional<LampLine> line() const { return std::nullopt; }
  /// Where its rays set off, of lamps whose rays set off from a line.
  virtual std::optional<LampLine> starts() const { return line(); }
  /// About what part of the places in a room so wide sees it, or of the paths through the room meets it.
  virtual double seen_part(double /*room*/) const { return 1; }
};

inline constexpr unsigned kMostLampNumbers = 5;

/// The emitter of a lamp at a time in seconds; none where its numbers then leave nothing.
std::unique_ptr<const Emitter> emitter_at(const Scene& scene, const Lamp& lamp, double time);

}  // namespace flatray
