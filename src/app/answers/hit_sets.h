#pragma once
#include <string>
#include <utility>
#include <vector>

#include "app/answers/hit_report.h"
#include "geom/interval_set.h"

namespace flatray {

/// What `flatray hit --op` may ask of the parts of a ray inside entities.
enum class HitOperation { in_any, in_all, in_first_alone };
inline constexpr std::pair<const char*, HitOperation> kHitOperations[] = {
    {"union", HitOperation::in_any},
    {"intersection", HitOperation::in_all},
    {"difference", HitOperation::in_first_alone}};

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
