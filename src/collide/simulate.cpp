#include "collide/simulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <set>
#include <tuple>

#include "collide/near_bodies.h"

namespace flatray {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// What slides leaves at this part of the speed it came with: rounding of a normal and of velocities,
// some 2^-51 of them, does not bring it back.
constexpr double kSlideLeaves = 0x1p-40;

// Two bodies will meet, if neither changes its way before; or, where that is not looked at yet, will
// not meet before.
struct Prospect {
  double time;
  bool certain;
  Pair pair;
  std::uint32_t stage_a, stage_b;  // of the bodies, when this was foreseen
  Vec2 point{0, 0}, normal{0, 0};

  // The last in order comes first out of a heap.
  bool operator<(const Prospect& other) const {
    return std::tie(time, certain, pair) > std::tie(other.time, other.certain, other.pair);
  }
};

struct Met {
  double time;
  RoundPlace place;
};

// As stableNorm, in a third of the time.
double length_of(const Vec2& v) {
  const double most = v.cwiseAbs().maxCoeff();
  return most > 0 && most < kInfinity ? most * (v / most).norm() : most;
}

double radius_of(const SimulatedBody& body) {
  double radius = 0;
  for (const ShapePart& part : body.parts)
    for (const Vec2& p : part.ring) radius = std::max(radius, length_of(p) + part.radius);
  return radius * (1 + 0x1p-40);
}

// Of both masses in units of the lighter, rounded down to a power of two: only their ratio counts, and
// none that matters is lost.
std::pair<double, double> inverse_masses(double a, double b) {
  const double lighter = std::min(a, b);
  if (lighter == kInfinity) return {0, 0};
  const int exponent = -std::ilogb(lighter);
  return {1 / std::ldexp(a, exponent), 1 / std::ldexp(b, exponent)};
}

class Run {
 public:
  Run(std::span<const SimulatedBody> bodies, double end, PairSearch search)
      : bodies_(bodies), end_(end), search_(search), near_(boxes_of(bodies)) {
    double sizes = 0, speeds = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      stages_.push_back({{0, bodies[i].at, bodies[i].velocity}});
      radii_.push_back(radius_of(bodies[i]));
      if (bodies[i].response == Response::none) continue;
      responding_.push_back(i);
      sizes += radii_.back();
      speeds += length_of(bodies[i].velocity);
    }
    length_ = sizes > 0 && speeds > 0 && sizes / speeds > 0 ? sizes / speeds : end;
    while_from_ = while_to_ = 0;
    open_near();
    each_pair([&](const Pair& pair) {
      if (overlap(pair)) left_alone_.insert(pair);
    });
  }

  Simulation run(std::size_t most_events) {
    Simulation done;
    done.overlaps = !left_alone_.empty();
    for (bool first = true; first || while_to_ < end_; first = false) {
      open_while(first);
      const std::size_t before = done.events.size();
      if (!run_while(done, most_events)) break;
      adapt(done.events.size() - before);
    }
    done.stages = std::move(stages_);
    return done;
  }

 private:
  static std::vector<Bounds> boxes_of(std::span<const SimulatedBody> bodies) {
    std::vector<Bounds> boxes;
    for (const SimulatedBody& body : bodies)
      boxes.push_back(body.response == Response::none ? Bounds{} : bounds_of(body.parts));
    return boxes;
  }

  // The next while of time; in the first what happens at 0, too.
  void open_while(bool first) {
    while_from_ = first ? -1 : while_to_;
    const double begin = std::max(while_from_, 0.0);
    const double next = begin + length_;
    while_to_ = search_ == PairSearch::all || !(next > begin) || !(next < end_) ? end_ : next;
    open_near();
    each_pair([&](const Pair& pair) { foresee(pair); });
  }

  void open_near() {
    if (search_ == PairSearch::all) return;
    std::vector<const Stage*> now(bodies_.size(), nullptr);
    for (const std::uint32_t i : responding_)
      if (!is_gone(i)) now[i] = &stages_[i].back();
    near_.open(std::max(while_from_, 0.0), while_to_, now);
  }

  template <class Take>
  void each_pair(const Take& take) {
    if (search_ == PairSearch::near)
      return near_.each_pair([&](std::uint32_t a, std::uint32_t b) { take(Pair{a, b}); });
    for (std::size_t i = 0; i < responding_.size(); ++i)
      for (std::size_t k = i + 1; k < responding_.size(); ++k)
        take(Pair{responding_[i], responding_[k]});
  }

  template <class Take>
  void each_near(std::uint32_t body, const Take& take) {
    if (search_ == PairSearch::near) return near_.each_near(body, take);
    for (const std::uint32_t k : responding_)
      if (k != body) take(k);
  }

  // So long that between an eighth and a half of the bodies meet something in it.
  void adapt(std::size_t events) {
    if (8 * events < responding_.size())
      length_ *= 2;
    else if (2 * events > responding_.size())
      length_ /= 2;
  }

