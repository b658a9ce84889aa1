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
#include "oracle/turning_contact.h"
#include "scene/responses.h"

namespace flatray {
namespace {

using Pair = PairTruth::Pair;

// An entity for a stretch of time in which it moves straight, and turns evenly. Parts lie as placed,
// of what turns as seen from where it turns about.
struct Body {
  std::vector<ShapePart> parts;
  Vec2 velocity{0, 0};
  Vec2 at{0, 0};
  double angle = 0, spin = 0;
};

enum class Answer { apart, meet, grazing };

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

Answer polygons_meet(const Body& a, const Body& b, double length) {
  const double way = (a.velocity - b.velocity).norm() * length;
  for (const ShapePart& p : a.parts)
    for (const ShapePart& q : b.parts)
      if (!far_apart(about(p.ring), about(q.ring), way) &&
          oracle::contact_truth(p.ring, a.velocity, q.ring, b.velocity, {0, length}).kind !=
              HitClass::miss)
        return Answer::meet;
  return Answer::apart;
}

// A part times a power of two: the oracle wants sizes about 1.
struct Core {
  std::vector<Vec2> ring;
  oracle::TurningCore core;

  Core(const ShapePart& part, const Body& body, double scale) {
    for (const Vec2& p : part.ring) ring.push_back(scale * p);
    core = {ring,     scale * part.radius, scale * body.at, scale * body.velocity, body.angle,
            body.spin};
  }
};

double size_of(const ShapePart& part) { return about(part.ring).reach + part.radius; }

Answer cores_meet(const Body& a, const Body& b, double length) {
  Answer answer = Answer::apart;
  for (const ShapePart& p : a.parts)
    for (const ShapePart& q : b.parts) {
      const double size = std::max({size_of(p), size_of(q), 0x1p-500});
      const double scale = std::ldexp(1.0, -std::ilogb(size));
      const Core one(p, a, scale), other(q, b, scale);
      const auto kind = oracle::first_touch(one.core, other.core, length).kind;
      if (kind == oracle::FirstTouch::Kind::touch) return Answer::meet;
      if (kind == oracle::FirstTouch::Kind::unknown) answer = Answer::grazing;
    }
  return answer;
}

class Search {
 public:
  Search(const Timeline& timeline, unsigned last_frame, double seconds)
      : timeline_(timeline), scene_(timeline.scene()), last_(last_frame), seconds_(seconds) {
    for (unsigned frame = 1; frame <= last_; ++frame)
      states_.push_back(entity_states(timeline_, frame));
    bent_.assign(scene_.entities.size(), false);
    left_out_.assign(scene_.entities.size(), false);
    for (const std::vector<EntityState>& frame : states_) {
      std::vector<Whereabouts>& places = places_.emplace_back();
      for (std::size_t i = 0; i < frame.size(); ++i) {
        const Shape& shape = shape_of(scene_, frame[i]);
        const bool turns = frame[i].angle != states_.front()[i].angle;
        if (!shape.circles.empty() || turns) bent_[i] = true;
        if (has_parts_left_out(shape) || !shape.arc_paths.empty()) left_out_[i] = true;
        const Bounds box = shape_bounds(shape, pose(frame[i].at, frame[i].angle, frame[i].scale));
        const Vec2 beside = (box.centre() - frame[i].at).cwiseAbs() + box.size();
        places.push_back(turns ? Whereabouts{frame[i].at, 2 * beside.norm()}
                               : Whereabouts{box.centre(), box.size().norm()});
      }
    }
  }

  PairTruth run() {
    const double start = processor_seconds();
    const std::vector<Pair> pairs = all_pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (i > 0 && processor_seconds() - start >= seconds_) {
        truth_.cut = pairs.size() - i;
        break;
      }
      const auto& [a, b] = pairs[i];
      const Answer answer = pair_meets(a, b);
      if (answer == Answer::grazing) {
        ++truth_.grazing;
        continue;
      }
      truth_.compared.insert(pairs[i]);
      if (bent_[a] || bent_[b]) ++truth_.bent;
      if (answer == Answer::meet) truth_.meet.insert(pairs[i]);
    }
    return std::move(truth_);
  }

