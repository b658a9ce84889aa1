#include <fmt/core.h>

#include <memory>

#include "precise/certified_orbit.h"
#include "study/accuracy.h"
#include "study/room.h"

namespace flatray {
namespace {

// An orbit in doubles beside the exact one.
struct Pair {
  Pair(const Scene& scene, std::uint64_t seed)
      : room(scene), mirrors(room.walls().size(), Material::mirror) {
    start = room.draw_start(seed, 0).ray;
  }
  Room room;
  std::vector<Material> mirrors;
  Ray start;
  std::vector<CertifiedOrbit::Bounce> exact;
  Vec2 last{0, 0};
};

std::function<Outcome()> judged(const std::shared_ptr<Pair>& pair, std::size_t bounces) {
  return [pair, bounces] {
    return Outcome{(pair->last - pair->exact[bounces - 1].point).stableNorm()};
  };
}

// The last bounce of an orbit of so many; an orbit that ends before has no right place.
Setting doubles(const std::shared_ptr<Pair>& pair, std::size_t bounces) {
  return {fmt::format("doubles, bounce {}", bounces), static_cast<double>(bounces),
          [pair, bounces] {
            const Orbit orbit =
                trace_orbit(pair->room.walls(), pair->mirrors, pair->start, bounces);
            pair->last = orbit.bounces.empty() ? pair->start.origin : orbit.bounces.back().point;
          },
          judged(pair, bounces)};
}

Setting certified(const std::shared_ptr<Pair>& pair, std::size_t bounces) {
  return {fmt::format("certified, bounce {}", bounces), 0,
          [pair, bounces] {
            const auto orbit = certified_orbit(pair->room.walls(), pair->start, bounces);
            pair->last = orbit->bounces.back().point;
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
  constexpr std::uint64_t kBounces = 128;
  const auto pair = std::make_shared<Pair>(context.scene, context.seed);
  auto exact = certified_orbit(pair->room.walls(), pair->start, kBounces);
  if (!exact) return tl::unexpected(exact.error());
  pair->exact = std::move(exact->bounces);
  ChoiceSettings made;
  made.unit = "world units between places";
  made.reference =
      fmt::format("the exact orbit, proven with {} bits, which is also what certified orbits give",
                  exact->bits);
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
