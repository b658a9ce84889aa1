#include "study/pair_truth.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "anim/frame_state.h"
#include "base/philox.h"
#include "base/processor_time.h"
#include "collide/meetings.h"
#include "collide/outline_contact.h"
#include "oracle/contact.h"
#include "scene/responses.h"

namespace flatray {
namespace {

using Pair = PairTruth::Pair;

// An entity for a stretch of time in which it moves straight.
struct Body {
  std::vector<ShapePart> parts;
  Vec2 velocity{0, 0};
};

// About where an entity is in a frame.
struct Whereabouts {
  Vec2 centre{0, 0};
  double reach = 0;  // twice what is needed: roundings do not matter
};

// Whether two cannot come near each other on ways of so much together.
bool far_apart(const Whereabouts& a, const Whereabouts& b, double way) {
  return (a.centre - b.centre).norm() > a.reach + b.reach + 1.01 * way;
}

Whereabouts about(const std::vector<Vec2>& ring) {
  Bounds box;
  for (const Vec2& point : ring) box.add(point);
  return {box.centre(), box.size().norm()};
}

bool meet(const Body& a, const Body& b, const Range& within) {
  const double way = (a.velocity - b.velocity).norm() * within.high;
  for (const ShapePart& p : a.parts)
    for (const ShapePart& q : b.parts)
      if (!far_apart(about(p.ring), about(q.ring), way) &&
          oracle::contact_truth(p.ring, a.velocity, q.ring, b.velocity, within).kind !=
              HitClass::miss)
        return true;
  return false;
}

class Search {
 public:
  Search(const Timeline& timeline, unsigned last_frame, double seconds)
      : timeline_(timeline), scene_(timeline.scene()), last_(last_frame), seconds_(seconds) {
    for (unsigned frame = 1; frame <= last_; ++frame)
      states_.push_back(entity_states(timeline_, frame));
    round_.assign(scene_.entities.size(), false);
    for (const std::vector<EntityState>& frame : states_) {
      std::vector<Whereabouts>& places = places_.emplace_back();
      for (std::size_t i = 0; i < frame.size(); ++i) {
        const Shape& shape = shape_of(scene_, frame[i]);
        const bool turns = frame[i].angle != states_.front()[i].angle;
        if (has_parts_left_out(shape) || !shape.circles.empty() || !shape.arc_paths.empty() ||
            turns)
          round_[i] = true;
        const Bounds box = shape_bounds(shape, pose(frame[i].at, frame[i].angle, frame[i].scale));
        places.push_back({box.centre(), box.size().norm()});
      }
    }
  }

  PairTruth run() {
    const double start = processor_seconds();
    const std::vector<Pair> pairs = polygon_pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (i > 0 && processor_seconds() - start > seconds_) {
        truth_.cut = pairs.size() - i;
        break;
      }
      const auto& [a, b] = pairs[i];
      truth_.compared.insert(pairs[i]);
      if (pair_meets(a, b)) truth_.meet.insert(pairs[i]);
    }
    return std::move(truth_);
  }

 private:
  // Those to look at, in an order in which the first few are of all kinds.
  std::vector<Pair> polygon_pairs() {
    std::vector<Pair> pairs;
    const auto count = static_cast<std::uint32_t>(scene_.entities.size());
    for (std::uint32_t a = 0; a < count; ++a)
      for (std::uint32_t b = a + 1; b < count; ++b) {
        if (rests(scene_, a) && rests(scene_, b)) continue;
        if (round_[a] || round_[b])
          ++truth_.round;
        else
          pairs.push_back({a, b});
      }
    const auto key = [&](const Pair& pair) {
      return random_bits(timeline_.seed(), Stream::experiment, pair.first, pair.second);
    };
    std::sort(pairs.begin(), pairs.end(),
              [&](const Pair& p, const Pair& q) { return key(p) < key(q); });
    return pairs;
  }

  Body body(std::size_t frame, std::uint32_t entity, const Vec2& velocity) const {
    const EntityState& state = states_[frame][entity];
    return {parts_of(shape_of(scene_, state), pose(state.at, state.angle, state.scale)), velocity};
  }

  bool pair_meets(std::uint32_t a, std::uint32_t b) const {
    if (keeps_velocity(scene_, a) && keeps_velocity(scene_, b)) {
      const Vec2 &v = scene_.entities[a].velocity, &w = scene_.entities[b].velocity;
      const double length = (last_ - 1.0) / scene_.fps;
      return !far_apart(places_[0][a], places_[0][b], (v - w).norm() * length) &&
             meet(body(0, a, v), body(0, b, w), {0, length});
    }
    for (std::size_t frame = 0; frame + 1 < states_.size(); ++frame) {
      const auto way = [&](std::uint32_t entity) -> Vec2 {
        return states_[frame + 1][entity].at - states_[frame][entity].at;
      };
      const Vec2 v = way(a), w = way(b);
      if (!far_apart(places_[frame][a], places_[frame][b], (v - w).norm()) &&
          meet(body(frame, a, v), body(frame, b, w), {0, 1}))
        return true;
    }
    return false;
  }

  const Timeline& timeline_;
  const Scene& scene_;
  const unsigned last_;
  const double seconds_;
  std::vector<std::vector<EntityState>> states_;  // by frame
  std::vector<std::vector<Whereabouts>> places_;  // likewise
  std::vector<bool> round_;
  PairTruth truth_;
};

}  // namespace

std::string PairTruth::words() const {
  std::string text =
      fmt::format("{} pairs of polygons by shadows in rationals (oracle/contact), of which {} meet",
                  compared.size(), meet.size());
  if (round > 0)
    text += fmt::format("; {} pairs with discs, curves or what turns are left out", round);
  return text;
}

PairTruth pair_truth(const Timeline& timeline, unsigned last_frame, double seconds) {
  return Search(timeline, last_frame, seconds).run();
}

std::string no_pairs(const Scene& scene) {
  if (scene.entities.size() < 2) return "the scene has no two entities";
  if (scene.frames < 2) return "the scene has one frame";
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (!rests(scene, i)) return "";
  return "nothing moves";
}

PairErrors pair_errors(const PairTruth& truth, const std::set<PairTruth::Pair>& found) {
  PairErrors errors;
  for (const PairTruth::Pair& pair : truth.compared) {
    const bool meets = truth.meet.count(pair) > 0, told = found.count(pair) > 0;
    if (meets && !told) ++errors.missed;
    if (told && !meets) ++errors.invented;
  }
  return errors;
}

double wrong_share(const PairTruth& truth, const PairErrors& errors) {
  const std::size_t all = truth.meet.size() + errors.invented;
  return all == 0 ? 0
                  : static_cast<double>(errors.missed + errors.invented) / static_cast<double>(all);
}

}  // namespace flatray
