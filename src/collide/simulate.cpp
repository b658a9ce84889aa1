#include "collide/simulate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <set>
#include <tuple>

namespace flatray {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Two bodies will meet, if neither changes its way before.
struct Prospect {
  double time;
  Pair pair;
  std::uint32_t stage_a, stage_b;  // of the bodies, when this was foreseen
  Vec2 point, normal;

  // The last in order comes first out of a heap.
  bool operator<(const Prospect& other) const {
    return std::tie(time, pair) > std::tie(other.time, other.pair);
  }
};

struct Met {
  double time;
  RoundPlace place;
};

double radius_of(const SimulatedBody& body) {
  double radius = 0;
  for (const ShapePart& part : body.parts)
    for (const Vec2& p : part.ring) radius = std::max(radius, p.stableNorm() + part.radius);
  return radius * (1 + 0x1p-40);
}

class Run {
 public:
  Run(std::span<const SimulatedBody> bodies, Response response, double end)
      : bodies_(bodies), response_(response), end_(end) {
    for (const SimulatedBody& body : bodies) {
      stages_.push_back({{0, body.at, body.velocity}});
      radii_.push_back(radius_of(body));
    }
    for (std::uint32_t i = 0; i < bodies.size(); ++i)
      for (std::uint32_t k = i + 1; k < bodies.size(); ++k) {
        if (overlap(i, k)) left_alone_.insert({i, k});
        foresee({i, k}, 0);
      }
  }

  Simulation run(std::size_t most_events) {
    Simulation done;
    done.overlaps = !left_alone_.empty();
    std::size_t at_once = 0;
    while (!ahead_.empty()) {
      const Prospect next = ahead_.top();
      ahead_.pop();
      const auto [a, b] = next.pair;
      if (stages_[a].size() != next.stage_a || stages_[b].size() != next.stage_b) continue;
      at_once = !done.events.empty() && done.events.back().time == next.time ? at_once + 1 : 0;
      done.jammed = at_once > kJamEvents * bodies_.size();
      if (done.jammed || done.events.size() == most_events) {
        done.complete = false;
        break;
      }
      respond(next);
      done.events.push_back({next.time, a, b, next.point, next.normal, stages_[a].back().velocity,
                             stages_[b].back().velocity});
    }
    done.stages = std::move(stages_);
    return done;
  }

 private:
  bool is_fixed(std::uint32_t i) const { return bodies_[i].mass == kInfinity; }
  Vec2 place(std::uint32_t i, double time) const { return flatray::place_at(stages_[i], time); }

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

  bool overlap(std::uint32_t i, std::uint32_t k) const {
    bool found = false;
    if (!discs_may_meet({i, k}, 0)) return false;
    each_contact({i, k}, 0, {0, 0},
                 [&](const RoundContact& met, const RoundBody&, const RoundBody&) {
                   found |= met.times.start == StartPlace::inside;
                 });
    return found;
  }

  // Discs about both; what rounding may lose is far below 2^-30 of what goes in.
  bool discs_may_meet(const Pair& pair, double time) const {
    const auto [i, k] = pair;
    const Vec2 from = place(k, time) - place(i, time);
    const Vec2 way = (end_ - time) * (stages_[k].back().velocity - stages_[i].back().velocity);
    const double length = way.stableNorm(), distance = from.stableNorm();
    const double reach = (radii_[i] + radii_[k]) * (1 + 0x1p-30) + 0x1p-30 * (distance + length);
    if (!(length > 0 && length < kInfinity)) return !(distance > reach + length);
    const Vec2 ahead = way / length;
    const Vec2 nearest = from + std::clamp(-ahead.dot(from), 0.0, length) * ahead;
    return !(nearest.stableNorm() > reach);
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

  void foresee(const Pair& pair, double time) {
    const auto [a, b] = pair;
    if (is_fixed(a) && is_fixed(b)) return;
    if (!discs_may_meet(pair, time)) return;
    if (const auto met = meeting(pair, time))
      ahead_.push({time + met->time, pair, static_cast<std::uint32_t>(stages_[a].size()),
                   static_cast<std::uint32_t>(stages_[b].size()), met->place.point,
                   met->place.normal});
  }

  void respond(const Prospect& met) {
    left_alone_.erase(met.pair);
    if (response_ == Response::mark) return;
    const auto [a, b] = met.pair;
    Vec2 va = stages_[a].back().velocity, vb = stages_[b].back().velocity;
    if (response_ == Response::stop) {
      const Vec2 together = is_fixed(a) ? va : is_fixed(b) ? vb : Vec2(0, 0);
      va = vb = together;
    } else {
      const double inverse_a = 1 / bodies_[a].mass, inverse_b = 1 / bodies_[b].mass;
      const double push = 2 * met.normal.dot(va - vb) / (inverse_a + inverse_b);
      va -= push * inverse_a * met.normal;
      vb += push * inverse_b * met.normal;
    }
    if (!is_fixed(a)) change(a, met.time, va);
    if (!is_fixed(b)) change(b, met.time, vb);
    for (const std::uint32_t i : {a, b}) {
      if (is_fixed(i)) continue;
      for (std::uint32_t k = 0; k < bodies_.size(); ++k)
        if (k != i && !(i == b && k == a && !is_fixed(a))) foresee(std::minmax(i, k), met.time);
    }
  }

  void change(std::uint32_t i, double time, const Vec2& velocity) {
    stages_[i].push_back({time, place(i, time), velocity});
  }

  const std::span<const SimulatedBody> bodies_;
  const Response response_;
  const double end_;
  std::vector<std::vector<Stage>> stages_;
  std::vector<double> radii_;
  std::set<Pair> left_alone_;
  std::priority_queue<Prospect> ahead_;
};

}  // namespace

Simulation simulate(std::span<const SimulatedBody> bodies, Response response, double end,
                    std::size_t most_events) {
  return Run(bodies, response, end).run(most_events);
}

Vec2 place_at(std::span<const Stage> stages, double time) {
  const auto after = std::upper_bound(stages.begin(), stages.end(), time,
                                      [](double t, const Stage& s) { return t < s.from; });
  const Stage& stage = after == stages.begin() ? stages.front() : *(after - 1);
  return stage.at + (time - stage.from) * stage.velocity;
}

}  // namespace flatray
