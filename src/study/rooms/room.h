#pragma once
#include "anim/solids.h"
#include "study/experiment.h"
#include "study/rooms/wall_places.h"
#include "transport/fast_orbits.h"

namespace flatray {

/// The walls of a scene's first frame, ready for orbits of an experiment.
class Room {
 public:
  /// Needs   `scene` to outlive it.
  explicit Room(const Scene& scene);
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;

  const Scene& scene() const { return scene_; }
  const Surfaces& walls() const { return world_.surfaces; }
  const SurfaceOwner& owner(std::uint32_t surface) const { return world_.owner(surface); }
  const FrameState& state() const { return state_; }
  const Solids& solids() const { return solids_; }
  const WallPlaces& places() const { return places_; }
  const OrbitTracer& orbits() const { return *orbits_; }
  const FastOrbits& fast_orbits() const { return *fast_; }
  const std::vector<Material>& materials() const { return materials_; }  ///< by surface

  /// Whether orbits that start there are in the room: on a wall, or in the free or in glass.
  bool has_start(const Vec2& point) const;
  bool is_free(const Vec2& point) const;

  /// Of the free part (Solids::free_area), and of pillars of glass times their index: what flights
  /// are spread over evenly, as their places and momenta are.
  double area() const;
  /// At glass: the index on the side of a bounce over that beyond.
  double index_ratio(const Bounce& bounce) const;

  /// Length of all walls but periodic ones, those bounced off on both sides twice, of glass each
  /// side times the index there, those in copies once.
  double perimeter() const { return before_.back(); }
  /// How far along all of them a bounce lies: with the sine of its angle, what bounces are spread
  /// over evenly, whatever they are reflected by or split.
  double place_of(const Bounce& bounce) const;

  /// A start on a wall such that bounces along its orbit have the measure that reflection keeps:
  /// uniform in length of wall, as perimeter() has it, and in the sine of the angle. One for each
  /// number under one seed; quasi-random ones are spread evenly in both (study/rooms/starts.h).
  OrbitStart draw_start(std::uint64_t seed, std::uint64_t number,
                        Starts starts = Starts::random) const {
    return draw_start_in({0, perimeter()}, seed, number, starts);
  }
  /// The same on a hole alone.
  OrbitStart draw_entry(std::uint32_t hole, std::uint64_t seed, std::uint64_t number) const {
    return draw_start_in({before_[hole], before_[hole + 1]}, seed, number, Starts::random);
  }
  /// The side of a wall on which orbits are (geom/primitives/wall.h); nullopt: both.
  std::optional<Sign> inner_side(std::uint32_t surface) const;
  /// A start in the free part of a closed chamber, uniform in place and direction: the measure that
  /// flight keeps, so that what is seen along its orbit does not depend on the time. Of speed 1.
  OrbitStart draw_free_start(std::uint64_t seed, std::uint64_t number) const;

 private:
  struct Stretch {
    double from, to;  // of all walls, by length
  };
  OrbitStart draw_start_in(const Stretch& walls, std::uint64_t seed, std::uint64_t number,
                           Starts starts) const;
  std::uint32_t counted_wall(std::uint32_t surface) const;
  std::array<double, 2> weights_of(std::uint32_t surface) const;
  std::uint64_t chance_of(std::uint64_t seed, std::uint64_t number) const {
    return glass_.any() ? chance_of_orbit(seed, number) : 0;
  }
  std::uint32_t wall_in_cell(std::uint32_t surface, double position) const;

  const Scene& scene_;
  FrameState state_;
  World world_ = build_world(scene_, state_);
  Glass glass_{scene_, world_};
  Solids solids_{scene_, state_};
  WallPlaces places_{walls()};
  std::vector<Material> materials_ = world_.materials();
  std::vector<std::array<double, 2>> weights_;  // by surface, of its positive side and the other
  std::vector<double> before_{0};               // length of the walls before each
  std::vector<std::uint32_t> counted_;          // by surface: itself, or that of which it is a copy
  bool has_copies_ = false;
  std::unique_ptr<OrbitTracer> orbits_;
  std::unique_ptr<FastOrbits> fast_;
};

/// What has just left a wall by a bounce.
DepartedSurface departed_by(const Surfaces& walls, const Bounce& bounce);
/// The place nearest to one near a wall that does not lie behind it, seen from a side; nullopt
/// where doubles have none nearby.
std::optional<Vec2> in_front_of(const Surfaces& walls, std::uint32_t surface, Sign side,
                                const Vec2& place);
/// What experiments look at that are means over orbits of starts drawn in a room.
inline constexpr ExperimentUses kUsesOfOrbitMeans{.count = true,
                                                  .bounces = true,
                                                  .seed = true,
                                                  .starts = true,
                                                  .resume = true,
                                                  .precision = true,
                                                  .field = true,
                                                  .glass = true};

/// Whether orbits stay within a scene: one chamber, and mirrors alone.
Result<void> expect_closed(const ExperimentContext& context);
/// Whether they leave by holes of the chamber alone, and there are some.
Result<void> expect_holes(const ExperimentContext& context);
/// Refused where opposite walls are one, by what asks where exact orbits or straight lines go.
Result<void> expect_not_periodic(const ExperimentContext& context);
/// Whether it has walls at all.
Result<void> expect_walls(const ExperimentContext& context, const Room& room);

/// The entity, chamber or pillar that a wall is of, as scene/names.h has it.
std::string owner_name(const Scene& scene, const SurfaceOwner& owner);
/// Orbits an experiment looks at one by one: the rays of the scene, or drawn ones where it has
/// none, of quasi-random starts all under one shift.
///
/// Error   no walls; a ray that starts in an obstacle, or outside the chamber: nothing is measured
///         of it.
struct NamedOrbits {
  std::vector<std::string> names;
  std::vector<OrbitStart> starts;
  bool random = false;
};
Result<NamedOrbits> orbits_to_watch(const ExperimentContext& context, const Room& room,
                                    std::uint64_t random_orbits);
/// Orbits that `count` bounces make, and how many each has.
struct OrbitPlan {
  std::uint64_t orbits, bounces;
};
/// Error   too few orbits for their error to be known.
Result<OrbitPlan> plan_orbits(const ExperimentContext& context, std::uint64_t usual_bounces);

}  // namespace flatray
