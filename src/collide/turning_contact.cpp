#include "collide/turning_contact.h"

#include <algorithm>

#include "collide/turning_pair.h"

namespace flatray {
namespace {

using Verdict = TurningContact::Verdict;

// Two bodies of several parts each, as the upright boxes around them meet.
class BoxPair {
 public:
  BoxPair(const TurningParts& a, const TurningParts& b, double length, bool backwards) {
    for (const TurningBody& one : a)
      for (const TurningBody& other : b) pairs_.emplace_back(one, other, length, backwards);
  }
  void place(double now) {
    for (TurningPair& pair : pairs_) pair.place(now);
  }
  // They are apart where all parts are along one direction, and overlap where some do along each.
  double apart_for(double) const {
    double best = 0;
    for (const Vec2& normal : kUpright) {
      double least = kInfinity;
      for (const TurningPair& pair : pairs_)
        if (least > best) least = std::min(least, pair.holds_along(normal, true));
      best = std::max(best, least);
    }
    return best;
  }
  double overlap_for() const {
    double least = kInfinity;
    for (const Vec2& normal : kUpright) {
      double longest = 0;
      for (const TurningPair& pair : pairs_)
        longest = std::max(longest, pair.holds_along(normal, false));
      least = std::min(least, longest);
    }
    return least;
  }
  ContactPlace touching_place() const {
    Bounds a, b;
    for (const TurningPair& pair : pairs_) a.add(pair.box_a()), b.add(pair.box_b());
    return resting_place({a.corners(), {0, 0}}, {b.corners(), {0, 0}}, 0);
  }
  double scale() const { return 1; }

 private:
  static inline const Vec2 kUpright[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  std::vector<TurningPair> pairs_;
};

template <class Pair>
class ContactFinder {
 public:
  ContactFinder(Pair pair, double length, double width)
      : pair_(std::move(pair)), length_(length), width_(width) {}

  TurningContact run(double from) {
    pair_.place(from);
    if (overlap()) {
      found_.verdict = Verdict::meets;
      found_.start = StartPlace::inside;
      found_.place = pair_.touching_place();
      return found_;
    }
    for (double now = from; now < length_;) {
      pair_.place(now);
      const double ahead = pair_.apart_for(length_ - now);
      if (ahead >= length_ - now) break;
      if (ahead >= width_ / 16 && ++steps_ < kMostTurningSteps) {
        now = (now + ahead) * (1 - 0x1p-51);
        continue;
      }
      if (found_.verdict == Verdict::apart) begin_doubt(now, ahead);
      now = end_of_doubt(now);
      found_.first.high = now;
      if (found_.verdict == Verdict::meets) break;
    }
    return found_;
  }
  // From a time at which they overlap.
  std::optional<double> parting(double now) {
    while (now < length_) {
      pair_.place(now);
      const double ahead = pair_.overlap_for();
      if (ahead >= length_ - now || ++steps_ >= kMostPartingSteps) return std::nullopt;
      if (ahead >= width_ / 16) {
        now = (now + ahead) * (1 - 0x1p-51);
        continue;
      }
      const std::optional<Certain> next = certain_after(now);
      if (!next) return std::nullopt;
      if (!next->overlap) return next->time;
      now = next->time;
    }
    return std::nullopt;
  }

 private:
  // A time at which they certainly overlap, or else are certainly apart.
  struct Certain {
    double time;
    bool overlap;
  };

  bool overlap() const { return pair_.overlap_for() > 0; }
  // The first found 1, 2, 4.. widths after a time.
  std::optional<Certain> certain_after(double now) {
    for (double after = width_; now + after < length_; after *= 2) {
      pair_.place(now + after);
      if (overlap()) return Certain{now + after, true};
      if (pair_.apart_for(width_) >= width_ / 16) return Certain{now + after, false};
    }
    return std::nullopt;
  }
  void begin_doubt(double now, double ahead) {
    found_.verdict = Verdict::undecided;
    found_.first.low = now;
    found_.place = pair_.touching_place();
    if (now == 0 && ahead == 0) found_.start = StartPlace::boundary;
  }
  // When they certainly overlap, are certainly apart again, or the end.
  double end_of_doubt(double now) {
    if (steps_ >= kMostTurningSteps) return length_;
    const std::optional<Certain> next = certain_after(now);
    if (!next) pair_.place(length_);
    if (next ? next->overlap : overlap()) found_.verdict = Verdict::meets;
    return next ? next->time : length_;
  }

  Pair pair_;
  const double length_, width_;
  int steps_ = 0;
  TurningContact found_;
};

template <class Pair>
TurningContact contact_of(const Pair& pair, const RigidMotion& a, double length, double width,
                          bool backwards, double from) {
  TurningContact found = ContactFinder<Pair>(pair, length, width).run(from);
  const double time = backwards ? length - found.first.low : found.first.low;
  found.place.point = found.place.point / pair.scale() + a.at(time);
  if (backwards) found.first = {length - found.first.high, length - found.first.low};
  return found;
}

}  // namespace

TurningContact turning_contact(const TurningBody& a, const TurningBody& b, double length,
                               double width, bool backwards, double from) {
  return contact_of(TurningPair(a, b, length, backwards), a.motion, length, width, backwards, from);
}

std::optional<double> turning_parting(const TurningBody& a, const TurningBody& b, double from) {
  return ContactFinder(TurningPair(a, b, 1, false), 1, kTurningWidth).parting(from);
}

TurningContact turning_contact(const TurningParts& a, const TurningParts& b, double length,
                               double width, bool backwards, double from) {
  return contact_of(BoxPair(a, b, length, backwards), a[0].motion, length, width, backwards, from);
}

std::optional<double> turning_parting(const TurningParts& a, const TurningParts& b, double from) {
  return ContactFinder(BoxPair(a, b, 1, false), 1, kTurningWidth).parting(from);
}

}  // namespace flatray
