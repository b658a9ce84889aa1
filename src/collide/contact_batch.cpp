#include "collide/contact_batch.h"

#include <array>
#include <cmath>

#include "collide/certain_contact.h"

namespace flatray {
namespace {

using Ready = PolygonSet::Ready;
constexpr std::size_t kBlock = 128;
// Above, floats could overflow.
constexpr double kLargest = 0x1p60;

sweep::Kernel kernel_of([[maybe_unused]] Isa isa) {
#if defined(__x86_64__)
  switch (isa) {
    case Isa::avx512:
      return sweep::avx512::kKernel;
    case Isa::avx2:
      return sweep::avx2::kKernel;
    case Isa::baseline:
      return sweep::baseline::kKernel;
    case Isa::portable:
      break;
  }
#endif
  return sweep::portable::kKernel;
}

// What a pair is at first sight.
enum class Sight { apart, near, unusual };

// Boxes that stay apart along an axis at both ends of the time do so all along.
bool stay_apart(double centre, double way, double reach, double length) {
  const double later = centre + length * way;
  return (centre > reach && later > reach) || (centre < -reach && later < -reach);
}

// Boxes or discs around both, certainly never touching. Errors of some u each, of what the terms add
// up to, are far below the 2^-40 allowed for.
bool rounds_stay_apart(const Ready& a, const Ready& b, const Vec2& centre, const Vec2& way,
                       double length) {
  constexpr double kRoom = 1 + 0x1p-40, kLeast = 0x1p-900;
  const double left = centre.x() * way.y(), right = centre.y() * way.x();
  const double across = std::fabs(left - right) - 0x1p-50 * (std::fabs(left) + std::fabs(right));
  const double radius = a.radius + b.radius;
  const bool beside =
      (across > 0) & (across * across >
                      radius * radius * (way.x() * way.x() + way.y() * way.y()) * kRoom + kLeast);
  const Vec2 room =
      a.half + b.half +
      0x1p-40 * (centre.cwiseAbs() + way.cwiseAbs() * (length < kInfinity ? length : 0));
  // All three first: a branch for each would be foreseen for none.
  const bool along_x = stay_apart(centre.x(), way.x(), room.x(), length);
  const bool along_y = stay_apart(centre.y(), way.y(), room.y(), length);
  return beside || along_x || along_y;
}

Sight look(const Ready& a, const Ready& b, const MovingPair& pair, double length,
           sweep::Pair& made) {
  const Vec2 centre = b.centre - a.centre, way = pair.velocity_b - pair.velocity_a;
  const double size = std::fabs(centre.x()) + std::fabs(centre.y());
  const double speed = std::fabs(way.x()) + std::fabs(way.y());
  if (a.count == 0 || b.count == 0 || !(size < kLargest && speed < kLargest && speed > 0))
    return Sight::unusual;
  if (rounds_stay_apart(a, b, centre, way, length)) return Sight::apart;
  // A handful of roundings to floats, each of 2^-24 of what the terms add up to.
  made = {&a.lanes,
          &b.lanes,
          static_cast<float>(centre.x()),
          static_cast<float>(centre.y()),
          static_cast<float>(way.x()),
          static_cast<float>(way.y()),
          static_cast<float>(0x1p-19 * (2 * a.radius + 2 * b.radius + size) + 0x1p-120),
          static_cast<float>(0x1p-19 * speed + 0x1p-120)};
  return Sight::near;
}

class Block {
 public:
  Block(const PolygonSet& shapes, Range within, sweep::Kernel kernel)
      : shapes_(shapes), within_(within), kernel_(kernel) {}

  void run(std::span<const MovingPair> pairs, std::span<Contact> contacts) {
    int count = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Ready &a = shapes_.ready(pairs[i].a), &b = shapes_.ready(pairs[i].b);
      const Sight sight =
          look(a, b, pairs[i], within_.high, near_[static_cast<std::size_t>(count)]);
      numbers_[static_cast<std::size_t>(count)] = i;
      count += sight == Sight::near ? 1 : 0;
      if (sight == Sight::unusual)
        contacts[i] = decide(pairs[i]);
      else
        contacts[i] = {};
    }
    kernel_(near_.data(), count, static_cast<float>(within_.high), guesses_.data());
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      if (guesses_[k].enter >= sweep::kApart) continue;
      const std::size_t i = numbers_[k];
      if (const auto certain = certain_contact(shapes_, pairs[i], within_.high, guesses_[k]))
        contacts[i] = *certain;
      else
        contacts[i] = decide(pairs[i]);
    }
  }

  Contact decide(const MovingPair& pair) const {
    return contact({shapes_.ring(pair.a), pair.velocity_a}, {shapes_.ring(pair.b), pair.velocity_b},
                   within_);
  }

 private:
  const PolygonSet& shapes_;
  const Range within_;
  const sweep::Kernel kernel_;
  std::array<sweep::Pair, kBlock + 1> near_;
  std::array<std::size_t, kBlock + 1> numbers_;
  std::array<sweep::Guess, kBlock> guesses_;
};

}  // namespace

void contacts(const PolygonSet& shapes, std::span<const MovingPair> pairs, Range within,
              std::span<Contact> contacts, Isa isa) {
  Block block(shapes, within, kernel_of(isa));
  const bool usual = within.low == 0 && within.high > 0;
  for (std::size_t i = 0; i < pairs.size(); i += kBlock) {
    const std::size_t count = std::min(kBlock, pairs.size() - i);
    if (usual) {
      block.run(pairs.subspan(i, count), contacts.subspan(i, count));
      continue;
    }
    for (std::size_t k = i; k < i + count; ++k) contacts[k] = block.decide(pairs[k]);
  }
}

}  // namespace flatray
