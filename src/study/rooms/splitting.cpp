#include "study/rooms/splitting.h"

#include <algorithm>
#include <set>

#include "base/philox.h"
#include "base/portable_math.h"
#include "study/rooms/followed.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

std::vector<double> ways_of(const std::vector<Walker>& walkers) {
  std::vector<double> ways(walkers.size());
  std::ranges::transform(walkers, ways.begin(), &Walker::way);
  return ways;
}

bool leads_on(const Room& room, const OrbitStart& start) {
  return leads_away(room.walls(), start.departed.surface, side_of_start(room, start),
                    start.ray.origin, start.ray.direction);
}

// As far as it still leads away from its wall.
void turn(const Room& room, OrbitStart& start, double angle) {
  const double c = portable::cos(angle), s = portable::sin(angle);
  Ray& ray = start.ray;
  const Vec2 before = ray.direction;
  for (const double sine : {s, -s}) {
    ray.direction = {c * before.x() - sine * before.y(), sine * before.x() + c * before.y()};
    if (leads_on(room, start)) return;
  }
  ray.direction = before;
}

constexpr std::uint64_t kFrame = std::uint64_t{1} << 31;  // of draws of clones: no start's

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

Sign side_of_start(const Room& room, const OrbitStart& start) {
  const std::uint32_t wall = start.departed.surface;
  const Sign here = room.walls().visit(wall, [&](const auto& one) {
    return root_departed(one, Sign::positive) == start.departed.root ? Sign::positive
                                                                     : Sign::negative;
  });
  return room.inner_side(wall).value_or(here);
}

Population::Population(const ExperimentContext& context, const Room& room,
                       const SplittingPlan& plan, std::uint64_t group)
    : context_(context), room_(room), plan_(plan), group_(group) {
  for (std::uint64_t i = 0; i < plan.orbits; ++i)
    walkers_.push_back(
        {room.draw_start(context.seed, group * plan.orbits + i), 0, static_cast<std::size_t>(i)});
}

void Population::advance() {
  std::vector<OrbitStart> starts;
  for (const Walker& one : walkers_) starts.push_back(one.at);
  std::vector<std::uint64_t> made(starts.size());
  std::vector<std::optional<Bounce>> last(starts.size());  // of those that make all bounces
  BounceSink sink([&](std::size_t number, const Bounce& bounce) {
    if (++made[number] == plan_.bounces) last[number] = bounce;
  });
  follow_starts(context_, room_, starts, plan_.bounces, sink);
  std::vector<Walker> left;
  for (std::size_t i = 0; i < last.size(); ++i)
    if (last[i])
      left.push_back({{{last[i]->point, last[i]->out}, departed_by(room_.walls(), *last[i])},
                      walkers_[i].way + last[i]->path_length,
                      walkers_[i].ancestor});
  walkers_ = std::move(left);
}

void Population::clone() {
  const std::vector<Walker> left = std::move(walkers_);
  walkers_.clear();
  for (std::uint64_t i = 0; i < plan_.orbits; ++i) {
    const auto draw = [&](std::uint32_t which) {
      return unit_double(
          random_bits(context_.seed, Stream::experiment, kFrame + group_, i, 2 * level_ + which));
    };
    const auto parent = static_cast<std::size_t>(draw(0) * static_cast<double>(left.size()));
    walkers_.push_back(left[std::min(parent, left.size() - 1)]);
    turn(room_, walkers_.back().at, plan_.apart * (2 * draw(1) - 1));
  }
  ++level_;
}

SplitGroup split_group(const ExperimentContext& context, const Room& room,
                       const SplittingPlan& plan, std::uint64_t group) {
  SplitGroup found{std::vector<double>(plan.levels), {}, {}};
  Population population(context, room, plan, group);
  const std::vector<Walker>& left = population.walkers();
  double share = 1;
  for (std::uint64_t level = 0; level < plan.levels; ++level) {
    if (level > 0) population.clone();
    population.advance();
    share *= static_cast<double>(left.size()) / static_cast<double>(plan.orbits);
    found.share[level] = share;
    if (level == plan.first) found.first = ways_of(left);
    if (left.empty()) return found;
  }
  found.last = ways_of(left);
  std::set<std::size_t> ancestors;
  for (const Walker& one : left) ancestors.insert(one.ancestor);
  found.ancestors = static_cast<double>(ancestors.size());
  return found;
}

}  // namespace flatray
