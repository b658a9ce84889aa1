#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "base/processor_time.h"
#include "oracle/long_orbit.h"
#include "precise/certified_orbit.h"
#include "study/accuracy.h"
#include "study/room.h"

namespace flatray {
namespace {

// An orbit in doubles or certified, beside one in many bits.
struct Pair {
  Pair(const Scene& scene, std::uint64_t seed)
      : room(scene), mirrors(room.walls().size(), Material::mirror) {
    start = room.draw_start(seed, 0).ray;
  }
  Room room;
  std::vector<Material> mirrors;
  Ray start;
  std::vector<oracle::LongOrbit::Bounce> exact;
  Vec2 last{0, 0};
};

constexpr std::uint64_t kBounces = 128, kFewBounces = 8;
constexpr unsigned kFirstBits = 512, kMostBits = 1 << 14;

// The bounces up to which an orbit is the same in two numbers of bits.
std::size_t agreeing(const oracle::LongOrbit& a, const oracle::LongOrbit& b) {
  std::size_t count = 0;
  while (count < std::min(a.bounces.size(), b.bounces.size()) &&
         a.bounces[count].surface == b.bounces[count].surface &&
         a.bounces[count].point == b.bounces[count].point)
    ++count;
  return count;
}

// Bits are doubled until they tell all bounces, or time is up. Gives   the fewer of the two.
unsigned find_truth(Pair& pair, double seconds) {
  const double start = processor_seconds();
  const auto few = oracle::long_orbit(pair.room.walls(), pair.start, kFewBounces, kFirstBits);
  const double each = (processor_seconds() - start) / static_cast<double>(kFewBounces);
  // The two numbers of bits that are begun with take some four times as long as the fewer alone.
  const double allowed = seconds / std::max(4 * each, 1e-9);
  const std::uint64_t bounces =
      allowed > static_cast<double>(kBounces) ? kBounces
      : allowed < static_cast<double>(kFewBounces)
          ? kFewBounces
          : std::uint64_t{1} << (std::bit_width(static_cast<std::uint64_t>(allowed)) - 1);
  unsigned bits = kFirstBits;
  oracle::LongOrbit orbit = oracle::long_orbit(pair.room.walls(), pair.start, bounces, bits);
  for (;; bits *= 2) {
    oracle::LongOrbit finer = oracle::long_orbit(pair.room.walls(), pair.start, bounces, 2 * bits);
    const std::size_t same = agreeing(orbit, finer);
    pair.exact.assign(finer.bounces.begin(),
                      finer.bounces.begin() + static_cast<std::ptrdiff_t>(same));
    if (same == finer.bounces.size() || 2 * bits >= kMostBits ||
        processor_seconds() - start > seconds / 2)
      return bits;
    orbit = std::move(finer);
  }
}

std::function<Outcome()> judged(const std::shared_ptr<Pair>& pair, std::size_t bounces) {
  return [pair, bounces] {
    return Outcome{(pair->last - pair->exact[bounces - 1].point).stableNorm()};
  };
}

// The last bounce of an orbit of so many; an orbit that ends before has no right place.
Setting doubles(const std::shared_ptr<Pair>& pair, std::size_t bounces) {
  return {fmt::format("bounce {} in doubles", bounces), static_cast<double>(bounces),
          [pair, bounces] {
            const Orbit orbit =
                trace_orbit(pair->room.walls(), pair->mirrors, pair->start, bounces);
            pair->last = orbit.bounces.empty() ? pair->start.origin : orbit.bounces.back().point;
          },
          judged(pair, bounces)};
}

Setting certified(const std::shared_ptr<Pair>& pair, std::size_t bounces) {
  return {fmt::format("bounce {} certified", bounces), 0,
          [pair, bounces] {
            const auto orbit = certified_orbit(pair->room.walls(), pair->start, bounces);
            pair->last = orbit->bounces.empty() ? pair->start.origin : orbit->bounces.back().point;
          },
          judged(pair, bounces)};
}

std::string left_out(const Scene& scene) {
  if (const auto can = can_certify(); !can) return can.error().front().message;
  for (const auto expected : {&expect_closed, &expect_not_periodic})
    if (const auto met = expected({.scene = scene}); !met) return met.error().front().message;
  return "";
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  const auto pair = std::make_shared<Pair>(context.scene, context.seed);
  const unsigned bits = find_truth(*pair, reference_budget(context));
  ChoiceSettings made;
  made.unit = "world units between places";
  made.reference =
      fmt::format("a moving point in {} bits by other formulas (oracle/long_orbit), the same in {}",
                  2 * bits, bits);
  if (pair->exact.size() < kBounces)
    made.cut = fmt::format("reference of {} bounces instead of {}", pair->exact.size(), kBounces);
  made.grows = "bounces";
  made.one_question = false;
  made.ordered = false;  // in a chaotic room it grows like e^n, not like a power
  for (std::size_t bounces = 1; bounces <= pair->exact.size(); bounces *= 2)
    made.settings.push_back(doubles(pair, bounces));
  for (std::size_t bounces = 8; bounces <= pair->exact.size(); bounces *= 4)
    made.settings.push_back(certified(pair, bounces));
  return made;
}

}  // namespace

namespace choice_entries {
extern const Choice precision = {"precision", "What does it cost to know where an orbit is?",
                                 ErrorKind::rounding, &left_out, &settings};
}  // namespace choice_entries

}  // namespace flatray
