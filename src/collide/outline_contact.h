#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "anim/frame_state.h"
#include "collide/contact.h"
#include "geom/primitives/arc.h"

namespace flatray {

/// A shape that moves along a straight line.
struct MovingShape {
  const Shape* shape;
  Pose place;  ///< at t = 0
  Vec2 velocity;
};

/// What stands for an entity: its own outline, or the upright box around it at each time.
enum class Outline : std::uint8_t { own, box };

/// The convex parts of a shape as placed: pieces, segments, discs, capsules, ellipses.
struct ShapePart {
  std::vector<Vec2> ring;
  double radius = 0;
  std::optional<Ellipse> curve{};     ///< an ellipse that is no circle, instead of the others
  std::vector<std::uint32_t> cuts{};  ///< edges of the ring that only part it from another piece
};
bool has_area(const ShapePart& part);
/// Of the upright box around a shape one part, none of an empty one.
std::vector<ShapePart> parts_of(const Shape& shape, const Pose& place,
                                Outline outline = Outline::own);

/// A time in which two shapes have a point in common.
struct MeetingPart {
  Range times;
  HitClass kind;
  StartPlace start;  ///< how they lie at t = 0
  Vec2 point;        ///< where they first meet in this part, about; of an overlap a vertex inside
  Vec2 normal;  ///< unit, out of the first shape; of those that meet from the start that of the
                ///< shortest way apart, of outlines in pieces that of the first two pieces alone
  double width = 0;     ///< of turning shapes and ellipses: they first touch in [low, low + width]
  bool certain = true;  ///< false: they come too close to tell whether they touch
};

/// A part of which it is proven when it begins, within `width`, and that it meets, if it is `certain`.
MeetingPart proven_part(Range times, StartPlace start, const ContactPlace& place, double width,
                        bool certain);
/// One of which nothing is known.
inline MeetingPart undecided_part(Range times) {
  return proven_part(times, StartPlace::boundary, {{0, 0}, {0, 0}}, times.high - times.low, false);
}
/// Adds a part that begins no earlier than those before: to the last of them where it begins before that ends.
/// Whether it is one more.
bool add_part(std::vector<MeetingPart>& parts, const MeetingPart& next);
/// Sorts parts by time, and makes one of those that overlap.
void join(std::vector<MeetingPart>& parts);

/// When two parts meet within a range, in linear motion, of which one at least is an ellipse; nullopt where
/// they never do.
///
/// Needs   ellipses of finite half-diameters with an area.
/// Gives   proven: the polygons in and about an ellipse, curved_contact.h, meet exactly when contact() says.
///         What the two do not tell alike is not `certain`.
/// Error   they are made finer where the outer ones first and last meet, until what they differ by is lost
///         in the rounding of their corners: some 2^-38 of what coordinates and half-diameters add up to,
///         more for thin ellipses, over the speed along the normal.
/// Cost    some 0.3 ms.
std::optional<MeetingPart> curved_parts_meet(const ShapePart& a, const Vec2& velocity_a,
                                             const ShapePart& b, const Vec2& velocity_b,
                                             Range within);

/// Every time within a range in which two shapes meet, ascending and apart: the times of their
/// convex pieces, segments and discs together.
///
/// Gives   kind: through where any pieces overlap, also only on a cut between two of them, else along
///         where any touch for a while.
/// Error   as contact(); of ellipses as curved_parts_meet(); other arcs are left out.
std::vector<MeetingPart> shapes_meet(const MovingShape& a, const MovingShape& b, Range within,
                                     Outline outline = Outline::own);

/// The same of each of many pairs of bodies.
///
/// Needs   pairs of numbers of bodies, in any order.
/// Cost    each body is made ready once; parts are asked together, contact_batch.h, where their boxes meet,
///         near_parts.h. Memory is that of the bodies and of what meets.
std::vector<std::vector<MeetingPart>> pairs_meet(std::span<const MovingShape> bodies,
                                                 std::span<const IndexPair> pairs, Range within,
                                                 unsigned threads, Outline outline = Outline::own);

}  // namespace flatray