  // Whether all that happens in the while was allowed to.
  bool run_while(Simulation& done, std::size_t most_events) {
    std::vector<CollisionEvent>& events = done.events;
    while (!ahead_.empty()) {
      const Prospect next = ahead_.top();
      ahead_.pop();
      const auto [a, b] = next.pair;
      if (stages_[a].size() != next.stage_a || stages_[b].size() != next.stage_b) continue;
      if (!next.certain) {
        look_closely(next);
        continue;
      }
      at_once_ = !events.empty() && events.back().time == next.time ? at_once_ + 1 : 0;
      done.jammed = at_once_ > kJamEvents * bodies_.size();
      if (done.jammed || events.size() == most_events) {
        done.complete = false;
        done.until = next.time;
        return false;
      }
      respond(next);
      events.push_back({next.time, a, b, next.point, next.normal, stages_[a].back().velocity,
                        stages_[b].back().velocity});
    }
    return true;
  }

  bool is_fixed(std::uint32_t i) const { return bodies_[i].mass == kInfinity; }
  // What nothing moves is a wall to all, whatever it would do itself, but for what needs no motion.
  bool does(std::uint32_t i, Response response) const {
    const bool of_all = response == Response::mark || response == Response::remove;
    return bodies_[i].response == response && (of_all || !is_fixed(i));
  }
  bool is_gone(std::uint32_t i) const { return stages_[i].back().gone; }
  // From its last change on.
  Vec2 place(std::uint32_t i, double time) const {
    return flatray::place_at(std::span(stages_[i]).last(1), time);
  }

  // The parts of a body at a time, one after the other.
  RoundBody part(std::uint32_t i, const ShapePart& part, const Vec2& at,
                 std::vector<Vec2>& ring) const {
    ring.clear();
    for (const Vec2& p : part.ring) ring.push_back(at + p);
    return {{ring, stages_[i].back().velocity}, part.radius};
  }

  template <class Look>
  void each_contact(const Pair& pair, double time, Range within, const Look& look) const {
    const Vec2 at_a = place(pair.first, time), at_b = place(pair.second, time);
    std::vector<Vec2> ring_a, ring_b;
    for (const ShapePart& p : bodies_[pair.first].parts)
      for (const ShapePart& q : bodies_[pair.second].parts) {
        const RoundBody a = part(pair.first, p, at_a, ring_a);
        const RoundBody b = part(pair.second, q, at_b, ring_b);
        look(round_contact(a, b, within), a, b);
      }
  }

  bool overlap(const Pair& pair) const {
    bool found = false;
    if (!discs_meet(pair, 0)) return false;
    each_contact(pair, 0, {0, 0}, [&](const RoundContact& met, const RoundBody&, const RoundBody&) {
      found |= met.times.start == StartPlace::inside;
    });
    return found;
  }

  // A time before which discs about both do not meet, seen from `time`; none where they never do.
  // What rounding may lose is far below 2^-30 of what goes in.
  std::optional<double> discs_meet(const Pair& pair, double time) const {
    constexpr double kSlack = 0x1p-30;
    const auto [i, k] = pair;
    const Vec2 at_i = place(i, time), at_k = place(k, time), from = at_k - at_i;
    const double distance = length_of(from);
    const double reach = (radii_[i] + radii_[k] + 2 * distance) * kSlack + radii_[i] + radii_[k] +
                         0x1p-50 * (length_of(at_i) + length_of(at_k));
    if (!(distance > reach)) return 0;
    const Vec2 way = stages_[k].back().velocity - stages_[i].back().velocity;
    const double speed = length_of(way);
    const double ahead = speed > 0 ? -(way / speed).dot(from) : 0;
    if (!(ahead > 0)) return std::nullopt;
    const double beside = length_of(from + ahead * (way / speed));
    if (beside > reach) return std::nullopt;
    const double inside = beside / reach, soonest = ahead - reach * std::sqrt(1 - inside * inside);
    const double wait = (soonest - kSlack * distance) / speed * (1 - kSlack);
    if (wait > end_ - time) return std::nullopt;
    return std::max(wait, 0.0);
  }

  // When a pair meets from `time` on, as seen from there.
  std::optional<Met> meeting(const Pair& pair, double time) const {
    std::optional<Met> first;
    bool overlaps = false;
    each_contact(pair, time, kLine,
                 [&](const RoundContact& met, const RoundBody& a, const RoundBody& b) {
                   if (met.times.kind != HitClass::through || !met.first || !met.last) return;
                   const double enter = met.times.t_enter, exit = met.times.t_exit;
                   overlaps |= enter < 0 && exit > 0;
                   // Laid into each other by rounding: on the way in where that is the shorter way out.
                   if (exit <= 0 || -enter > exit || enter > end_ - time) return;
                   const double t = std::max(enter, 0.0);
                   if (!first || t < first->time)
                     first = Met{t, flatray::place_at(*met.first, a, b, t)};
                 });
    if (overlaps && left_alone_.count(pair) > 0) return std::nullopt;
    return first;
  }

