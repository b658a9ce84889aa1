#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "anim/frame_state.h"
#include "base/table.h"
#include "geom/hit_interval.h"
#include "geom/interval_set.h"

namespace flatray {

/// A ray to clip and what it is called in tables.
struct NamedRay {
  std::string name;
  Ray ray;
  std::optional<Segment>
      edge{};  ///< whose ray it is: clipped as it is, without a rounded direction
};

/// One edge of a clip: a line of the paper's table 3.
struct HitStep {
  std::optional<int> edge;  ///< of the shape as given; nothing for a cut between its pieces
  double numerator, denominator;
  std::optional<double> t;  ///< not where parallel
  std::string exact_t;      ///< "19/72" where short
  const char* kind;         ///< entering, exiting, parallel
  Range candidate;          ///< the interval after this edge
  bool empty;               ///< the candidate is
};

/// One ray against one piece, circle, ellipse, curved part or segment of an entity.
struct HitReport {
  NamedRay ray;
  std::string against;  ///< "polygon", "castle piece 2", "disc circle 0", "pill part 0"
  Range within;
  std::vector<HitStep> steps;  ///< of pieces alone
  HitInterval hit;             ///< its edges are those of the shape as given
  std::string exact_enter, exact_exit;
};

/// Straight outline edges of an entity in the frame as rays whose t = 1 is the edge's end, by edge
/// number.
std::vector<NamedRay> edge_rays(const Scene& scene, const FrameState& state, std::uint32_t entity);

/// A ray against every piece, circle, ellipse and segment of an entity; of what arcs bound one
/// report for each part of the ray inside, or one that it misses.
std::vector<HitReport> hit_reports(const Scene& scene, const FrameState& state, const NamedRay& ray,
                                   std::uint32_t entity, Range within);

/// As `flatray hit` prints it: for people, as rows, as an object.
std::string text_of(const HitReport& report);
Table csv_rows(std::vector<HitReport> reports);
JsonValue as_value(const HitReport& report);
/// Of each ray the primitives it was clipped against and those it hits, the measure of the paper:
/// needs the reports of a ray one after the other.
Values primitives_hit(const std::vector<HitReport>& reports);

/// A diagram of clips: the entities asked about, every ray, and the part of it inside, thick, with
/// the times of its ends, where there is room. A ray without end stops at the edge of the picture.
std::string svg_of(const Scene& scene, const FrameState& state,
                   std::span<const std::uint32_t> entities, std::span<const HitReport> reports);

/// What `flatray hit --op` may ask of the parts of a ray inside entities.
using HitOperation = IntervalSet (*)(std::span<const Range> a, std::span<const Range> b);
inline constexpr std::pair<const char*, HitOperation> kHitOperations[] = {
    {"union", &union_of}, {"intersection", &intersection_of}, {"difference", &difference_of}};

/// The parts of one ray inside several entities, taken together.
struct HitSet {
  NamedRay ray;
  IntervalSet parts;
};

/// Needs   the reports of one ray, by entity, none of one that is not there; at least one entity.
/// Gives   where it is inside any entity, inside all, or inside the first and none of the others;
///         an entity is the union of its pieces. Closed sets, as interval_set says.
/// Error   each end is the double nearest to the exact one; parts and gaps shorter than an ulp of t
///         may be one point, or none.
HitSet combine(const NamedRay& ray, HitOperation operation,
               const std::vector<std::vector<HitReport>>& by_entity);

/// As `flatray hit --op` prints them: for people, as rows, as an object. Parts are ranges of t, their
/// length is in world units.
std::string text_of(const HitSet& set);
Table csv_rows(const std::vector<HitSet>& sets);
JsonValue as_value(const HitSet& set);

}  // namespace flatray
