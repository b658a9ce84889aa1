#include "oracle/nearest.h"

#include <limits>
#include <variant>

#include "oracle/bezier.h"
#include "oracle/curves.h"

namespace flatray::oracle {
namespace {

// Of a Bezier curve it takes more than a square root.
using Time = std::variant<Surd, Algebraic>;
std::strong_ordering compare(const Time& a, const Time& b) {
  if (a.index() == 0 && b.index() == 0) return std::get<Surd>(a) <=> std::get<Surd>(b);
  const auto algebraic = [](const auto& t) { return Algebraic(t); };
  return std::visit(algebraic, a) <=> std::visit(algebraic, b);
}

// The first of the walls that are offered.
class First {
 public:
  explicit First(const Ray& ray) : ray_(ray) { wall_.by = NearestWall::By::rationals; }

  template <class Wall>
  void offer(std::int64_t number, const Wall& wall) {
    const auto met = first_wall_hit(ray_, wall);
    if (!met) return;
    const auto order = wall_ ? compare(met->t, best_) : std::strong_ordering::less;
    if (order > 0 || (order == 0 && number > wall_.wall)) return;
    best_ = met->t;
    wall_.wall = number;
    wall_.kind = met->kind;
    wall_.at_end = met->at_end;
    wall_.root = met->root;
  }

  NearestWall found() {
    if (wall_) wall_.t = std::visit([](const auto& t) { return t.nearest(); }, best_);
    return wall_;
  }

 private:
  const Ray& ray_;
  Time best_;
  NearestWall wall_;
};

std::optional<double> time_of(const Ray& ray, const Segment& wall, Root) {
  const auto met = first_wall_hit(ray, wall);
  return met ? std::optional(met->t.nearest()) : std::nullopt;
}
std::optional<double> time_of(const Ray& ray, const Arc& wall, Root root) {
  const auto met = root_of(ray, wall.curve, root);
  return met ? std::optional(met->nearest()) : std::nullopt;
}
std::optional<double> time_of(const Ray& ray, const Bezier& wall, Root root) {
  for (const BezierMeeting& met : meetings_with_bezier(ray, wall))
    if (met.root == root) return met.t.nearest();
  return std::nullopt;
}

}  // namespace

NearestWall nearest_wall(const Ray& ray, std::span<const Segment> walls) {
  First first(ray);
  for (std::size_t i = 0; i < walls.size(); ++i)
    first.offer(static_cast<std::int64_t>(i), walls[i]);
  return first.found();
}

std::optional<double> time_of(const Ray& ray, const Surfaces& walls, std::uint32_t wall,
                              Root root) {
  return walls.visit(wall, [&](const auto& met) { return time_of(ray, met, root); });
}

NearestWalls::NearestWalls(const Surfaces& walls) : walls_(walls) {
  for (const std::uint32_t number : walls.curve_numbers)
    reaches_.push_back(walls.visit(number, [](const auto& wall) { return reach_of(wall); }));
}

NearestWall NearestWalls::of(const Ray& ray) {
  find_candidates(ray, walls_.segments, straight_);
  long double first = std::numeric_limits<long double>::infinity();
  for (const Candidate& each : straight_) first = std::min(first, each.sure ? each.high : first);
  find_candidates(ray, reaches_, first, round_);
  if (round_.empty() && straight_.empty()) return {};
  const auto number = [](const auto& numbers, const Candidate& each) {
    return numbers[static_cast<std::size_t>(each.wall)];
  };
  if (round_.empty() && straight_.size() == 1 && straight_[0].sure) {
    const double t = static_cast<double>(straight_[0].low);
    if (t == static_cast<double>(straight_[0].high))
      return {number(walls_.segment_numbers, straight_[0]), HitClass::touch, false, t};
  }
  First nearest(ray);
  for (const Candidate& each : straight_)
    nearest.offer(number(walls_.segment_numbers, each),
                  walls_.segments[static_cast<std::size_t>(each.wall)]);
  for (const Candidate& each : round_) {
    const std::uint32_t curve = number(walls_.curve_numbers, each);
    walls_.visit(curve, [&](const auto& wall) { nearest.offer(curve, wall); });
  }
  return nearest.found();
}

}  // namespace flatray::oracle
