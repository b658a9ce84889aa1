#include "anim/rigid_motion.h"

#include <algorithm>

#include "anim/frame_state.h"
#include "base/portable_math.h"
#include "geom/turn.h"
#include "scene/curve.h"
#include "scene/responses.h"

namespace flatray {
namespace {

// Of what a place adds up, more than its terms are rounded by.
constexpr double kRounding = 0x1p-49;

// The place and angle of an entity or a group as seen from the group it stands in.
struct Level {
  Cubic<Vec2> at;
  Cubic<double> angle;
  double sizes, angles;  // of all that its place and its angle add up
};

double way_gone(const Follow& follow, double time) {
  return follow.start + follow.speed * (time / follow.duration);
}

void add_knots(const Scene& scene, const Motion& motion, double from, double to,
               std::vector<double>& knots) {
  const auto add = [&](double time) {
    if (time > from && time < to) knots.push_back(time);
  };
  for (const std::optional<CurveId>& curve : {motion.x, motion.y, motion.angle})
    if (curve) {
      const std::vector<double>& times = scene.curves[*curve].times;
      for (auto at = std::upper_bound(times.begin(), times.end(), from);
           at != times.end() && *at < to; ++at)
        knots.push_back(*at);
    }
  if (!motion.follow || motion.follow->speed == 0) return;
  const Follow& follow = *motion.follow;
  const double first = way_gone(follow, from), last = way_gone(follow, to);
  corners_between(
      scene.paths[follow.path], std::min(first, last), std::max(first, last),
      [&](double corner) { add((corner - follow.start) / follow.speed * follow.duration); });
}

Cubic<double> curve_part(const Scene& scene, const std::optional<CurveId>& curve, double from,
                         double to) {
  return curve ? cubic_between(scene.curves[*curve], from, to) : linear(0, 0);
}

double largest(const Scene& scene, const std::optional<CurveId>& curve) {
  return curve ? scene.curves[*curve].largest : 0;
}

// On the edge it walks in the middle of the time.
void add_follow(const Scene& scene, const Follow& follow, double from, double to, Level& level) {
  const Path& path = scene.paths[follow.path];
  const auto way = [&](double time) { return way_gone(follow, time); };
  const double middle = way(from + 0.5 * (to - from)), whole = path.lengths.back();
  const PathPoint point = point_at(path, middle);
  const Vec2 forward = unit(point.direction);
  const bool stands = !path.closed && (middle <= 0 || middle >= whole);
  const Vec2 pace = stands ? Vec2(0, 0) : forward;
  const auto there = [&](double t) { return Vec2(point.at + (way(t) - middle) * pace); };
  level.at = level.at + linear(there(from), there(to) - there(from));
  level.sizes += point.at.lpNorm<1>() + whole + 4 * std::fabs(follow.start) +
                 4 * std::fabs(way(from)) + 4 * std::fabs(way(to));
  if (!follow.turn) return;
  level.angle.c[0] += portable::atan2(point.direction.y(), point.direction.x());
  level.angles += 4;
}

// In the order in which frames add it up.
Level level_of(const Scene& scene, const Movable& thing, double from, double to) {
  const Motion& motion = thing.motion;
  const Cubic<double> x = curve_part(scene, motion.x, from, to),
                      y = curve_part(scene, motion.y, from, to),
                      angle = curve_part(scene, motion.angle, from, to);
  Level level{linear(thing.at, {0, 0}), linear(thing.angle, 0) + angle, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) level.at.c[i] += Vec2(x.c[i], y.c[i]);
  level.sizes = thing.at.lpNorm<1>() + 8 * (largest(scene, motion.x) + largest(scene, motion.y));
  level.angles = std::fabs(thing.angle) + 8 * largest(scene, motion.angle) +
                 std::fabs(thing.angular_velocity) * (std::fabs(from) + std::fabs(to));
  if (motion.follow) add_follow(scene, *motion.follow, from, to, level);
  level.angle =
      level.angle + linear(from * thing.angular_velocity, (to - from) * thing.angular_velocity);
  return level;
}

void add_way(Level& level, const Vec2& from, const Vec2& way) {
  level.at = level.at + linear(from, way);
  level.sizes += from.lpNorm<1>() + way.lpNorm<1>();
}

Cubic<Vec2> turned(const Turn& by, Cubic<Vec2> way) {
  for (Vec2& p : way.c) p = Vec2(by.cos * p.x() - by.sin * p.y(), by.sin * p.x() + by.cos * p.y());
  return way;
}

// Seen from what has been gone through so far.
void carry(Carried& carried, const Level& level) {
  RigidMotion& motion = carried.motion;
  const Cubic<Vec2> arm = carried.scale * level.at;
  motion.doubt +=
      kRounding * (carried.scale * level.sizes + arm.sum(1)) + motion.angle_doubt * arm.sum(1);
  const bool turns = !motion.angle.is_constant();
  if (turns && arm.sum(1) > 0)
    motion.swings.push_back({arm, motion.angle});
  else if (!turns)
    motion.at = motion.at + turned(turn(motion.angle.c[0]), arm);
  motion.angle = motion.angle + level.angle;
  motion.angle_doubt += kRounding * level.angles;
}

// From the outermost one below `top` to the one an entity stands in.
std::vector<std::uint32_t> groups_below(const Scene& scene, std::uint32_t entity,
                                        std::optional<std::uint32_t> top) {
  std::vector<std::uint32_t> chain;
  for (auto at = scene.entities[entity].group; at && at != top; at = scene.groups[*at].group)
    chain.push_back(*at);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

std::vector<double> TrueMotion::knots(std::uint32_t entity, std::optional<std::uint32_t> top,
                                      double from, double to) const {
  const Scene& scene = timeline_->scene();
  std::vector<double> knots;
  add_knots(scene, scene.entities[entity].motion, from, to, knots);
  for (const std::uint32_t group : groups_below(scene, entity, top))
    add_knots(scene, scene.groups[group].motion, from, to, knots);
  std::ranges::sort(knots);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

Carried TrueMotion::between(std::uint32_t entity, std::optional<std::uint32_t> top, unsigned frame,
                            double from, double to) const {
  const Scene& scene = timeline_->scene();
  Carried carried;
  for (const std::uint32_t number : groups_below(scene, entity, top)) {
    const Group& group = scene.groups[number];
    Level level = level_of(scene, group, from, to);
    add_way(level, from * group.velocity, (to - from) * group.velocity);
    carry(carried, level);
    carried.scale *= group.scale.value;
  }
  const Entity& thing = scene.entities[entity];
  Level level = level_of(scene, thing, from, to);
  if (!thing.markov) {
    add_way(level, from * thing.velocity, (to - from) * thing.velocity);
  } else {
    const Vec2 moved = timeline_->markov(entity, frame).moved,
               next = timeline_->markov(entity, to > from ? frame + 1 : frame).moved,
               way = next - moved;
    const double fps = scene.fps, begin = (frame - 1) / fps;
    add_way(level, moved + (from - begin) * fps * way, (to - from) * fps * way);
  }
  carry(carried, level);
  return carried;
}

std::optional<std::uint32_t> group_of_both(const Scene& scene, std::uint32_t a, std::uint32_t b) {
  auto one = scene.entities[a].group, other = scene.entities[b].group;
  while (one && other && *one != *other)  // groups stand in ones of a lower number
    (*one > *other ? one : other) = scene.groups[std::max(*one, *other)].group;
  return one && other ? one : std::nullopt;
}

bool keeps_velocity_in(const Scene& scene, std::uint32_t entity, std::uint32_t group) {
  const Entity& e = scene.entities[entity];
  return e.group == group && !e.markov && !e.motion.any() && e.angular_velocity == 0;
}

double corners_a_frame(const Scene& scene, const Motion& motion) {
  if (!motion.follow || !scene.paths[motion.follow->path].closed) return 0;
  const Path& path = scene.paths[motion.follow->path];
  const double way = std::fabs(motion.follow->speed) / motion.follow->duration / scene.fps;
  const double rounds = way / path.lengths.back();
  return rounds < 1 ? 0 : rounds * static_cast<double>(path.points.size());
}

Bounds box_around(const RigidMotion& motion) {
  const Bounds box = box_about(motion.at.bezier_points(1));
  double most = 0;
  for (const Swing& swing : motion.swings) most += swing.arm.most(1);
  const double rounding = motion.doubt + 0x1p-40 * (motion.at.sum(1) + most);
  const Vec2 reach(most + rounding, most + rounding);
  return {box.low - reach, box.high + reach};
}

}  // namespace flatray
