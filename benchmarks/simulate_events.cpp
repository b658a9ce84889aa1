// Elastic gases of discs and boxes: what an event costs where pairs that come near are looked at, against all pairs; the events
// must be the same.
#include <fmt/core.h>

#include <cmath>

#include "base/philox.h"
#include "collide/simulate.h"
#include "measure.h"

namespace {

using namespace flatray;

constexpr std::size_t kMostOfAll = 2000;  // events of all pairs

SimulatedBody box(const Vec2& low, const Vec2& high, double mass) {
  const Vec2 half = 0.5 * (high - low);
  return {{{{-half, {half.x(), -half.y()}, half, {-half.x(), half.y()}}, 0}},
          0.5 * (low + high),
          {0, 0},
          mass};
}

// One body in every cell of 2 x 2, as wide as 0.4 of it, between four walls.
std::vector<SimulatedBody> gas(std::size_t count) {
  const auto across = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(count))));
  const double side = 2 * static_cast<double>(across);
  std::vector<SimulatedBody> bodies = {
      box({-1, -1}, {0, side + 1}, kInfinity), box({side, -1}, {side + 1, side + 1}, kInfinity),
      box({0, -1}, {side, 0}, kInfinity), box({0, side}, {side, side + 1}, kInfinity)};
  for (std::size_t i = 0; i < across * across; ++i) {
    std::uint32_t draws = 0;
    const auto draw = [&](double low, double high) {
      return low + (high - low) * unit_double(random_bits(9, Stream::experiment, 2, i, draws++));
    };
    const Vec2 at(2 * static_cast<double>(i % across) + 1, 2 * static_cast<double>(i / across) + 1);
    const double vx = draw(-2, 2), vy = draw(-2, 2), mass = draw(0.5, 1.5);
    if (i % 2 == 0)
      bodies.push_back({{{{{0, 0}}, 0.4}}, at, {vx, vy}, mass});
    else
      bodies.push_back(box(at - Vec2(0.4, 0.3), at + Vec2(0.4, 0.3), mass));
    bodies.back().velocity = {vx, vy};
  }
  return bodies;
}

struct Run {
  Simulation done;
  double seconds;
};
Run run(const std::vector<SimulatedBody>& bodies, std::size_t events, PairSearch search) {
  const double start = bench::seconds(CLOCK_THREAD_CPUTIME_ID);
  Simulation done = simulate(bodies, 1e9, events, search);
  return {std::move(done), bench::seconds(CLOCK_THREAD_CPUTIME_ID) - start};
}

// Of the first events, as many as the shorter run has.
bool same(const Simulation& one, const Simulation& other) {
  const std::size_t count = std::min(one.events.size(), other.events.size());
  for (std::size_t i = 0; i < count; ++i) {
    const CollisionEvent &a = one.events[i], &b = other.events[i];
    if (a.time != b.time || a.a != b.a || a.b != b.b || a.point != b.point ||
        a.velocity_a != b.velocity_a || a.velocity_b != b.velocity_b)
      return false;
  }
  return true;
}

}  // namespace

int main() {
  bool all_same = true;
  fmt::print(
      "| bodies | events | near: start, ms | an event, us | all: start, ms | an event, us | same "
      "|\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (const std::size_t count : {100UL, 1000UL, 10'000UL}) {
    const std::vector<SimulatedBody> bodies = gas(count);
    const std::size_t events = 20 * count;
    const Run near_start = run(bodies, 1, PairSearch::near),
              near = run(bodies, events, PairSearch::near);
    const Run all_start = run(bodies, 1, PairSearch::all),
              all = run(bodies, kMostOfAll, PairSearch::all);
    const bool equal = same(near.done, all.done);
    all_same = all_same && equal;
    const auto each = [](const Run& first, const Run& whole) {
      return 1e6 * (whole.seconds - first.seconds) / static_cast<double>(whole.done.events.size());
    };
    fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {} |\n", count,
               near.done.events.size(), 1e3 * near_start.seconds, each(near_start, near),
               1e3 * all_start.seconds, each(all_start, all), equal ? "yes" : "NO");
  }
  return all_same ? 0 : 1;
}
