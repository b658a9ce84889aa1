// Many moving convex polygons in one frame: pairs that the broad phase leaves, contacts, milliseconds, against all pairs one by
// one; the events must be the same.
#include "collide/broad_phase.h"

#include <fmt/core.h>

#include <cmath>

#include "base/parallel.h"
#include "base/philox.h"
#include "collide/contact_batch.h"
#include "measure.h"

namespace {

using namespace flatray;

constexpr double kFrame = 1.0 / 24;
constexpr std::size_t kMostBrute = 10'000;

struct Event {
  std::uint32_t a, b;
  double t;
  bool operator==(const Event&) const = default;
};

// Polygons of 3 to 8 corners, radius up to 1, an area of 16 for each, speeds up to 10.
class World {
 public:
  explicit World(std::size_t count) {
    const double side = 4 * std::sqrt(static_cast<double>(count));
    for (std::uint64_t i = 0; i < count; ++i) {
      std::uint32_t draws = 0;
      const auto draw = [&](double low, double high) {
        return low + (high - low) * unit_double(random_bits(7, Stream::experiment, 1, i, draws++));
      };
      const double x = draw(0, side), y = draw(0, side), radius = draw(0.3, 1),
                   turn = draw(0, 6.28);
      const int corners = 3 + static_cast<int>(draw(0, 6));
      const double vx = draw(-10, 10), vy = draw(-10, 10);
      std::vector<Vec2> ring;
      Bounds box;
      for (int k = 0; k < corners; ++k) {
        const double angle = turn + 6.283185307179586 * k / corners;
        ring.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
        box.add(ring.back());
      }
      shapes_.add(ring);
      boxes_.push_back(box);
      velocities_.emplace_back(vx, vy);
    }
  }

  std::vector<MovingPair> near_pairs() const {
    std::vector<Bounds> all;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      all.push_back(swept(boxes_[i], velocities_[i], kFrame));
    std::vector<MovingPair> pairs;
    for (const auto& [a, b] : overlapping_pairs(all))
      pairs.push_back({a, b, velocities_[a], velocities_[b]});
    return pairs;
  }
  std::vector<MovingPair> pairs_of(std::uint32_t a) const {
    std::vector<MovingPair> pairs;
    for (std::uint32_t b = a + 1; b < boxes_.size(); ++b)
      pairs.push_back({a, b, velocities_[a], velocities_[b]});
    return pairs;
  }
  std::vector<Contact> meet(const std::vector<MovingPair>& pairs, unsigned threads) const {
    std::vector<Contact> found(pairs.size());
    constexpr std::size_t kBlock = 4096;
    parallel_for((pairs.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
      const std::size_t from = block * kBlock, count = std::min(kBlock, pairs.size() - from);
      contacts(shapes_, std::span(pairs).subspan(from, count), {0, kFrame},
               std::span(found).subspan(from, count));
    });
    return found;
  }
  std::vector<Event> events(const std::vector<MovingPair>& pairs, unsigned threads) const {
    const std::vector<Contact> found = meet(pairs, threads);
    std::vector<Event> events;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (found[i].times) events.push_back({pairs[i].a, pairs[i].b, found[i].times.t_enter});
    return events;
  }
  std::vector<Event> brute_events() const {
    std::vector<Event> all;
    for (std::uint32_t a = 0; a < boxes_.size(); ++a)
      for (const Event& event : events(pairs_of(a), 1)) all.push_back(event);
    return all;
  }

 private:
  BodySet shapes_;
  std::vector<Bounds> boxes_;
  std::vector<Vec2> velocities_;
};

double milliseconds(const std::function<void()>& run, clockid_t clock) {
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const double start = bench::seconds(clock);
    run();
    times.push_back(bench::seconds(clock) - start);
  }
  return 1e3 * bench::median(times);
}

}  // namespace

int main() {
  bool same = true;
  fmt::print(
      "| polygons | pairs | tested | contacts | broad, ms | contacts, ms | all, 1 thread | all, 2 "
      "threads (wall) | brute force, ms | same events |\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::size_t count : {100UL, 1000UL, 10'000UL, 100'000UL}) {
    const World world(count);
    const std::vector<MovingPair> pairs = world.near_pairs();
    const std::vector<Event> events = world.events(pairs, 1);
    const double broad = milliseconds([&] { world.near_pairs(); }, CLOCK_THREAD_CPUTIME_ID);
    const double narrow = milliseconds([&] { world.events(pairs, 1); }, CLOCK_THREAD_CPUTIME_ID);
    const auto frame = [&](unsigned threads) {
      return [&world, threads] { world.events(world.near_pairs(), threads); };
    };
    const double one = milliseconds(frame(1), CLOCK_MONOTONIC),
                 two = milliseconds(frame(2), CLOCK_MONOTONIC);
    same = same && events == world.events(pairs, 2);
    std::string brute = "-", equal = "-";
    if (count <= kMostBrute) {
      const double start = bench::seconds(CLOCK_THREAD_CPUTIME_ID);
      const bool as_brute = world.brute_events() == events;
      brute = fmt::format("{:.1f}", 1e3 * (bench::seconds(CLOCK_THREAD_CPUTIME_ID) - start));
      equal = as_brute ? "yes" : "NO";
      same = same && as_brute;
    }
    fmt::print("| {} | {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {} | {} |\n", count,
               count * (count - 1) / 2, pairs.size(), events.size(), broad, narrow, one, two, brute,
               equal);
  }
  return same ? 0 : 1;
}
