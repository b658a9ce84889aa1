#include "collide/contact_batch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collide/certain_contact.h"
#include "collide/kernels/pairs.h"

namespace flatray {
namespace {

using Ready = BodySet::Ready;
using Box = BodySet::Box;
constexpr std::size_t kBlock = CertainContacts::kMost;

const pairs::Kernels& kernels_of([[maybe_unused]] Isa isa) {
#if defined(__x86_64__)
  constexpr const pairs::Kernels* kTiers[] = {&pairs::kPortable, &pairs::kBaseline, &pairs::kAvx2,
                                              &pairs::kAvx512};
  return *kTiers[static_cast<std::size_t>(isa)];
#else
  return pairs::kPortable;
#endif
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
    look(pairs);
    std::size_t count = 0;
    for (std::size_t k = 0; k < near_count_; ++k) {
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
  // Notes the pairs whose boxes may meet.
  void look(std::span<const MovingPair> pairs) {
    static_assert(sizeof(Box) == 4 * sizeof(double));
    const pairs::Moves asked = {&pairs[0].a, pairs[0].velocity_a.data(), sizeof(MovingPair)};
    kernels_.cull_boxes(bodies_.boxes().data()->centre.data(), within_.high, asked,
                        static_cast<int>(pairs.size()), seen_.data());
    near_count_ = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      near_[near_count_] = i;
      near_count_ += seen_[i] > 0 ? 1 : 0;
    }
  }

  const BodySet& bodies_;
  const Range within_;
  const pairs::Kernels& kernels_;
  CertainContacts certain_;
  std::array<double, kBlock> seen_;
  std::size_t near_count_ = 0;
  std::array<std::size_t, kBlock + 1> near_;
  std::array<pairs::Approach, kBlock> guessed_;
  std::array<pairs::Candidates, kBlock> guesses_;
};

}  // namespace

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
