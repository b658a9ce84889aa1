#include <fmt/core.h>

#include <array>
#include <cmath>

#include "base/portable_math.h"
#include "study/blocks.h"
#include "study/room.h"
#include "study/starts.h"
#include "study/wall_places.h"

namespace flatray {
namespace {

constexpr std::uint64_t kBounces = 1000;  // of one orbit
constexpr std::uint64_t kSettling = 20;   // bounces that turn any first difference to the fastest

// How two orbits an infinitesimal way apart part, across the ray: apart by q, at an angle p. A
// flight of length t adds t p to q; a mirror of curvature k adds 2 k q / cos(incidence) to p and
// turns both round (Sinai 1970). Lengths are in extents of the room, so that units do not matter.
struct Tangent {
  double q = 1, p = 1;

  void fly(double t) { q += t * p; }
  void reflect(double bend) {
    p = -(p + bend * q);
    q = -q;
  }
  // Brings its length back to 1; gives the logarithm of what it was.
  double restore() {
    const double size = std::sqrt(q * q + p * p);
    q /= size;
    p /= size;
    return portable::log(size);
  }
};

class Growth : public OrbitSink {
 public:
  Growth(const Surfaces& walls, Starts starts, std::uint64_t begin, std::uint64_t end,
         std::uint64_t bounces)
      : walls_(walls),
        starts_(starts),
        begin_(begin),
        extent_(bounds_of(walls).size().maxCoeff()),
        half_(kSettling + (bounces - kSettling) / 2),
        states_(end - begin) {}

  void bounce(std::size_t number, const Bounce& bounce) override {
    State& state = states_[number];
    const double bend = curvature(walls_, bounce.surface, bounce.point, bounce.normal);
    state.tangent.fly(bounce.t / extent_);
    state.tangent.reflect(bend == 0 ? 0 : 2 * bend * extent_ / portable::cos(bounce.incidence()));
    const double grown = state.tangent.restore();
    if (++state.bounces <= kSettling) return;
    state.grown += grown;
    state.late += state.bounces > half_ ? grown : 0;
    state.length += bounce.t;
    state.curved += bend != 0 ? 1 : 0;
  }
  void end(std::size_t, const OrbitStop&) override {}

  Numbers numbers() const {
    StartSums length(starts_), hits(starts_), curved(starts_), late(starts_);
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const State& state = states_[i];
      if (state.bounces <= kSettling) continue;
      length.add(begin_ + i, state.grown, state.length);
      hits.add(begin_ + i, state.grown, static_cast<double>(state.bounces - kSettling));
      curved.add(begin_ + i, state.grown, state.curved);
      if (state.bounces > half_)
        late.add(begin_ + i, state.late, static_cast<double>(state.bounces - half_));
    }
    Numbers all;
    for (const StartSums& sums : {length, hits, curved, late}) sums.append_to(all);
    return all;
  }

 private:
  struct State {
    Tangent tangent;
    std::uint64_t bounces = 0;
    double grown = 0, length = 0, curved = 0, late = 0;
  };
  const Surfaces& walls_;
  Starts starts_;
  std::uint64_t begin_;  // the number of the first
  double extent_;
  std::uint64_t half_;  // bounces, of which what comes after counts as late
  std::vector<State> states_;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  const auto plan = plan_orbits(context, kBounces + kSettling);
  if (!plan) return tl::unexpected(plan.error());
  if (plan->bounces < 2 * kSettling)
    return fail(named_place("--bounces"),
                fmt::format("{} are too few for an exponent", plan->bounces),
                fmt::format("say --bounces {} or more, of which the first {} do not count, and "
                            "--count of several times as many",
                            2 * kSettling, kSettling),
                Trouble::usage);
  const Blocks blocks = Blocks::of(plan->orbits);
  auto found = run_blocks(context, blocks.count(), [&](std::size_t block) {
    Growth growth(room.walls(), context.starts, blocks.begin(block), blocks.end(block),
                  plan->bounces);
    follow_drawn(context, room, blocks.begin(block), blocks.end(block), plan->bounces, growth);
    return growth.numbers();
  });
  if (!found) return fail(std::move(found));
  const std::size_t size = StartSums::size(context.starts);
  std::array<RatioSums, 4> sums;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    StartSums all(context.starts);
    for (const Numbers& block : *found)
      all += StartSums::from(context.starts, std::span(block).subspan(size * i, size));
    sums[i] = all.all();
  }
  std::vector<Measure> measures;
  const std::array names = {"per_length", "per_hit", "per_curved_hit",
                            "per_hit_second_half"};  // falls where growth is no exponential
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i].y > 0) measures.push_back({names[i], sums[i].ratio(), sums[i].standard_error()});
  return measured(
      context, "lyapunov",
      fmt::format("Lyapunov exponent, {:.0f} bounces of {} orbits", sums[1].y, plan->orbits),
      std::move(measures));
}

}  // namespace

namespace experiment_entries {
extern const Experiment lyapunov = {
    "lyapunov",
    "How fast do two orbits part that start next to each other?",
    &run,
    {.count = true, .bounces = true, .seed = true, .starts = true, .resume = true}};
}  // namespace experiment_entries

}  // namespace flatray
