#include "study/rooms/boundary_orbits.h"

#include <algorithm>

#include "study/rooms/followed.h"
#include "study/statistics/blocks.h"

namespace flatray {
namespace {

constexpr std::uint64_t kOrbitsABlock = 4;

class Points : public OrbitSink {
 public:
  Points(const Room& room, std::span<const OrbitStart> starts)
      : room_(room), points_(starts.size()) {}
  void bounce(std::size_t number, const Bounce& bounce) override {
    points_[number].insert(points_[number].end(),
                           {room_.place_of(bounce) / room_.perimeter(), sine(bounce)});
  }
  void end(std::size_t, const OrbitStop&) override {}

  Numbers numbers() const {
    Numbers all;
    for (const Numbers& orbit : points_) {
      all.push_back(static_cast<double>(orbit.size()));
      all.insert(all.end(), orbit.begin(), orbit.end());
    }
    return all;
  }

 private:
  double sine(const Bounce& bounce) const {
    return bounce.out.dot(Vec2(-bounce.normal.y(), bounce.normal.x())) / bounce.out.norm();
  }
  const Room& room_;
  std::vector<Numbers> points_;
};

}  // namespace

Result<BoundaryOrbits> boundary_orbits(const ExperimentContext& context, const Room& room,
                                       std::uint64_t random_orbits) {
  auto watched = orbits_to_watch(context, room, random_orbits);
  if (!watched) return fail(std::move(watched));
  BoundaryOrbits all{std::move(*watched), {}, {}};
  const std::vector<OrbitStart>& starts = all.orbits.starts;
  const std::uint64_t bounces =
      context.bounces.value_or((context.count + starts.size() - 1) / starts.size());
  const Blocks blocks{starts.size(), kOrbitsABlock};
  auto found = run_blocks(context, blocks.count(), [&](std::size_t block) {
    const auto some =
        std::span(starts).subspan(blocks.begin(block), blocks.end(block) - blocks.begin(block));
    Points points(room, some);
    follow_starts(context, room, some, bounces, points);
    return points.numbers();
  });
  if (!found) return tl::unexpected(found.error());
  all.audit = audit(context, room, starts, bounces);
  for (const Numbers& block : *found)
    for (std::size_t i = 0; i < block.size();) {
      const auto count = static_cast<std::size_t>(block[i++]);
      std::vector<BoundaryPoint>& points = all.points.emplace_back();
      for (const std::size_t end = i + count; i < end; i += 2)
        points.push_back({block[i], block[i + 1]});
    }
  return all;
}

}  // namespace flatray
