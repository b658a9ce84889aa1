#include "study/periodic/closed_orbits.h"

#include <algorithm>
#include <cmath>

#include "base/philox.h"

namespace flatray {
namespace {

constexpr int kStarts = 48, kTries = 64;

// Draws that depend on the word and the start alone.
class Draws {
 public:
  Draws(const Word& word, int start) : start_(static_cast<std::uint64_t>(start)) {
    for (const std::uint8_t one : word) word_ = word_ * 67 + one + 1;
  }
  double next() {
    return 2 * unit_double(random_bits(1, Stream::experiment, start_, word_, drawn_++)) - 1;
  }

 private:
  std::uint64_t word_ = 0, start_;
  std::uint32_t drawn_ = 0;
};

// A place on an arc, of those at which its curve is drawn evenly.
Vec2 draw_on(const Arc& arc, Draws& draws) {
  Vec2 at(1, 0);
  for (int i = 0; i < kTries; ++i) {
    at = {draws.next(), draws.next()};
    const double size = at.squaredNorm();
    if (size > 1 || size < 0.01) continue;
    at /= std::sqrt(size);
    if (lies_on(arc, curve_place({&arc, at}, 0.0).point) != Proof::no) break;
  }
  return at;
}

// Whether the bounces of two orbits are the same but for a small part of the way of one, turned by `shift`.
bool are_near(const ClosedOrbit& one, const ClosedOrbit& other, std::size_t shift) {
  const std::vector<Vec2>&a = one.points, &b = other.points;
  const double near = 1e-8 * one.length.value();
  for (std::size_t i = 0; i < a.size(); ++i)
    if ((a[i] - b[(i + shift) % b.size()]).cwiseAbs().maxCoeff() > near) return false;
  return true;
}

// The shortest part that a word repeats.
std::size_t period_of(const Word& word) {
  std::size_t period = 1;
  while (word.size() % period != 0 ||
         !std::equal(word.begin() + static_cast<std::ptrdiff_t>(period), word.end(), word.begin()))
    ++period;
  return period;
}

bool is_new(const ClosedOrbit& orbit, const std::vector<ClosedOrbit>& found, std::size_t period) {
  for (std::size_t shift = period; shift < orbit.word.size(); shift += period)
    if (are_near(orbit, orbit, shift)) return false;
  for (const ClosedOrbit& other : found)
    for (std::size_t shift = 0; shift < orbit.word.size(); shift += period)
      if (are_near(orbit, other, shift)) return false;
  return true;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::string_view kNames[] = {"proven", "family", "pruned", "undecided", "not found"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::optional<Near> ClosedOrbit::eigenvalue() const {
  const Near square = trace * trace - Near(4);
  if (is_positive(square) != Proof::yes) return std::nullopt;
  const Near root = square_root(square);
  return (trace.value() < 0 ? trace - root : trace + root) / Near(2);
}

std::vector<ClosedOrbit> drawn_orbits(const MirrorRoom& room, const Word& word) {
  const std::size_t period = period_of(word);
  const Unfolded unfolded = unfold(room, word, curved_places(room, word));
  std::vector<ClosedOrbit> found;
  for (int start = 0; start < kStarts; ++start) {
    Draws draws(word, start);
    StationaryPolygon polygon(unfolded.bounces);
    for (CurvedBounce& bounce : polygon.bounces()) bounce.at = draw_on(*bounce.arc, draws);
    if (!polygon.improve() || !polygon.prove()) continue;
    Judged judged = judge(room, word, polygon, unfolded.legs);
    if ((judged.reflects & judged.clear) != Proof::yes) continue;
    ClosedOrbit orbit{word,          Verdict::proven, {},
                      judged.length, judged.trace,    std::move(judged.points)};
    if (!is_new(orbit, found, period)) continue;
    orbit.number = found.size() + 1;
    found.push_back(std::move(orbit));
  }
  if (!found.empty()) return found;
  if (period < word.size())
    return {{word, Verdict::not_found, "none but repeats of a shorter one"}};
  if (is_ruled_out(room, word))
    return {{word, Verdict::pruned, "all places on its walls are ruled out"}};
  return {{word, Verdict::not_found}};
}

std::vector<ClosedOrbit> closed_orbits(const MirrorRoom& room, const Word& word) {
  if (word.size() == 1) return {{word, Verdict::pruned, "no straight line comes back"}};
  const auto any = [&](auto is) {
    return std::ranges::any_of(word, [&](std::uint8_t one) { return is(room.mirrors[one]); });
  };
  if (any([](const Mirror& one) { return one.may_repeat(); })) return drawn_orbits(room, word);
  if (any([](const Mirror& one) { return one.arc.has_value(); })) return {disc_orbit(room, word)};
  return {straight_orbit(room, word)};
}

}  // namespace flatray
