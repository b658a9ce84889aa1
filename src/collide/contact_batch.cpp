#include "collide/contact_batch.h"

#include <algorithm>
#include <cmath>

#include "collide/certain_contact.h"
#include "collide/minkowski.h"
#include "geom/bounds.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

using Ready = BodySet::Ready;
using Box = BodySet::Box;
constexpr std::size_t kBlock = CertainContacts::kMost;
constexpr double kRoundUp = 1 + 0x1p-40;

void set_corners(std::span<const Vec2> ring, std::span<const std::uint32_t> numbers,
                 bool turned_round, Ready& ready) {
  const std::size_t count = numbers.size();
  ready.count = static_cast<int>(count);
  for (std::size_t k = 0; k < count + 2; ++k)
    ready.around[k] = ring[numbers[(k + count - 1) % count]];
  for (std::size_t k = 0; k < count; ++k) {
    ready.numbers[k] = static_cast<std::int32_t>(numbers[k]);
    ready.edges[k] = static_cast<std::int32_t>(numbers[turned_round ? (k + 1) % count : k]);
  }
}

// Whether all normals are usual.
bool set_lanes(const Vec2& centre, Ready& ready) {
  const std::span<const Vec2> corners(&ready.corner(0), static_cast<std::size_t>(ready.count));
  bool usual = true;
  for (std::size_t lane = 0; lane < pairs::kCorners; ++lane) {
    const std::size_t k = lane < corners.size() ? lane : 0;
    const Vec2 from = corners[k] - centre, along = (&corners[k])[1] - corners[k];
    const double length = std::sqrt(along.squaredNorm());
    const auto x = static_cast<float>(along.y() / length);
    const auto y = static_cast<float>(-along.x() / length);
    double reach = -pairs::kLargest;
    for (const Vec2& corner : corners) {
      const Vec2 p = corner - centre;
      reach = std::max(reach, static_cast<double>(x) * p.x() + static_cast<double>(y) * p.y());
    }
    ready.lanes.normal_x[lane] = x;
    ready.lanes.normal_y[lane] = y;
    ready.lanes.reach[lane] = static_cast<float>(reach);
    ready.lanes.x[lane] = static_cast<float>(from.x());
    ready.lanes.y[lane] = static_cast<float>(from.y());
    usual = usual && std::fabs(x) <= 1 && std::fabs(y) <= 1;
  }
  return usual;
}

// Whether it is a polygon for the lanes, and then made ready.
bool make_ready(std::span<const Vec2> ring, const BodySet::Box& box, Ready& ready) {
  const double half = box.half.maxCoeff();
  if (!(half > 1 / pairs::kLargest && half < pairs::kLargest)) return false;
  const Sign sense = ring_orientation(ring);
  if (sense == Sign::zero) return false;
  const std::vector<std::uint32_t> numbers = turned_ring(ring, sense);
  if (numbers.size() > pairs::kCorners) return false;
  set_corners(ring, numbers, sense == Sign::negative, ready);
  return set_lanes(box.centre, ready);
}

const pairs::Kernels& kernels_of(Isa isa) {
  static constexpr const pairs::Kernels* kTiers[] = {
    &pairs::kPortable,
#if defined(__x86_64__)
    &pairs::kBaseline,
    &pairs::kAvx2,
    &pairs::kAvx512
#endif
  };
  return *of_tier(kTiers, isa);
}

void fetch(const Ready& shape) {
  const char* const from = reinterpret_cast<const char*>(&shape.lanes);
  for (std::size_t i = 0; i < sizeof shape.lanes; i += 64) __builtin_prefetch(from + i);
}