 private:
  // Those to look at, in an order in which the first few are of all kinds.
  std::vector<Pair> all_pairs() {
    std::vector<Pair> pairs;
    const auto count = static_cast<std::uint32_t>(scene_.entities.size());
    for (std::uint32_t a = 0; a < count; ++a)
      for (std::uint32_t b = a + 1; b < count; ++b) {
        if (rests(scene_, a) && rests(scene_, b)) continue;
        if (left_out_[a] || left_out_[b])
          ++truth_.left_out;
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

  Body body(std::size_t frame, std::uint32_t entity, const Vec2& velocity, double turn) const {
    const EntityState& state = states_[frame][entity];
    const Shape& shape = shape_of(scene_, state);
    if (turn != 0)
      return {parts_of(shape, {{0, 0}, 1, 0, state.scale}), velocity, state.at, state.angle, turn};
    return {parts_of(shape, pose(state.at, state.angle, state.scale)), velocity};
  }

  Answer bodies_meet(const Body& a, const Body& b, bool bent, double length) const {
    return bent ? cores_meet(a, b, length) : polygons_meet(a, b, length);
  }

  Answer pair_meets(std::uint32_t a, std::uint32_t b) const {
    const bool bent = bent_[a] || bent_[b];
    if (keeps_velocity(scene_, a) && keeps_velocity(scene_, b)) {
      const Vec2 &v = scene_.entities[a].velocity, &w = scene_.entities[b].velocity;
      const double length = (last_ - 1.0) / scene_.fps;
      if (far_apart(places_[0][a], places_[0][b], (v - w).norm() * length)) return Answer::apart;
      return bodies_meet(body(0, a, v, 0), body(0, b, w, 0), bent, length);
    }
    Answer answer = Answer::apart;
    for (std::size_t frame = 0; frame + 1 < states_.size(); ++frame) {
      const Answer one = meet_in_frame(frame, a, b, bent);
      if (one == Answer::meet) return one;
      if (one == Answer::grazing) answer = one;
    }
    return answer;
  }

  Answer meet_in_frame(std::size_t frame, std::uint32_t a, std::uint32_t b, bool bent) const {
    const std::vector<EntityState>&now = states_[frame], &next = states_[frame + 1];
    const auto moved = [&](std::uint32_t i) {
      return body(frame, i, next[i].at - now[i].at,
                  turn_between(scene_, i, now[i].angle, next[i].angle));
    };
    const Vec2 way = (next[a].at - now[a].at) - (next[b].at - now[b].at);
    if (far_apart(places_[frame][a], places_[frame][b], way.norm())) return Answer::apart;
    return bodies_meet(moved(a), moved(b), bent, 1);
  }

  const Timeline& timeline_;
  const Scene& scene_;
  const unsigned last_;
  const double seconds_;
  std::vector<std::vector<EntityState>> states_;  // by frame
  std::vector<std::vector<Whereabouts>> places_;  // likewise
  std::vector<bool> bent_, left_out_;
  PairTruth truth_;
};

}  // namespace

std::string PairTruth::words() const {
  std::string text;
  if (compared.size() > bent || bent == 0)
    text = fmt::format("{} pairs of polygons by shadows in rationals (oracle/contact)",
                       compared.size() - bent);
  if (bent > 0)
    text += fmt::format(
        "{}{} pairs with discs or what turns by bisection in 256 bits (oracle/turning_contact)",
        text.empty() ? "" : ", ", bent);
  text += fmt::format("; {} of them meet", meet.size());
  if (grazing > 0) text += fmt::format("; {} graze too closely to be told", grazing);
  if (left_out > 0)
    text += fmt::format("; {} with arcs, ellipses or capsules are left out", left_out);
  return text;
}

PairTruth pair_truth(const Timeline& timeline, unsigned last_frame, double seconds) {
  return Search(timeline, last_frame, seconds).run();
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

}  // namespace flatray