  // Since when neither of a pair has changed its way: from there their meeting is seen, however late
  // it is looked for.
  double seen_from(const Pair& pair) const {
    return std::max(stages_[pair.first].back().from, stages_[pair.second].back().from);
  }

  // What comes after the while is left to a later one.
  void foresee(const Pair& pair) {
    const auto [a, b] = pair;
    if ((is_fixed(a) && is_fixed(b)) || is_gone(a) || is_gone(b)) return;
    const double time = std::max(seen_from(pair), while_from_);
    const auto wait = discs_meet(pair, time);
    if (!wait) return;
    const double soonest = std::max(time, (time + *wait) * (1 - 0x1p-50));
    if (soonest <= while_to_)
      ahead_.push({soonest, false, pair, static_cast<std::uint32_t>(stages_[a].size()),
                   static_cast<std::uint32_t>(stages_[b].size())});
  }

  // Most pairs have changed their ways before it comes to that.
  void look_closely(Prospect pair) {
    const double from = seen_from(pair.pair);
    const auto met = meeting(pair.pair, from);
    if (!met) return;
    pair.time = from + met->time;
    if (pair.time <= while_from_ || pair.time > while_to_) return;
    pair.certain = true;
    pair.point = met->place.point;
    pair.normal = met->place.normal;
    ahead_.push(pair);
  }

  void respond(const Prospect& met) {
    const std::uint32_t a = met.pair.first, b = met.pair.second;
    const std::array before{stages_[a].size(), stages_[b].size()};
    if (does(a, Response::mark) || does(b, Response::mark)) {
      left_alone_.insert(met.pair);  // as long as they overlap it is one meeting
    } else {
      left_alone_.erase(met.pair);
      const auto [va, vb] = velocities_after(met);
      if (!is_fixed(a)) change(a, {met.time, place(a, met.time), va});
      if (!is_fixed(b)) change(b, {met.time, place(b, met.time), vb});
    }
    for (const std::uint32_t i : {a, b})
      if (does(i, Response::remove)) change(i, {met.time, place(i, met.time), {0, 0}, true});
    const bool changed_a = stages_[a].size() != before[0],
               changed_b = stages_[b].size() != before[1];
    if (search_ == PairSearch::near) {
      if (changed_a) near_.change(a, stages_[a].back());
      if (changed_b) near_.change(b, stages_[b].back());
    }
    if (changed_a) each_near(a, [&](std::uint32_t k) { foresee(std::minmax(a, k)); });
    if (changed_b)
      each_near(b, [&](std::uint32_t k) {
        if (k != a || !changed_a) foresee(std::minmax(b, k));
      });
  }

  std::pair<Vec2, Vec2> velocities_after(const Prospect& met) const {
    const auto [a, b] = met.pair;
    Vec2 va = stages_[a].back().velocity, vb = stages_[b].back().velocity;
    const bool stops_a = does(a, Response::stop), stops_b = does(b, Response::stop);
    const Vec2 together = is_fixed(a) ? va : is_fixed(b) ? vb : Vec2(0, 0);
    if (stops_a) va = together;
    if (stops_b) vb = together;
    const bool wall_a = stops_a || does(a, Response::remove),
               wall_b = stops_b || does(b, Response::remove);
    const auto [inverse_a, inverse_b] =
        inverse_masses(wall_a ? kInfinity : bodies_[a].mass, wall_b ? kInfinity : bodies_[b].mass);
    const bool slides = does(a, Response::slide) || does(b, Response::slide);
    const double speed = met.normal.dot(va - vb);
    const bool parts = (stops_a || stops_b) && !(speed > 0);  // as the one has stopped
    if (parts || inverse_a + inverse_b == 0) return {va, vb};
    const double push = (1 + (slides ? kSlideLeaves : 1)) * speed / (inverse_a + inverse_b);
    return {va - push * inverse_a * met.normal, vb + push * inverse_b * met.normal};
  }

  void change(std::uint32_t i, const Stage& stage) { stages_[i].push_back(stage); }

  const std::span<const SimulatedBody> bodies_;
  const double end_;
  const PairSearch search_;
  NearBodies near_;
  double length_ = 0;                     // of a while
  double while_from_ = 0, while_to_ = 0;  // events after the one, up to the other
  std::size_t at_once_ = 0;               // events so far at the time of the last
  std::vector<std::vector<Stage>> stages_;
  std::vector<double> radii_;
  std::vector<std::uint32_t> responding_;
  std::set<Pair> left_alone_;
  std::priority_queue<Prospect> ahead_;
};

}  // namespace

Simulation simulate(std::span<const SimulatedBody> bodies, double end, std::size_t most_events,
                    PairSearch search) {
  return Run(bodies, end, search).run(most_events);
}

}  // namespace flatray
