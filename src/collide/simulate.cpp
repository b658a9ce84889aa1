#include "collide/simulate.h"

#include <algorithm>
#include <bit>
#include <set>
#include <tuple>

#include "collide/body_pairs.h"
#include "collide/instant.h"
#include "collide/near_bodies.h"

namespace flatray {
namespace {

// Two bodies will meet, if neither changes its way before; or, where that is not looked at yet, will
// not meet before.
struct Prospect {
  Hit hit;
  bool certain;
  std::size_t stage_a, stage_b;  // of the bodies, when this was foreseen

  // The last in order comes first out of a heap.
  bool operator<(const Prospect& other) const {
    return std::tie(hit.time, certain, hit.pair) >
           std::tie(other.hit.time, other.certain, other.hit.pair);
  }
};

// Hits of a body, and how it was when they had last doubled.
struct Tally {
  std::size_t hits = 0, doublings = 0;  // the latter in less time, and faster
  double at = 0, took = kInfinity, speed = 0;
  bool by_calm = false;  // one since was with what can be moved and is not hit ever faster
  struct Hit {
    std::uint32_t other = 0;
    Vec2 normal{0, 0};
  };
  Hit now{}, before{};
};

constexpr std::size_t kStill = 64;  // events at one time from which on gentle ones change nothing

class Run {
 public:
  Run(std::span<const SimulatedBody> bodies, double end, PairSearch search)
      : bodies_(bodies),
        end_(end),
        near_(boxes_of(bodies, search)),
        pairs_(bodies, stages_),
        instants_(bodies, stages_, pairs_),
        tallies_(bodies.size()) {
    for (const SimulatedBody& body : bodies) stages_.push_back({{0, body.at, body.velocity}});
    double sizes = 0, speeds = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].response == Response::none) continue;
      ++responding_;
      sizes += pairs_.radius(i);
      speeds += bodies[i].velocity.stableNorm();
    }
    const double usual = sizes / speeds;
    length_ = usual > 0 && usual < kInfinity && search == PairSearch::near ? usual : end;
    near_.open(0, 0, stages_);
    near_.each_pair([&](const IndexPair& pair) {
      if (instants_.is_fixed(pair.first) && instants_.is_fixed(pair.second)) return;
      if (pairs_.least_wait(pair, 0, end_) != 0.0 || !pairs_.overlap(pair, 0)) return;
      overlaps_.push_back(pair);
      if (instants_.is_mark(pair)) left_alone_.insert(pair);
    });
    std::ranges::sort(overlaps_);
  }

  Simulation run(std::size_t most_events) {
    Simulation done;
    for (bool first = true; first || while_to_ < end_; first = false) {
      open_while(first);
      const std::size_t before = done.events.size();
      if (!run_while(done, most_events)) break;
      adapt(done.events.size() - before);
    }
    done.overlaps = std::move(overlaps_);
    done.stages = std::move(stages_);
    return done;
  }

 private:
  // Of a search for all pairs a box without end stands for each body.
  static std::vector<Bounds> boxes_of(std::span<const SimulatedBody> bodies, PairSearch search) {
    const Bounds all{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
    std::vector<Bounds> boxes;
    for (const SimulatedBody& body : bodies)
      boxes.push_back(body.response == Response::none ? Bounds{}
                      : search == PairSearch::all     ? all
                                                      : bounds_of(body.parts));
    return boxes;
  }

  // The next while of time; in the first what happens at 0, too.
  void open_while(bool first) {
    while_from_ = first ? -1 : while_to_;
    const double begin = std::max(while_from_, 0.0), next = begin + length_;
    while_to_ = next > begin && next < end_ ? next : end_;
    near_.open(begin, while_to_, stages_);
    near_.each_pair([&](const IndexPair& pair) { foresee(pair); });
  }

  // So long that between an eighth and a half of the bodies meet something in it.
  void adapt(std::size_t events) {
    if (8 * events < responding_)
      length_ *= 2;
    else if (2 * events > responding_)
      length_ /= 2;
  }

  // Whether all that happens in the while was allowed to.
  bool run_while(Simulation& done, std::size_t most_events) {
    for (std::vector<Hit> hits = next_hits(); !hits.empty(); hits = next_hits()) {
      // Time that goes on by no more than each event is rounded by stands still.
      const double rounding = 0x1p-51 * now_ * static_cast<double>(at_once_ + 1);
      const bool at_once = now_ - stands_from_ <= rounding;
      if (!at_once) stands_from_ = now_;
      at_once_ = at_once ? at_once_ + hits.size() : 0;
      if (at_once_ > kStill) leave_gentle(hits);
      if (hits.empty()) continue;
      const bool full = done.events.size() == most_events;
      done.too_often = !full && !accumulates_ && at_once_ > kJamEvents * bodies_.size();
      done.jammed = !full && (accumulates_ || done.too_often || !respond(hits));
      done.crowd = instants_.crowd();
      if (done.jammed) done.jam = accumulates_ ? accumulates_->time : now_;
      for (const Hit& hit : hits) {
        if (done.jammed || done.events.size() == most_events) {
          done.complete = false;
          done.until = now_;
          done.untold = accumulates_ ? accumulates_->pair : hit.pair;
          return false;
        }
        const auto [a, b] = hit.pair;
        const ContactPlace& place = hit.touches.front().place;
        for (const auto& [body, other] : {hit.pair, IndexPair(b, a)})
          if (const double time = accumulation(body, other, place.normal); time <= end_)
            accumulates_ = Hit{time, hit.pair};
        done.events.push_back({now_, a, b, place.point, place.normal, stages_[a].back().velocity,
                               stages_[b].back().velocity});
      }
    }
    return true;
  }

  // When the hits of a body accumulate; infinite where they do not: what can be moved, and is not itself in
  // a jam, is turned in the end.
  double accumulation(std::uint32_t body, std::uint32_t other, const Vec2& normal) {
    Tally& last = tallies_[body];
    last.before = std::exchange(last.now, {other, normal});
    last.by_calm |= bodies_[other].mass < kInfinity && tallies_[other].doublings == 0;
    if (++last.hits < kJamFirst || !std::has_single_bit(last.hits)) return kInfinity;
    const double took = now_ - last.at, speed = stages_[body].back().velocity.stableNorm();
    const bool denser = took < last.took && speed > 1.5 * last.speed;
    const bool calm = std::exchange(last.by_calm, false);
    const double shorter = took / last.took;
    last.doublings = denser ? last.doublings + 1 : 0;
    last.at = now_, last.took = took, last.speed = speed;
    if (last.doublings < kJamDoublings || calm) return kInfinity;
    const double time = now_ + took * shorter / (1 - shorter);
    if (is_past(body, last.now, time) || is_past(body, last.before, time)) return kInfinity;
    return time;
  }

  // Whether it has gone by beside what it hit by then, if nothing else stops it.
  bool is_past(std::uint32_t body, const Tally::Hit& hit, double time) const {
    const auto extent = [&](std::uint32_t i) {
      Range beside{kInfinity, -kInfinity};
      for (const ShapePart& part : bodies_[i].parts)
        for (const Vec2& p : part.ring) {
          const double at = cross(hit.normal, pairs_.place(i, time) + p);
          beside = {std::min(beside.low, at - part.radius),
                    std::max(beside.high, at + part.radius)};
        }
      return beside;
    };
    const Range a = extent(body), b = extent(hit.other);
    return a.high < b.low || b.high < a.low;
  }

  // Those at the next time at which something meets, which is now; none where the while ends.
  std::vector<Hit> next_hits() {
    std::vector<Hit> hits;
    while (!ahead_.empty() && (hits.empty() || ahead_.front().hit.time == now_)) {
      std::ranges::pop_heap(ahead_, std::less<>());
      Prospect next = std::move(ahead_.back());
      ahead_.pop_back();
      if (is_stale(next)) continue;
      if (!next.certain) {
        look_closely(next);
        continue;
      }
      now_ = next.hit.time;
      hits.push_back(std::move(next.hit));
    }
    return hits;
  }

  // Whether one of the two has changed its way since.
  bool is_stale(const Prospect& prospect) const {
    const auto [a, b] = prospect.hit.pair;
    return stages_[a].size() != prospect.stage_a || stages_[b].size() != prospect.stage_b;
  }

  // What is stale would stay until its time comes, all that a large body was ever to meet: it is left
  // out when there are twice as many as were left the last time.
  void expect(Prospect prospect) {
    constexpr std::size_t kAllowed = 1000;
    if (ahead_.size() >= std::max(most_ahead_, kAllowed)) {
      std::erase_if(ahead_, [&](const Prospect& old) { return is_stale(old); });
      std::ranges::make_heap(ahead_, std::less<>());
      most_ahead_ = 2 * ahead_.size();
    }
    ahead_.push_back(std::move(prospect));
    std::ranges::push_heap(ahead_, std::less<>());
  }

  std::pair<Vec2, Vec2> velocities(const IndexPair& pair) const {
    return {stages_[pair.first].back().velocity, stages_[pair.second].back().velocity};
  }

  bool is_gone(std::uint32_t i) const { return stages_[i].back().gone; }

  // Since when neither of a pair has changed its way: from there their meeting is seen, however late
  // it is looked for.
  double seen_from(const IndexPair& pair) const {
    return std::max(stages_[pair.first].back().from, stages_[pair.second].back().from);
  }

  // What comes after the while is left to a later one.
  void foresee(const IndexPair& pair) {
    const auto [a, b] = pair;
    if ((instants_.is_fixed(a) && instants_.is_fixed(b)) || is_gone(a) || is_gone(b)) return;
    const double time = std::max(seen_from(pair), while_from_);
    const auto wait = pairs_.least_wait(pair, time, end_);
    if (!wait) return;
    const double soonest = std::max(time, (time + *wait) * (1 - 0x1p-50));
    if (soonest <= while_to_)
      expect({{soonest, pair}, false, stages_[a].size(), stages_[b].size()});
  }

  Overlap overlap_of(const IndexPair& pair) const {
    if (left_alone_.count(pair) > 0) return Overlap::passed;
    const auto glides = gliding_.find(pair);
    const bool as_then = glides != gliding_.end() && glides->second == velocities(pair);
    return as_then ? Overlap::glides : Overlap::meets;
  }

  // Most pairs have changed their ways before it comes to that.
  void look_closely(const Prospect& prospect) {
    const IndexPair pair = prospect.hit.pair;
    const double from = seen_from(pair);
    std::optional<Hit> met = pairs_.meeting(pair, from, end_, overlap_of(pair));
    if (!met) return;
    met->time += from;
    if (met->time <= while_from_ || met->time > while_to_) return;
    expect({*std::move(met), true, prospect.stage_a, prospect.stage_b});
  }

  bool is_gentle(const Hit& hit) const {
    return std::ranges::all_of(hit.touches, [&, ways = velocities(hit.pair)](const Touch& touch) {
      return flatray::is_gentle(touch.place.normal, ways.first, ways.second);
    });
  }

  // Whether both go on as before.
  bool changes_nothing(const Hit& hit, const Changes& changes) const {
    const auto goes_on = [&](std::uint32_t body) {
      const auto change = changes.find(body);
      return change == changes.end() ||
             (!change->second.gone && change->second.velocity == stages_[body].back().velocity);
    };
    return goes_on(hit.pair.first) && goes_on(hit.pair.second);
  }

  // Velocities that change by no more than their last bits would for ever.
  void leave_gentle(std::vector<Hit>& hits) {
    std::erase_if(hits, [&](const Hit& hit) {
      if (!is_gentle(hit)) return false;
      gliding_[hit.pair] = velocities(hit.pair);
      foresee(hit.pair);
      return true;
    });
  }

  // Whether there is a way out.
  bool respond(std::span<const Hit> hits) {
    const auto changes = instants_.respond(hits, now_);
    if (!changes) return false;
    for (const Hit& hit : hits)
      if (instants_.is_mark(hit.pair))  // as long as they overlap it is one meeting
        left_alone_.insert(hit.pair);
      else if (is_gentle(hit) && changes_nothing(hit, *changes))
        gliding_[hit.pair] = velocities(hit.pair);
    for (const auto& [body, change] : *changes) {
      stages_[body].push_back({now_, pairs_.place(body, now_), change.velocity, change.gone});
      near_.change(body, stages_[body].back());
    }
    for (const auto& changed : *changes)
      near_.each_near(changed.first, [&, body = changed.first](std::uint32_t k) {
        const bool told = k < body && changes->count(k) > 0;
        if (!told) foresee(std::minmax(body, k));
      });
    return true;
  }

  const std::span<const SimulatedBody> bodies_;
  const double end_;
  NearBodies near_;
  double length_ = 0;                     // of a while
  double while_from_ = 0, while_to_ = 0;  // events after the one, up to the other
  double now_ = 0;                        // the last time at which something met
  double stands_from_ = -1;               // since when time stands still
  std::size_t at_once_ = 0;               // events since then, but for the first
  std::vector<std::vector<Stage>> stages_;
  BodyPairs pairs_;
  Instants instants_;
  std::vector<Tally> tallies_;
  std::optional<Hit> accumulates_;  // when, and whose
  std::size_t responding_ = 0;
  std::vector<IndexPair> overlaps_;                     // at time 0
  std::set<IndexPair> left_alone_;                      // marks and what they lie in
  std::map<IndexPair, std::pair<Vec2, Vec2>> gliding_;  // as long as these are their velocities
  std::vector<Prospect> ahead_;                         // a heap
  std::size_t most_ahead_ = 0;  // until those that came to nothing are looked for
};

}  // namespace

Simulation simulate(std::span<const SimulatedBody> bodies, double end, std::size_t most_events,
                    PairSearch search) {
  return Run(bodies, end, search).run(most_events);
}

}  // namespace flatray
