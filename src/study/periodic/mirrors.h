#pragma once
#include <string>

#include "geom/enclosure.h"
#include "study/periodic/isometry.h"
#include "study/rooms/room.h"

namespace flatray {

/// A wall that closed orbits may bounce off.
struct Mirror {
  std::uint32_t surface;
  std::optional<Sign>
      side;  ///< where orbits are, as geom/primitives/wall.h has sides; none: on both
  Segment line{};
  std::optional<Arc> arc{};  ///< instead of the line

  /// A circle, or a part of one, that orbits meet from outside alone.
  bool is_disc() const { return arc && arc->curve.is_circle() && side == Sign::positive; }
  /// Whether an orbit may bounce off it twice in turn.
  bool may_repeat() const { return arc && !is_disc(); }
};

/// Walls in the order in which an orbit bounces off them, by their number among the mirrors.
using Word = std::vector<std::uint8_t>;

/// The walls of a room as periodic orbits are looked for among them.
struct MirrorRoom {
  const Room& room;
  std::vector<Mirror> mirrors;

  /// Error   Bezier curves, more than 64 mirrors, or none.
  static Result<MirrorRoom> of(const Room& room);

  /// "1213", or "1.12.3" where there are more than nine mirrors.
  std::string text(const Word& word) const;
};

/// Whether something can be shown to be so, or not to be so.
enum class Proof : std::uint8_t { no, yes, open };

/// The sign of an enclosure as a proof of `positive`.
inline Pair<Near> near(const Vec2& v) { return {v.x(), v.y()}; }
inline Vec2 middle(const Pair<Near>& point) { return {point.x.value(), point.y.value()}; }
inline Proof is_positive(const Near& number) {
  const auto sign = number.sign();
  return !sign ? Proof::open : *sign == Sign::positive ? Proof::yes : Proof::no;
}
inline Proof operator!(Proof a) {
  return a == Proof::open ? a : a == Proof::yes ? Proof::no : Proof::yes;
}
inline Proof operator&(Proof a, Proof b) {
  if (a == Proof::no || b == Proof::no) return Proof::no;
  return a == Proof::yes && b == Proof::yes ? Proof::yes : Proof::open;
}
inline Proof operator|(Proof a, Proof b) { return !((!a) & (!b)); }
/// Whether one is positive and the other negative.
inline Proof are_opposite(const Near& a, const Near& b) {
  return (is_positive(a) & is_positive(-b)) | (is_positive(-a) & is_positive(b));
}

/// Whether a point of an arc's curve, given by an enclosure, lies on the arc, off its ends.
Proof lies_on(const Arc& arc, const Pair<Near>& point);

/// A straight part of an orbit; at its ends it may stand on surfaces.
struct Chord {
  Pair<Near> from, to;
  std::uint32_t from_surface = kNoSurface, to_surface = kNoSurface;
};
/// Whether a wall that it does not stand on, or stands on and meets again, is in its way.
Proof is_met(const Surfaces& walls, std::uint32_t surface, const Chord& chord);
/// Whether nothing is in its way.
Proof is_free(const Surfaces& walls, const Chord& chord);

}  // namespace flatray
