#include <algorithm>

#include "study/periodic/closed_orbits.h"

namespace flatray {
namespace {

constexpr int kMostSweeps = 4000, kHalvings = 60;

struct Touched {
  Vec2 point;
  bool passed;  // the straight line from a to b goes through the disc
};

// The point of a filled disc by which the way from a to b is shortest: between the directions to
// both, halved until its derivative vanishes.
Touched nearest_touch(const Circle& disc, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a, to = disc.centre - a;
  const double size = way.squaredNorm();
  const Vec2 foot = a + (size > 0 ? std::clamp(to.dot(way) / size, 0.0, 1.0) : 0) * way;
  if ((foot - disc.centre).squaredNorm() < disc.radius * disc.radius) return {foot, true};
  Vec2 low = direction_of(a - disc.centre), high = direction_of(b - disc.centre), middle = low;
  for (int i = 0; i < kHalvings; ++i) {
    middle = direction_of(low + high);
    const Vec2 point = disc.centre + disc.radius * middle;
    const double slope = cross(middle, direction_of(a - point) + direction_of(b - point));
    // Where it is closer to turn to b, `low` is on the side of a.
    ((slope > 0) == (cross(low, high) > 0) ? low : high) = middle;
  }
  return {disc.centre + disc.radius * middle, false};
}

// Goes to the shortest closed polygon, disc by disc. A single one is taken twice, so that it has
// neighbours that stay where they are.
std::vector<Touched> shortest_polygon(const std::vector<CurvedBounce>& bounces) {
  const std::size_t n = bounces.size(), count = std::max<std::size_t>(n, 2);
  const auto of = [&](std::size_t i) -> const CurvedBounce& { return bounces[i % n]; };
  std::vector<Touched> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back({of(i).arc->curve.centre, true});
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double moved = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = (i + count - 1) % count, after = (i + 1) % count;
      const Circle disc = circle_of(of(i).arc->curve);
      const Touched next =
          nearest_touch(disc, middle(of(before).next.back(near(all[before].point))),
                        middle(of(i).next(near(all[after].point))));
      moved =
          std::max(moved, (next.point - all[i].point).squaredNorm() / (disc.radius * disc.radius));
      all[i] = next;
    }
    if (moved < 1e-24) break;
  }
  return all;
}

// Whether a way runs through the inside of discs, one after the other, ahead of where it begins.
Proof passes_all(const Pair<Near>& from, const Pair<Near>& way,
                 const std::vector<Unfolded::Passed>& discs) {
  Proof all = Proof::yes;
  const Near size = dot(way, way);
  Near last(0.0);
  for (const auto& [disc, seen] : discs) {
    const Pair<Near> to = seen(near(disc.centre)) - from;
    const Near foot = dot(to, way), off = cross(to, way), radius(disc.radius);
    all = all & is_positive(foot - last) & is_positive(radius * radius * size - off * off);
    last = foot;
  }
  return all & is_positive(size - last);
}

// The same of the line on which the straight walls alone bring everything back, where one leads
// through all discs: no closed polygon is shorter.
Proof passes_all_on_line(const MirrorRoom& room, const Unfolded& unfolded, const Vec2& first) {
  Word straight;
  std::vector<Unfolded::Passed> others;
  Isometry<Near> seen;
  for (std::size_t i = 0; i < unfolded.legs.size(); ++i) {
    const auto& walls = unfolded.legs[i].straight;
    straight.insert(straight.end(), walls.begin(), walls.end());
    if (i > 0) others.push_back({circle_of(unfolded.bounces[i].arc->curve), seen});
    seen = seen * unfolded.bounces[i].next;
  }
  const auto line = returning_line(room, straight);
  if (!line) return Proof::open;
  // From the foot of the first disc's centre on it.
  const Circle disc = circle_of(unfolded.bounces[0].arc->curve);
  const Pair<Near> on = line->through.value_or(near(first)), way = line->way;
  const Near part = dot(near(disc.centre) - on, way) / dot(way, way);
  const Pair<Near> from = on + part * way, off = near(disc.centre) - from;
  return is_positive(Near(disc.radius) * disc.radius - dot(off, off)) &
         passes_all(from, way, others);
}

