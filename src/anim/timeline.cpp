#include "anim/timeline.h"

#include "anim/camera.h"
#include "anim/step.h"
#include "base/philox.h"

namespace flatray {
namespace {

// One entity's way through its chain, a frame at a time.
class Walk {
 public:
  Walk(const Scene& scene, std::uint64_t seed, std::uint32_t index)
      : entity_(scene.entities[index]),
        use_(*entity_.markov),
        chain_(scene.chains[use_.chain]),
        fps_(scene.fps),
        seed_(seed),
        index_(index),
        now_{use_.start, 0, {0, 0}} {}

  const Timeline::MarkovFrame& now() const { return now_; }

  void advance() {
    now_.moved += velocity() / fps_;
    ++frames_;
    const StateId before = now_.state;
    if (frames_ % chain_.hold == 0) draw();
    now_.sub_state = now_.state == before ? next_sub_state() : 0;
  }

 private:
  // Of the state it is in: its sub-states, if it has any.
  std::size_t look_count() const {
    return now_.state < use_.looks.size() ? use_.looks[now_.state].size() : 0;
  }
  Vec2 velocity() const {
    if (look_count() == 0) return entity_.velocity;
    return use_.looks[now_.state][now_.sub_state].velocity.value_or(entity_.velocity);
  }
  std::uint32_t next_sub_state() const {
    return now_.sub_state + 1 < look_count() ? now_.sub_state + 1 : 0;
  }
  void draw() {
    const std::uint64_t steps_made = frames_ / chain_.hold - 1;
    now_.state = step(chain_, now_.state, random_bits(seed_, Stream::markov, steps_made, index_));
  }

  const Entity& entity_;
  const MarkovUse& use_;
  const MarkovChain& chain_;
  double fps_;
  std::uint64_t seed_;
  std::uint32_t index_;
  std::uint64_t frames_ = 0;  ///< since the first
  Timeline::MarkovFrame now_;
};

std::vector<Timeline::MarkovFrame> replay(const Scene& scene, std::uint64_t seed,
                                          std::uint32_t index, unsigned last_frame) {
  std::vector<Timeline::MarkovFrame> frames;
  frames.reserve(last_frame);
  Walk walk(scene, seed, index);
  for (frames.push_back(walk.now()); frames.size() < last_frame; frames.push_back(walk.now()))
    walk.advance();
  return frames;
}

}  // namespace

Timeline::Timeline(const Scene& scene, std::uint64_t seed, unsigned last_frame)
    : scene_(&scene), seed_(seed), markov_(scene.entities.size()) {
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (scene.entities[i].markov) markov_[i] = replay(scene, seed, i, last_frame);
  content_ = content_bounds(scene, entity_states(*this, 1));
}

const Timeline::MarkovFrame& Timeline::markov(std::uint32_t index, unsigned frame) const {
  FLATRAY_CHECK(frame >= 1 && frame <= markov_[index].size());
  return markov_[index][frame - 1];
}

}  // namespace flatray
