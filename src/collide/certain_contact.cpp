#include "collide/certain_contact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace flatray {
namespace {

using Ready = BodySet::Ready;
using Box = BodySet::Box;

// An edge beside the one looked for is put right by as many steps.
constexpr int kRounds = 4;

typedef float Four __attribute__((vector_size(16)));

// The least and the most of all corners to the left of a way, as seen from the centre.
struct Shadow {
  float low, high;
};
Shadow shadow(const Ready& shape, float x, float y) {
  Four cx[2], cy[2];
  std::memcpy(cx, shape.lanes.x, sizeof cx);
  std::memcpy(cy, shape.lanes.y, sizeof cy);
  const Four p = x * cy[0] - y * cx[0], q = x * cy[1] - y * cx[1];
  const Four low = p < q ? p : q, high = p > q ? p : q;
  return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
          std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
}

// Whether the one surely passes the other without ever touching it.
bool passes_beside(const BodySet& bodies, const MovingPair& pair) {
  const Box &a = bodies.boxes()[pair.a], &b = bodies.boxes()[pair.b];
  const Vec2 way = pair.velocity_b - pair.velocity_a, between = b.centre - a.centre;
  const double speed = std::fabs(way.x()) + std::fabs(way.y());
  const double size = (a.half + b.half + between.cwiseAbs()).sum();
  const auto x = static_cast<float>(way.x() / speed), y = static_cast<float>(way.y() / speed);
  const Shadow of_a = shadow(bodies.ready(pair.a), x, y), of_b = shadow(bodies.ready(pair.b), x, y);
  const double left = static_cast<double>(x) * between.y() - static_cast<double>(y) * between.x();
  // A handful of roundings to floats, each of 2^-24 of what the terms add up to.
  const double error = 0x1p-19 * size + 0x1p-120;
  return left + static_cast<double>(of_b.low) - static_cast<double>(of_a.high) > error ||
         static_cast<double>(of_a.low) - left - static_cast<double>(of_b.high) > error;
}

// Which way the outline turns from an edge of the first shape to one of the second turned round:
// those of the first come first where it does not turn right.
bool first_comes_first(const Vec2& from_a, const Vec2& to_a, const Vec2& from_b, const Vec2& to_b) {
  const Vec2 first = to_a - from_a, second = from_b - to_b;
  return first.x() * second.y() >= first.y() * second.x();
}

int wrapped(int k, int count) { return k < 0 ? k + count : k < count ? k : k - count; }

}  // namespace

void CertainContacts::add(const MovingPair& pair, const pairs::Candidates& guess,
                          Contact& contact) {
  if (guess.enter > -guess.leave && passes_beside(bodies_, pair)) return;
  // One edge properly crossed at a time in the range, or an overlap, and there is one from the
  // former to the latter.
  contact.times = {0, length_, kNoEdge, kNoEdge, HitClass::through, StartPlace::inside};
  items_.push_back({&pair, &contact, &bodies_.ready(pair.a), &bodies_.ready(pair.b)});
  if (!(guess.first_gap < 0)) ask(items_.back(), guess.enter, true);
  if (!(length_ < kInfinity && guess.last_gap < 0)) ask(items_.back(), guess.leave, false);
}

void CertainContacts::ask(Item& item, float guess, bool comes_in) {
  const unsigned bits = std::bit_cast<unsigned>(guess) & pairs::kCandidateBits;
  const bool of_a = (bits & pairs::kEdgeBits) < pairs::kCorners;
  const int edge = static_cast<int>(bits % pairs::kCorners);
  const int vertex = static_cast<int>(bits / pairs::kCornerUnit);
  const int a = of_a ? edge : vertex, b = of_a ? vertex : edge;
  // Lanes left over repeat the first corner.
  asks_.push_back({&item, a < item.a->count ? a : 0, b < item.b->count ? b : 0, of_a, comes_in});
}

void CertainContacts::prove() {
  for (int round = 0; round < kRounds && !asks_.empty(); ++round) {
    const std::size_t count = asks_.size();
    for (std::size_t at = 0; at < count || at % pairs::kLanes != 0; ++at) {
      const auto& [item, a, b, of_a, comes_in] = asks_[std::min(at, count - 1)];
      proofs_.edge[at] = (of_a ? item->a->corner(a) : item->b->corner(b)).data();
      proofs_.vertex[at] = (of_a ? item->b->corner(b - 1) : item->a->corner(a - 1)).data();
      proofs_.moves[at] = item->pair->velocity_a.data();
      proofs_.of_first[at] = of_a ? 1 : -1;
    }
    kernel_(proofs_, static_cast<int>(count));
    std::size_t left = 0;
    for (std::size_t at = 0; at < count; ++at) {
      Ask next = asks_[at];
      if (!settle(next, at)) asks_[left++] = next;
    }
    asks_.resize(left);
  }
  for (const Ask& ask : asks_) ask.item->unsure = true;
}

// Whether nothing is left to ask; else `ask` is an edge to try next.
bool CertainContacts::settle(Ask& ask, std::size_t at) {
  const int found = static_cast<int>(proofs_.found[at]);
  const auto holds = [&](int what) { return (found & what) != 0; };
  const bool from_left = holds(pairs::kFromLeft), crossed = from_left != holds(pairs::kToLeft);
  const bool beside = holds(pairs::kRatherBefore | pairs::kRatherAfter);
  if (holds(pairs::kUnsure) || (!beside && crossed && from_left != ask.comes_in)) {
    ask.item->unsure = true;
    return true;
  }
  if (!beside && crossed) {
    accept(ask, holds(pairs::kPast), proofs_.time[at]);
    return true;
  }
  if (beside) {
    int& vertex = ask.of_a ? ask.b : ask.a;
    vertex = wrapped(vertex + (holds(pairs::kRatherAfter) ? 1 : -1),
                     (ask.of_a ? ask.item->b : ask.item->a)->count);
  } else {
    ask.move_edge(from_left == ask.comes_in);
  }
  return false;
}

// An edge that the origin surely crosses; `before` t = 0.
void CertainContacts::accept(const Ask& ask, bool before, double time) const {
  Item& item = *ask.item;
  if (before || time > length_) {
    item.apart |= before != ask.comes_in;
    return;
  }
  if (!(time < length_)) {
    item.unsure = true;
    return;
  }
  const auto of_a = static_cast<std::size_t>(ask.a), of_b = static_cast<std::size_t>(ask.b);
  Contact& contact = *item.contact;
  (ask.comes_in ? contact.first : contact.last) =
      ask.of_a ? ContactFeature{true, item.a->edges[of_a], item.b->numbers[of_b]}
               : ContactFeature{false, item.b->edges[of_b], item.a->numbers[of_a]};
  (ask.comes_in ? contact.times.t_enter : contact.times.t_exit) = time;
  if (ask.comes_in) contact.times.start = StartPlace::outside;
}

// To the next edge of the outline, or to the one before.
void CertainContacts::Ask::move_edge(bool on) {
  const BodySet::Ready &first = *item->a, &second = *item->b;
  if (on) (of_a ? a : b) += 1;
  a = wrapped(a, first.count);
  b = wrapped(b, second.count);
  const int i = on ? a : a - 1, k = on ? b : b - 1;
  of_a = on == first_comes_first(first.corner(i), first.corner(i + 1), second.corner(k),
                                 second.corner(k + 1));
  if (on) return;
  (of_a ? a : b) -= 1;
  a = wrapped(a, first.count);
  b = wrapped(b, second.count);
}

}  // namespace flatray
