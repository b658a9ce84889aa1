#include "study/stability/pair_truth.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "anim/rigid_motion.h"
#include "base/counted.h"
#include "base/processor_time.h"
#include "base/shuffled.h"
#include "collide/meetings.h"
#include "collide/outline_contact.h"
#include "oracle/contact.h"
#include "oracle/turning_contact.h"
#include "scene/responses.h"

namespace flatray {
namespace {

using Pair = PairTruth::Pair;

// An entity for a stretch of time. Parts lie as placed if it is straight, else as seen from where
// it turns about.
struct Body {
  std::vector<ShapePart> parts;
  RigidMotion motion;
  bool straight = true;

  Vec2 velocity() const { return motion.at.c[1]; }
};

enum class Answer { apart, grazing, meet };

// About where an entity is in a frame, and how it goes on to the next.
struct Whereabouts {
  Vec2 centre{0, 0};
  double reach = 0;  // twice what is needed: roundings do not matter
  Vec2 way{0, 0};
  double strays = 0;  // as far as it may go beside that
};

// Whether two cannot come near each other on ways of so much together.
bool far_apart(const Whereabouts& a, const Whereabouts& b, double way) {
  return (a.centre - b.centre).norm() > a.reach + b.reach + 1.01 * way;
}

Whereabouts about(const std::vector<Vec2>& ring) {
  const Bounds box = box_about(ring);
  return {box.centre(), box.size().norm(), {0, 0}, 0};
}

Answer polygons_meet(const Body& a, const Body& b, double length) {
  const double way = (a.velocity() - b.velocity()).norm() * length;
  for (const ShapePart& p : a.parts)
    for (const ShapePart& q : b.parts)
      if (!far_apart(about(p.ring), about(q.ring), way) &&
          oracle::contact_truth({p.ring, a.velocity()}, {q.ring, b.velocity()}, {0, length}).kind !=
              HitClass::miss)
        return Answer::meet;
  return Answer::apart;
}

// A part times a power of two: the oracle wants sizes about 1.
oracle::TurningCore core_of(const ShapePart& part, const Body& body, double scale) {
  const RigidMotion& motion = body.motion;
  const Cubic<Vec2> at = scale * motion.at;
  const auto& angle = motion.angle.c;
  oracle::TurningCore core{.ring = {},
                           .radius = scale * part.radius,
                           .at = body.straight ? Vec2(0, 0) : at.c[0],
                           .velocity = at.c[1],
                           .angle = body.straight ? 0 : angle[0],
                           .spin = angle[1],
                           .angle_bends = {angle[2], angle[3]}};
  for (const Vec2& p : part.ring) core.ring.push_back(scale * p);
  if (!at.is_linear())
    core.swings.push_back(
        {{0, 0, at.c[2].x(), at.c[3].x()}, {0, 0, at.c[2].y(), at.c[3].y()}, {0, 0, 0, 0}});
  for (const Swing& swing : motion.swings) {
    oracle::CoreSwing& there = core.swings.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      there.x[i] = scale * swing.arm.c[i].x();
      there.y[i] = scale * swing.arm.c[i].y();
    }
    there.angle = swing.turned.c;
  }
  return core;
}

double size_of(const ShapePart& part) { return about(part.ring).reach + part.radius; }

Answer cores_meet(const Body& a, const Body& b, double length) {
  Answer answer = Answer::apart;
  for (const ShapePart& p : a.parts)
    for (const ShapePart& q : b.parts) {
      const double size = std::max({size_of(p), size_of(q), 0x1p-500});
      const double scale = std::ldexp(1.0, -std::ilogb(size));
      const auto kind =
          oracle::first_touch(core_of(p, a, scale), core_of(q, b, scale), length).kind;
      if (kind == oracle::FirstTouch::Kind::touch) return Answer::meet;
      if (kind == oracle::FirstTouch::Kind::unknown) answer = Answer::grazing;
    }
  return answer;
}

// The pairs of entities of which at least one moves. They are numbered, and not stored, as there may be many.
class PairsToTell {
 public:
  PairsToTell(const Scene& scene, const std::vector<bool>& not_told) {
    std::uint64_t all = 0, resting = 0;
    for (std::uint32_t i = 0; i < scene.entities.size(); ++i) {
      const bool still = rests(scene, i);
      ++all;
      if (still) ++resting;
      if (!not_told[i]) (still ? resting_ : moving_).push_back(i);
    }
    left_out = pairs_of(all) - pairs_of(resting) - size();
  }

