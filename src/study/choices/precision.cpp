#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

#include "base/counted.h"
#include "base/processor_time.h"
#include "oracle/long_orbit.h"
#include "precise/certified_orbit.h"
#include "scene/material.h"
#include "study/accuracy/accuracy.h"
#include "study/rooms/room.h"

namespace flatray::precision_choice {
namespace {

// Orbits in doubles or certified, each beside one in many bits.
struct Orbits {
  explicit Orbits(const Scene& scene)
      : room(scene), mirrors(room.walls().size(), Material::mirror) {}

  struct One {
    Ray start;
    std::vector<oracle::LongOrbit::Bounce> exact;
    Vec2 last{0, 0};
  };
  Room room;
  std::vector<Material> mirrors;
  std::vector<One> all;
  std::size_t bounces = 0;  // that all which are left have
};

constexpr std::uint64_t kStarts = 15;  // odd, so that one of them is the median if none is left out
constexpr std::uint64_t kFewBounces = 8;
constexpr std::array<std::uint64_t, 14> kBounces = {1,  2,  4,  8,  12, 16, 20,
                                                    24, 28, 32, 48, 64, 96, 128};
constexpr double kSaturated =
    0x1p-10;  // of the room: farther apart two orbits have nothing in common
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

// Bounces there is time for.
std::uint64_t affordable(const Room& room, const Ray& start, double seconds) {
  const double begin = processor_seconds();
  const auto few = oracle::long_orbit(room.walls(), start, kFewBounces, kFirstBits);
  const double each = (processor_seconds() - begin) / static_cast<double>(kFewBounces);
  // The two numbers of bits that are begun with take some four times as long as the fewer alone.
  const double allowed = seconds / std::max(4 * each, 1e-9);
  if (allowed >= static_cast<double>(kBounces.back())) return kBounces.back();
  return std::max(kFewBounces, static_cast<std::uint64_t>(allowed));
}

// Bits are doubled until they tell all bounces, or time is up. Gives   the fewer of the two.
unsigned find_truth(const Room& room, std::uint64_t bounces, double seconds, Orbits::One& one) {
  const double start = processor_seconds();
  unsigned bits = kFirstBits;
  oracle::LongOrbit orbit = oracle::long_orbit(room.walls(), one.start, bounces, bits);
  for (;; bits *= 2) {
    oracle::LongOrbit finer = oracle::long_orbit(room.walls(), one.start, bounces, 2 * bits);
    const std::size_t same = agreeing(orbit, finer);
    one.exact.assign(finer.bounces.begin(),
                     finer.bounces.begin() + static_cast<std::ptrdiff_t>(same));
    if (same == finer.bounces.size() || 2 * bits >= kMostBits ||
        processor_seconds() - start > seconds / 2)
      return bits;
    orbit = std::move(finer);
  }
}

// All starts with as many bounces as the longest; what ends before, in a corner or as time was up,
// is left out. Gives the most bits that took.
unsigned find_truths(Orbits& orbits, std::uint64_t seed, double seconds) {
  unsigned bits = kFirstBits;
  const double each = seconds / static_cast<double>(kStarts);
  std::uint64_t bounces = 0;
  for (std::uint64_t number = 0; number < kStarts; ++number) {
    Orbits::One one;
    one.start = orbits.room.draw_start(seed, number).ray;
    if (number == 0) bounces = affordable(orbits.room, one.start, each);
    bits = std::max(bits, find_truth(orbits.room, bounces, each, one));
    orbits.bounces = std::max(orbits.bounces, one.exact.size());
    orbits.all.push_back(std::move(one));
  }
  std::erase_if(orbits.all,
                [&](const Orbits::One& one) { return one.exact.size() < orbits.bounces; });
  return bits;
}

// The median of all starts.
std::function<Outcome()> judged(const std::shared_ptr<Orbits>& orbits, std::size_t bounces) {
  return [orbits, bounces] {
    std::vector<double> off;
    for (const Orbits::One& one : orbits->all)
      off.push_back((one.last - one.exact[bounces - 1].point).stableNorm());
    const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
    std::nth_element(off.begin(), middle, off.end());
    return Outcome{*middle};
  };
}

// The last bounce of orbits of so many; an orbit that ends before has no right place.
Setting last_bounce(const std::shared_ptr<Orbits>& orbits, std::size_t bounces, bool is_certified) {
  const auto work = [orbits, bounces, is_certified] {
    for (Orbits::One& one : orbits->all) {
      const auto last_of = [&](const auto& orbit) {
        return orbit.bounces.empty() ? one.start.origin : orbit.bounces.back().point;
      };
      const Surfaces& walls = orbits->room.walls();
      one.last = is_certified ? last_of(*certified_orbit(walls, one.start, bounces))
                              : last_of(trace_orbit(walls, orbits->mirrors, one.start, bounces));
    }
  };
  return {fmt::format("bounce {} {}", bounces, is_certified ? "certified" : "in doubles"),
          is_certified ? 0 : static_cast<double>(bounces), work, judged(orbits, bounces)};
}

std::string left_out(const Scene& scene) {
  if (scene.field() != 0) return kRaysAreBent;
  if (place_of_glass(scene) != nullptr) return "glass splits its orbits";
  if (const auto can = can_certify(); !can) return can.error().front().message;
  for (const auto expected : {&expect_closed, &expect_not_periodic})
    if (const auto met = expected({.scene = scene}); !met) return met.error().front().message;
  return "";
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  const auto orbits = std::make_shared<Orbits>(context.scene);
  const unsigned bits = find_truths(*orbits, context.seed, reference_budget(context));
  const std::size_t most = orbits->bounces;
  ChoiceSettings made;
  made.unit = "world units between places, the median of " + counted(orbits->all.size(), "start");
  made.reference =
      fmt::format("moving points in {} bits by other formulas (oracle/long_orbit), the same in {}",
                  2 * bits, bits);
  if (most < kBounces.back())
    made.cut =
        fmt::format("reference of {} instead of {}", counted(most, "bounce"), kBounces.back());
  made.grows = "bounces";
  made.one_question = false;
  made.laws = {Law::power, Law::exponential};  // e^n in a chaotic room, which has an end
  made.saturated = kSaturated * bounds_of(orbits->room.walls()).size().maxCoeff();
  for (const std::uint64_t bounces : kBounces)
    if (bounces <= most) made.settings.push_back(last_bounce(orbits, bounces, false));
  for (std::size_t bounces = 8; bounces <= most; bounces *= 4)
    made.settings.push_back(last_bounce(orbits, bounces, true));
  return made;
}

}  // namespace

extern const Choice entry = {"precision", "What does it cost to know where an orbit is?",
                             ErrorKind::rounding, &left_out, &settings};

}  // namespace flatray::precision_choice
