#include <fmt/core.h>

#include "study/blocks.h"
#include "study/estimate.h"
#include "study/room.h"

namespace flatray {
namespace {

constexpr std::uint64_t kBounces =
    100;  // of one orbit: many orbits, so that their mean has an error
constexpr double kPi = 0x1.921fb54442d18p+1;

// By orbit: the way flown and the flights it is made of.
class Flights : public OrbitSink {
 public:
  explicit Flights(std::size_t orbits) : lengths_(orbits), flights_(orbits) {}
  void bounce(std::size_t number, const Bounce& bounce) override {
    lengths_[number] = bounce.path_length;
    ++flights_[number];
  }
  void end(std::size_t, const OrbitStop& stop) override {
    if (stop.end == OrbitEnd::escape) ++escaped_;
    if (stop.end == OrbitEnd::corner) ++corners_;
  }
  Numbers numbers() const {
    RatioSums sums;
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      if (flights_[i] > 0) sums.add(lengths_[i], flights_[i]);
    Numbers all{escaped_, corners_};
    sums.append_to(all);
    return all;
  }

 private:
  std::vector<double> lengths_, flights_;
  double escaped_ = 0, corners_ = 0;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  if (const double area = room.solids().free_area(); !(area > 0))
    return fail(context.scene.chambers.front().where,
                fmt::format("the chamber encloses an area of {:.6g}", area),
                "give it an outline that is closed, larger than its pillars");
  const auto plan = plan_orbits(context, kBounces);
  if (!plan) return tl::unexpected(plan.error());
  const Blocks blocks = Blocks::of(plan->orbits);
  auto found = run_blocks(context, blocks.count(), [&](std::size_t block) {
    Flights flights(static_cast<std::size_t>(blocks.end(block) - blocks.begin(block)));
    follow_random(room, context.seed, blocks.begin(block), blocks.end(block), plan->bounces,
                  flights);
    return flights.numbers();
  });
  if (!found) return fail(std::move(found));
  RatioSums sums;
  double escaped = 0, corners = 0;
  for (const Numbers& block : *found) {
    escaped += block[0];
    corners += block[1];
    sums += RatioSums::from(std::span(block).subspan(2));
  }
  const double area = room.solids().free_area(), expected = kPi * area / room.perimeter();
  return measured(
      context, "mean_free_path",
      fmt::format("Mean free path of {:.0f} flights in {} orbits, beside pi A / P (Santalo), A = "
                  "{:.6g}, P = {:.6g}",
                  sums.y, plan->orbits, area, room.perimeter()),
      {{"mean_free_path", sums.ratio(), sums.standard_error(), expected},
       {"orbits_escaped", escaped, 0, 0},
       {"orbits_into_corners", corners, 0, std::nullopt}});
}

}  // namespace

namespace experiment_entries {
extern const Experiment mean_free_path = {
    "mean-free-path",
    "How far does a ray fly between two walls, and is that pi A / P?",
    &run,
    {.count = true, .bounces = true, .seed = true, .resume = true}};
}  // namespace experiment_entries

}  // namespace flatray