  std::uint64_t size() const { return pairs_of(moving_.size()) + moving_.size() * resting_.size(); }
  // In a round of those that move each has pairs with the next, then with those next but one, and
  // so on half of the way round.
  Pair operator[](std::uint64_t i) const {
    const std::uint64_t count = moving_.size(), both = pairs_of(count), k = i < both ? i : i - both;
    const std::uint32_t a = moving_[k % count];
    const std::uint32_t b =
        i < both ? moving_[(k % count + 1 + k / count) % count] : resting_[k / count];
    return std::minmax(a, b);
  }

  std::uint64_t left_out = 0;  // one of them is not told

 private:
  static std::uint64_t pairs_of(std::uint64_t count) { return count * (count - 1) / 2; }
  std::vector<std::uint32_t> moving_, resting_;
};

class TouchFinder {
 public:
  TouchFinder(const Timeline& timeline, unsigned last_frame, double seconds)
      : timeline_(timeline),
        scene_(timeline.scene()),
        last_(last_frame),
        seconds_(seconds),
        motion_(timeline) {
    for (unsigned frame = 1; frame <= last_; ++frame)
      states_.push_back(entity_states(timeline_, frame));
    bent_.assign(scene_.entities.size(), false);
    left_out_.assign(scene_.entities.size(), false);
    for (std::size_t frame = 0; frame < states_.size(); ++frame) {
      places_.emplace_back();
      for (std::uint32_t i = 0; i < scene_.entities.size(); ++i) {
        const Shape& now = shape(frame, i);
        if (!now.circles.empty()) bent_[i] = true;
        if (has_parts_left_out(now) || !now.arc_paths.empty()) left_out_[i] = true;
        places_.back().push_back(whereabouts(frame, i));
      }
    }
  }

  // Until the clock has run for so long since `start`.
  PairTruth run(double start) {
    const PairsToTell pairs(scene_, left_out_);
    truth_.left_out = pairs.left_out;
    // So that the first few are of all kinds.
    const Shuffled order(pairs.size(), timeline_.seed(), Stream::experiment);
    for (std::uint64_t i = 0; i < order.size(); ++i) {
      if (i > 0 && processor_seconds() - start >= seconds_) {
        truth_.cut = order.size() - i;
        break;
      }
      const Pair pair = pairs[order[i]];
      const auto& [a, b] = pair;
      const Answer answer = pair_meets(a, b);
      if (answer == Answer::grazing) {
        ++truth_.grazing;
        continue;
      }
      truth_.compared.insert(pair);
      if (bent_[a] || bent_[b]) ++truth_.bent;
      if (answer == Answer::meet) truth_.meet.insert(pair);
    }
    return std::move(truth_);
  }

 private:
  // From the frame to the next.
  Whereabouts whereabouts(std::size_t frame, std::uint32_t entity) {
    const EntityState& state = states_[frame][entity];
    const Bounds box = shape_bounds(shape(frame, entity), pose(state.at, state.angle, state.scale));
    Whereabouts place{box.centre(), box.size().norm(), {0, 0}, 0};
    if (frame + 1 == states_.size()) return place;
    const double begin = seconds_at(frame), end = seconds_at(frame + 1);
    std::vector<double> times = motion_.knots(entity, std::nullopt, begin, end);
    const bool whole = times.empty();
    times.push_back(end);
    bool turns = false;
    for (double from = begin; const double to : times) {
      const RigidMotion motion =
          motion_.between(entity, std::nullopt, static_cast<unsigned>(frame) + 1, from, to).motion;
      from = to;
      turns |= !motion.angle.is_constant() || !whole;
      if (!whole || !motion.is_even() || turns) bent_[entity] = true;
      if (whole && motion.is_even()) {
        place.way = motion.at.c[1];
        continue;
      }
      place.strays += motion.at.sum_of_slope(1);
      for (const Swing& swing : motion.swings)
        place.strays += swing.arm.sum_of_slope(1) + swing.turned.sum_of_slope(1) * swing.arm.sum(1);
    }
    if (!turns) return place;
    const Vec2 beside = (box.centre() - state.at).cwiseAbs() + box.size();
    place.centre = state.at;
    place.reach = 2 * beside.norm();
    return place;
  }

  double seconds_at(std::size_t frame) const { return static_cast<double>(frame) / scene_.fps; }
  const Shape& shape(std::size_t frame, std::uint32_t entity) const {
    return shape_of(scene_, states_[frame][entity]);
  }