// Whether the word read backwards has the same unfolded polygons, and other walls: an orbit and its
// reverse would be one polygon that meets its walls in two orders, as where it runs into a corner.
bool is_like_its_reverse(const MirrorRoom& room, const Word& word) {
  const auto parts_of = [&](const Word& of) {
    std::vector<Word> parts;
    for (const std::uint8_t one : of)
      if (room.mirrors[one].arc)
        parts.push_back({one});
      else
        parts.back().push_back(one);
    return parts;
  };
  const auto start_at_disc = [&](Word of) {
    while (!room.mirrors[of[0]].arc) std::rotate(of.begin(), of.begin() + 1, of.end());
    return of;
  };
  const auto straight = [](const Word& part) { return Word(part.begin() + 1, part.end()); };
  const std::vector<Word> parts = parts_of(start_at_disc(word));
  std::vector<Word> back = parts_of(start_at_disc(Word(word.rbegin(), word.rend())));
  for (std::size_t turn = 0; turn < parts.size(); ++turn) {
    bool same = true;
    for (std::size_t i = 0; i < parts.size() && same; ++i)
      same =
          parts[i][0] == back[i][0] && have_same_image(room, straight(parts[i]), straight(back[i]));
    if (same && parts != back) return true;
    std::rotate(back.begin(), back.begin() + 1, back.end());
  }
  return false;
}

// Whether a leg leads from a disc to its own image: without it the polygon is no longer.
bool comes_back(const MirrorRoom& room, const Unfolded& unfolded) {
  for (std::size_t i = 0; i < unfolded.legs.size(); ++i) {
    const CurvedBounce& next = unfolded.bounces[i + 1 < unfolded.legs.size() ? i + 1 : 0];
    if (unfolded.bounces[i].arc == next.arc && have_same_image(room, unfolded.legs[i].straight, {}))
      return true;
  }
  return false;
}

}  // namespace

// An orbit of the word is the only shortest polygon: at each disc both neighbours lie beyond the
// tangent, so that the length grows wherever any of its points moves into a disc.
ClosedOrbit disc_orbit(const MirrorRoom& room, const Word& word) {
  ClosedOrbit orbit{word, Verdict::undecided};
  const std::vector<std::size_t> places = curved_places(room, word);
  const Unfolded whole = unfold(room, word, places);
  if (comes_back(room, whole)) {
    orbit.verdict = Verdict::pruned;
    orbit.why = "comes back to where it left a disc";
    return orbit;
  }
  const std::vector<Touched> shortest = shortest_polygon(whole.bounces);
  std::vector<std::size_t> kept;
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!shortest[i].passed) {
      kept.push_back(places[i]);
      points.push_back(shortest[i].point);
    }
  orbit.why = "its shortest polygon is a straight line through discs";
  if (kept.empty() && passes_all_on_line(room, whole, shortest[0].point) == Proof::yes)
    orbit.verdict = Verdict::pruned;
  if (kept.empty()) return orbit;
  Unfolded unfolded = unfold(room, word, kept);
  for (std::size_t i = 0; i < kept.size(); ++i)
    unfolded.bounces[i].at = direction_of(points[i] - unfolded.bounces[i].arc->curve.centre);
  StationaryPolygon polygon(std::move(unfolded.bounces));
  orbit.why = "Newton's method comes to no polygon that is alone";
  if (!polygon.improve() || !polygon.prove()) return orbit;
  Judged judged = judge(room, word, polygon, unfolded.legs);
  orbit.why = judged.why;
  if (judged.reflects != Proof::yes) return orbit;
  if (kept.size() < places.size()) {
    Proof through = Proof::yes;
    for (std::size_t i = 0; i < kept.size(); ++i)
      through = through &
                passes_all(polygon.place(i).point, polygon.way_from(i), unfolded.legs[i].passed);
    orbit.why = "its shortest polygon goes through a disc";
    if (through == Proof::yes) orbit.verdict = Verdict::pruned;
    return orbit;
  }
  orbit.verdict = judged.clear == Proof::yes  ? Verdict::proven
                  : judged.clear == Proof::no ? Verdict::pruned
                                              : Verdict::undecided;
  if (orbit.verdict == Verdict::undecided && is_like_its_reverse(room, word)) {
    orbit.verdict = Verdict::pruned;
    orbit.why = "runs into a corner";
  }
  if (!orbit.is_there()) return orbit;
  orbit.why.clear();
  orbit.length = judged.length;
  orbit.trace = judged.trace;
  orbit.points = std::move(judged.points);
  return orbit;
}

}  // namespace flatray