// Whether lanes can tell anything of a pair.
bool is_usual(const BodySet& bodies, const MovingPair& pair, pairs::Approach& made) {
  if (!bodies.is_ready(pair.a) || !bodies.is_ready(pair.b)) return false;
  const Box &a = bodies.boxes()[pair.a], &b = bodies.boxes()[pair.b];
  const Vec2 centre = b.centre - a.centre, way = pair.velocity_b - pair.velocity_a;
  const double size = centre.cwiseAbs().sum(), speed = way.cwiseAbs().sum();
  if (!(size < pairs::kLargest && speed < pairs::kLargest && speed > 0)) return false;
  const Ready &ready_a = bodies.ready(pair.a), &ready_b = bodies.ready(pair.b);
  fetch(ready_a);
  fetch(ready_b);
  // A handful of roundings to floats, each of 2^-24 of what the terms add up to, and the number of a
  // corner, below 2^-20 of its distance.
  const double terms = 2 * (a.half + b.half).sum() + size;
  made = {&ready_a.lanes,
          &ready_b.lanes,
          static_cast<float>(centre.x()),
          static_cast<float>(centre.y()),
          static_cast<float>(way.x()),
          static_cast<float>(way.y()),
          static_cast<float>(0x1p-19 * terms + 0x1p-120),
          static_cast<float>(0x1p-19 * speed + 0x1p-120)};
  return true;
}

class Block {
 public:
  Block(const BodySet& bodies, Range within, const pairs::Kernels& kernels)
      : bodies_(bodies),
        within_(within),
        kernels_(kernels),
        certain_(bodies, within.high, kernels.certify) {}

  void run(std::span<const MovingPair> pairs, std::span<Contact> contacts) {
    static constexpr std::array<Contact, kBlock> kMisses = {};
    std::copy_n(kMisses.begin(), pairs.size(), contacts.begin());
    static_assert(sizeof(Box) == 4 * sizeof(double));
    const pairs::Moves asked = {&pairs[0].a, pairs[0].velocity_a.data(), sizeof(MovingPair)};
    kernels_.cull_boxes(bodies_.boxes().data()->centre.data(), within_.high, asked,
                        static_cast<int>(pairs.size()), seen_.data());
    std::size_t near_count = 0, count = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      near_[near_count] = i;
      near_count += seen_[i] > 0 ? 1 : 0;
    }
    for (std::size_t k = 0; k < near_count; ++k) {
      const std::size_t i = near_[k];
      near_[count] = i;
      if (is_usual(bodies_, pairs[i], guessed_[count]))
        ++count;
      else
        contacts[i] = decide(pairs[i]);
    }
    kernels_.find_candidates(guessed_.data(), static_cast<int>(count),
                             static_cast<float>(within_.high), guesses_.data());
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = near_[k];
      if (guesses_[k].enter < pairs::kApart) certain_.add(pairs[i], guesses_[k], contacts[i]);
    }
    certain_.run([&](const MovingPair& pair, Contact& contact) { contact = decide(pair); });
  }

  Contact decide(const MovingPair& pair) const {
    return contact(bodies_.body(pair.a, pair.velocity_a), bodies_.body(pair.b, pair.velocity_b),
                   within_);
  }

 private:
  const BodySet& bodies_;
  const Range within_;
  const pairs::Kernels& kernels_;
  CertainContacts certain_;
  std::array<double, kBlock> seen_;
  std::array<std::size_t, kBlock + 1> near_;
  std::array<pairs::Approach, kBlock> guessed_;
  std::array<pairs::Candidates, kBlock> guesses_;
};

}  // namespace

std::uint32_t BodySet::add(std::span<const Vec2> core, double radius) {
  const auto number = static_cast<std::uint32_t>(size());
  const Bounds around = box_about(core);
  const Vec2 centre = around.centre();
  const Vec2 half =
      kRoundUp * ((centre - around.low).cwiseMax(around.high - centre).array() + radius);
  vertices_.insert(vertices_.end(), core.begin(), core.end());
  begin_.push_back(vertices_.size());
  boxes_.push_back({centre, half});
  Ready& ready = ready_.emplace_back();
  is_ready_.push_back(radius == 0 && make_ready(core, boxes_.back(), ready));
  radii_.push_back(radius);
  return number;
}

void contacts(const BodySet& bodies, std::span<const MovingPair> pairs, Range within,
              std::span<Contact> contacts, Isa isa) {
  Block block(bodies, within, kernels_of(isa));
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