  Body straight_body(std::size_t frame, std::uint32_t entity, const Vec2& velocity) const {
    const EntityState& state = states_[frame][entity];
    return {parts_of(shape(frame, entity), pose(state.at, state.angle, state.scale)),
            {linear(state.at, velocity)}};
  }

  // From one time in a frame to another; all of it where there are no knots.
  Body body(std::size_t frame, std::uint32_t entity, double from, double to, bool whole) const {
    const auto [motion, scale] =
        motion_.between(entity, std::nullopt, static_cast<unsigned>(frame) + 1, from, to);
    const bool straight = motion.is_even() && motion.angle.is_constant();
    if (straight && whole)
      return straight_body(frame, entity,
                           states_[frame + 1][entity].at - states_[frame][entity].at);
    if (straight)
      return {parts_of(shape(frame, entity), pose(motion.at.c[0], motion.angle.c[0], scale)),
              {linear(motion.at.c[0], motion.at.c[1])}};
    return {parts_of(shape(frame, entity), {{0, 0}, 1, 0, scale}), motion, false};
  }

  Answer bodies_meet(const Body& a, const Body& b, bool bent, double length) const {
    return bent || !a.straight || !b.straight ? cores_meet(a, b, length)
                                              : polygons_meet(a, b, length);
  }

  Answer pair_meets(std::uint32_t a, std::uint32_t b) const {
    if (keeps_velocity(scene_, a) && keeps_velocity(scene_, b)) {
      const Vec2 &v = scene_.entities[a].velocity, &w = scene_.entities[b].velocity;
      const double length = (last_ - 1.0) / scene_.fps;
      if (far_apart(places_[0][a], places_[0][b], (v - w).norm() * length)) return Answer::apart;
      return bodies_meet(straight_body(0, a, v), straight_body(0, b, w), bent_[a] || bent_[b],
                         length);
    }
    Answer answer = Answer::apart;
    for (std::size_t frame = 0; frame + 1 < states_.size() && answer != Answer::meet; ++frame)
      answer = std::max(answer, meet_in_frame(frame, a, b));
    return answer;
  }

  Answer meet_in_frame(std::size_t frame, std::uint32_t a, std::uint32_t b) const {
    const Whereabouts &one = places_[frame][a], &other = places_[frame][b];
    const Vec2 way = one.way - other.way;
    if (far_apart(one, other, one.strays + other.strays + way.norm())) return Answer::apart;
    const double begin = seconds_at(frame), end = seconds_at(frame + 1);
    std::vector<double> times = motion_.knots(a, std::nullopt, begin, end);
    const std::vector<double> others = motion_.knots(b, std::nullopt, begin, end);
    times.insert(times.end(), others.begin(), others.end());
    std::ranges::sort(times);
    const bool whole = times.empty(), bent = bent_[a] || bent_[b];
    times.push_back(end);
    Answer answer = Answer::apart;
    for (double from = begin; const double to : times) {
      if (to == from) continue;
      answer = std::max(answer, bodies_meet(body(frame, a, from, to, whole),
                                            body(frame, b, from, to, whole), bent, 1));
      if (answer == Answer::meet) break;
      from = to;
    }
    return answer;
  }

  const Timeline& timeline_;
  const Scene& scene_;
  const unsigned last_;
  const double seconds_;
  const TrueMotion motion_;
  std::vector<std::vector<EntityState>> states_;  // by frame
  std::vector<std::vector<Whereabouts>> places_;  // likewise
  std::vector<bool> bent_, left_out_;
  PairTruth truth_;
};

}  // namespace

std::string PairTruth::words() const {
  std::string text;
  if (compared.size() > bent || bent == 0)
    text = counted(compared.size() - bent, "pair of polygons", "pairs of polygons") +
           " by shadows in rationals (oracle/contact)";
  if (bent > 0)
    text += fmt::format(
        "{}{} with discs or what turns by bisection in 256 bits (oracle/turning_contact)",
        text.empty() ? "" : ", ", counted(bent, "pair"));
  text += fmt::format("; {} of them meet", meet.size());
  if (grazing > 0) text += fmt::format("; {} graze too closely to be told", grazing);
  if (left_out > 0)
    text += fmt::format("; {} with arcs, ellipses or capsules are left out", left_out);
  return text;
}

PairTruth pair_truth(const Timeline& timeline, unsigned last_frame, double seconds) {
  const double start = processor_seconds();
  return TouchFinder(timeline, last_frame, seconds).run(start);
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
