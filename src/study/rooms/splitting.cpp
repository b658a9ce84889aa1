#include "study/rooms/splitting.h"

#include <algorithm>
#include <set>

#include "base/philox.h"
#include "base/portable_math.h"
#include "study/rooms/followed.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

struct Walker {
  OrbitStart at;
  double way = 0;  // up to there
  std::size_t ancestor = 0;
};

// Where walkers are after so many bounces, of those that made them.
class NextLevel : public OrbitSink {
 public:
  NextLevel(const Room& room, const std::vector<Walker>& from, std::uint64_t bounces)
      : room_(room), from_(from), limit_(bounces), made_(from.size()), last_(from.size()) {}

  void bounce(std::size_t number, const Bounce& bounce) override {
    if (++made_[number] == limit_) last_[number] = bounce;
  }
  void end(std::size_t, const OrbitStop&) override {}

  std::vector<Walker> left() const {
    std::vector<Walker> all;
    for (std::size_t i = 0; i < from_.size(); ++i)
      if (last_[i])
        all.push_back({{{last_[i]->point, last_[i]->out}, room_.left_by(*last_[i])},
                       from_[i].way + last_[i]->path_length,
                       from_[i].ancestor});
    return all;
  }

 private:
  const Room& room_;
  const std::vector<Walker>& from_;
  std::uint64_t limit_;
  std::vector<std::uint64_t> made_;
  std::vector<std::optional<Bounce>> last_;
};

std::vector<double> ways_of(const std::vector<Walker>& walkers) {
  std::vector<double> ways;
  for (const Walker& one : walkers) ways.push_back(one.way);
  return ways;
}

// Draws of one group, by level and orbit.
class Cloning {
 public:
  Cloning(const Room& room, std::uint64_t seed, std::uint64_t group, double apart)
      : room_(room), seed_(seed), group_(group), apart_(apart) {}

  std::vector<Walker> clones(const std::vector<Walker>& left, std::uint64_t count,
                             std::uint64_t level) const {
    std::vector<Walker> all;
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto draw = [&](std::uint64_t which) {
        return unit_double(random_bits(seed_, Stream::experiment, kFrame + group_, i,
                                       static_cast<std::uint32_t>(2 * level + which)));
      };
      const auto parent = static_cast<std::size_t>(draw(0) * static_cast<double>(left.size()));
      Walker clone = left[std::min(parent, left.size() - 1)];
      turn(clone.at, apart_ * (2 * draw(1) - 1));
      all.push_back(clone);
    }
    return all;
  }

 private:
  static constexpr std::uint64_t kFrame = std::uint64_t{1} << 31;  // no start's

  // As far as it still leads away from its wall.
  void turn(OrbitStart& start, double angle) const {
    const double c = portable::cos(angle), s = portable::sin(angle);
    Ray& ray = start.ray;
    const Vec2 before = ray.direction;
    for (const double sine : {s, -s}) {
      ray.direction = {c * before.x() - sine * before.y(), sine * before.x() + c * before.y()};
      if (leads_on(start)) return;
    }
    ray.direction = before;
  }
  bool leads_on(const OrbitStart& start) const {
    const std::uint32_t wall = start.left.surface;
    const Sign here = room_.walls().visit(wall, [&](const auto& one) {
      return root_left(one, Sign::positive) == start.left.root ? Sign::positive : Sign::negative;
    });
    const Sign side = room_.inner_side(wall).value_or(here);
    return leads_away(room_.walls(), wall, side, start.ray.origin, start.ray.direction);
  }

  const Room& room_;
  std::uint64_t seed_, group_;
  double apart_;
};

}  // namespace

Numbers SplitGroup::numbers() const {
  Numbers all{ancestors, static_cast<double>(share.size()), static_cast<double>(first.size())};
  for (const std::vector<double>* part : {&share, &first, &last})
    all.insert(all.end(), part->begin(), part->end());
  return all;
}

SplitGroup SplitGroup::from(std::span<const double> numbers) {
  const auto levels = static_cast<std::size_t>(numbers[1]);
  const auto first = static_cast<std::size_t>(numbers[2]);
  const auto part = [&](std::size_t begin, std::size_t count) {
    const auto some = numbers.subspan(3 + begin, count);
    return std::vector<double>(some.begin(), some.end());
  };
  return {part(0, levels), part(levels, first),
          part(levels + first, numbers.size() - 3 - levels - first), numbers[0]};
}

SplitGroup split_group(const ExperimentContext& context, const Room& room,
                       const SplittingPlan& plan, std::uint64_t group) {
  SplitGroup found{std::vector<double>(plan.levels), {}, {}};
  std::vector<Walker> walkers;
  for (std::uint64_t i = 0; i < plan.orbits; ++i)
    walkers.push_back(
        {room.draw_start(context.seed, group * plan.orbits + i), 0, static_cast<std::size_t>(i)});
  const Cloning cloning(room, context.seed, group, plan.apart);
  double share = 1;
  for (std::uint64_t level = 0; level < plan.levels; ++level) {
    std::vector<OrbitStart> starts;
    for (const Walker& one : walkers) starts.push_back(one.at);
    NextLevel next(room, walkers, plan.bounces);
    follow_starts(context, room, starts, plan.bounces, next);
    const std::vector<Walker> left = next.left();
    share *= static_cast<double>(left.size()) / static_cast<double>(plan.orbits);
    found.share[level] = share;
    if (level == plan.first) found.first = ways_of(left);
    if (left.empty()) break;
    if (level + 1 < plan.levels) {
      walkers = cloning.clones(left, plan.orbits, level);
      continue;
    }
    found.last = ways_of(left);
    std::set<std::size_t> ancestors;
    for (const Walker& one : left) ancestors.insert(one.ancestor);
    found.ancestors = static_cast<double>(ancestors.size());
  }
  return found;
}

}  // namespace flatray
