#include "study/rooms/boundary_orbits.h"

#include "study/rooms/followed.h"
#include "study/statistics/blocks.h"

namespace flatray {
namespace {

constexpr std::uint64_t kOrbitsABlock = 4;

class Points : public OrbitSink {
 public:
  Points(const Room& room, std::size_t orbits,
         const std::function<std::unique_ptr<BoundaryWatch>()>& make_watch)
      : room_(room) {
    for (std::size_t i = 0; i < orbits; ++i) watches_.push_back(make_watch());
  }
  void bounce(std::size_t number, const Bounce& bounce) override {
    watches_[number]->see(
        {room_.place_of(bounce) / room_.perimeter(), sine_of(bounce.out, bounce.normal)});
  }

  Numbers numbers() const {
    Numbers all;
    for (const auto& watch : watches_) {
      const Numbers found = watch->numbers();
      all.push_back(static_cast<double>(found.size()));
      all.insert(all.end(), found.begin(), found.end());
    }
    return all;
  }

 private:
  const Room& room_;
  std::vector<std::unique_ptr<BoundaryWatch>> watches_;
};

}  // namespace

Result<BoundaryOrbits> boundary_orbits(const ExperimentContext& context, const Room& room,
                                       std::uint64_t random_orbits) {
  auto watched = orbits_to_watch(context, room, random_orbits);
  if (!watched) return fail(std::move(watched));
  const std::uint64_t orbits = watched->starts.size();
  return BoundaryOrbits{std::move(*watched),
                        context.bounces.value_or((context.count + orbits - 1) / orbits)};
}

Result<std::vector<Measure>> watch_bounces(
    const ExperimentContext& context, const Room& room, const BoundaryOrbits& orbits,
    const std::function<std::unique_ptr<BoundaryWatch>()>& make_watch,
    const std::function<void(std::size_t orbit, std::span<const double> found)>& take) {
  const std::span starts(orbits.orbits.starts);
  const Blocks blocks{starts.size(), kOrbitsABlock};
  std::size_t orbit = 0;
  auto ran = fold_blocks(
      context, blocks.count(),
      [&](std::size_t block) {
        const auto some =
            starts.subspan(blocks.begin(block), blocks.end(block) - blocks.begin(block));
        Points points(room, some.size(), make_watch);
        follow_starts(context, room, some, orbits.bounces, points);
        return points.numbers();
      },
      [&](const Numbers& block) {
        for (std::span<const double> rest(block); !rest.empty();) {
          const auto size = static_cast<std::size_t>(rest.front());
          take(orbit++, rest.subspan(1, size));
          rest = rest.subspan(1 + size);
        }
      });
  if (!ran) return fail(std::move(ran));
  return audit(context, room, starts, orbits.bounces);
}

}  // namespace flatray
