#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "anim/rigid_motion.h"
#include "collide/contact.h"

namespace flatray {

/// All points within `radius` of a convex core that is carried along: a vertex p of it is where the
/// motion is + R(its angle) p.
struct TurningBody {
  /// The core as seen from where it turns about: convex but for rounding.
  std::span<const Vec2> ring;
  double radius = 0;
  RigidMotion motion{};
};

/// When two turning bodies first touch, as far as it is proven.
struct TurningContact {
  enum class Verdict : std::uint8_t {
    apart,     ///< at all times
    meets,     ///< first at one of the times in `first`
    undecided  ///< apart before and after `first`; within it they come too close to tell
  };
  Verdict verdict = Verdict::apart;
  Range first{0, 0};
  StartPlace start = StartPlace::outside;  ///< boundary: too close to tell
  /// Where they touch, or come closest, at first.low, and the unit normal there, out of the first;
  /// about. Of those that overlap from the start, of the shortest way apart.
  ContactPlace place{{0, 0}, {0, 0}};
};

/// The first touch for t in [from, length], or of the time run backwards from `length`: then the last.
///
/// Needs   finite numbers, 0 < length <= 128, radii not negative; from in [0, length), backwards 0.
/// Gives   Nothing touches before first.low, and they have an inner point in common at first.high.
///         The interval is `width` long, longer where rounding or a grazing leaves a doubt. It holds
///         for all motions within 2^-50 of the one given, relative to all that its formula adds up.
/// Error   proven: what is added up has bounds, nothing is sampled. Two points, a point and a
///         segment, and segments that stay parallel have no inner points: undecided where they meet.
/// Cost    some us: a handful of steps, each linear in edges times vertices; more where much spin
///         is to be followed close by. After kMostTurningSteps it is undecided to the end.
/// Source  conservative advancement by gaps along edges that turn with their body: from value, slope
///         and a bound of the curvature a gap is known to stay positive for a time, and at a simple
///         meeting such steps converge quadratically. What groups that turn add to the curvature adds
///         up over them: docs/NUMERICS.md.
TurningContact turning_contact(const TurningBody& a, const TurningBody& b, double length,
                               double width, bool backwards = false, double from = 0);

/// When two bodies that overlap at `from` are first known to be apart again, up to t = 1.
///
/// Needs   as turning_contact; from in [0, 1).
/// Gives   proven: until some kTurningWidth before they have inner points in common without a break but for
///         times of about that width that leave a doubt, and then they are apart. nullopt where they are
///         never known to be, or not after kMostPartingSteps.
/// Source  as turning_contact, with gaps that stay negative in place of such that stay positive.
std::optional<double> turning_parting(const TurningBody& a, const TurningBody& b, double from);

/// The same of the upright boxes around two bodies of several parts, all of one motion. Boxes without
/// area are undecided where they meet.
using TurningParts = std::vector<TurningBody>;
TurningContact turning_contact(const TurningParts& a, const TurningParts& b, double length,
                               double width, bool backwards = false, double from = 0);
std::optional<double> turning_parting(const TurningParts& a, const TurningParts& b, double from);

/// Width asked for the times of shapes that turn.
inline constexpr double kTurningWidth = 0x1p-40;
inline constexpr int kMostTurningSteps = 1 << 16;
inline constexpr int kMostPartingSteps = 1 << 12;

}  // namespace flatray
