#include "anim/timeline.h"

#include <algorithm>
#include <cmath>

#include "anim/camera.h"
#include "anim/step.h"
#include "base/philox.h"

namespace flatray {
namespace {

// One entity's way through its chain, a frame at a time.
class Walk {
 public:
  /// From `frames` after the first on, where it was at `then`.
  Walk(const Scene& scene, std::uint64_t seed, std::uint32_t index,
       std::span<const std::uint64_t> hits, std::uint64_t frames, const Timeline::MarkovFrame& then)
      : entity_(scene.entities[index]),
        use_(*entity_.markov),
        chain_(scene.chains[use_.chain]),
        fps_(scene.fps),
        seed_(seed),
        index_(index),
        hits_(hits),
        frames_(frames),
        now_(then) {
    if (frames == 0) take_hit();
  }

  const Timeline::MarkovFrame& now() const { return now_; }

  void advance() {
    now_.moved += velocity() / fps_;
    ++frames_;
    const StateId before = now_.state;
    if (frames_ % chain_.hold == 0) draw();
    now_.sub_state = now_.state == before ? next_sub_state() : 0;
    take_hit();
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
  void take_hit() {
    if (!std::binary_search(hits_.begin(), hits_.end(), frames_)) return;
    now_.state = *use_.hit;
    now_.sub_state = 0;
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
  std::span<const std::uint64_t> hits_;
  std::uint64_t frames_;  ///< since the first
  Timeline::MarkovFrame now_;
};

// Frames 1, 1 + every, 1 + 2 every...
std::vector<Timeline::MarkovFrame> replay(const Scene& scene, std::uint64_t seed,
                                          std::uint32_t index, std::span<const std::uint64_t> hits,
                                          unsigned last_frame, unsigned every) {
  std::vector<Timeline::MarkovFrame> kept;
  kept.reserve((last_frame - 1) / every + 1);
  Walk walk(scene, seed, index, hits, 0, {scene.entities[index].markov->start, 0, {0, 0}});
  kept.push_back(walk.now());
  for (unsigned frame = 2; frame <= last_frame; ++frame) {
    walk.advance();
    if ((frame - 1) % every == 0) kept.push_back(walk.now());
  }
  return kept;
}

// So that no more than kMostKept are kept.
unsigned frames_between(const Scene& scene, unsigned last_frame) {
  const auto walks = std::count_if(scene.entities.begin(), scene.entities.end(),
                                   [](const Entity& entity) { return entity.markov.has_value(); });
  const std::uint64_t frames = static_cast<std::uint64_t>(walks) * last_frame;
  const std::uint64_t every = (frames + Timeline::kMostKept - 1) / Timeline::kMostKept;
  return static_cast<unsigned>(
      std::max<std::uint64_t>(std::min<std::uint64_t>(every, last_frame), 1));
}

// The first frame that shows a time, counted from 0.
std::uint64_t frame_after(const Scene& scene, double time) {
  double frame = std::max(std::ceil(time * scene.fps), 0.0);
  while (frame > 0 && (frame - 1) / scene.fps >= time) --frame;
  while (frame / scene.fps < time) ++frame;
  return static_cast<std::uint64_t>(frame);
}

std::vector<std::vector<std::uint64_t>> hits_of(const Scene& scene,
                                                std::span<const CollisionEvent> events,
                                                unsigned last_frame) {
  std::vector<std::vector<std::uint64_t>> hits(scene.entities.size());
  const double end = (last_frame - 1.0) / scene.fps;
  for (const CollisionEvent& event : events) {
    if (event.time > end) break;
    for (const std::uint32_t i : {event.a, event.b}) {
      const auto& markov = scene.entities[i].markov;
      if (!markov || !markov->hit) continue;
      const std::uint64_t frame = frame_after(scene, event.time);
      if (hits[i].empty() || hits[i].back() != frame) hits[i].push_back(frame);
    }
  }
  return hits;
}

}  // namespace

Timeline::Timeline(const Scene& scene, std::uint64_t seed, unsigned last_frame, Responses responses)
    : scene_(&scene),
      seed_(seed),
      last_frame_(last_frame),
      every_(frames_between(scene, last_frame)),
      responses_(std::move(responses)),
      hits_(hits_of(scene, responses_.events, last_frame)),
      markov_(scene.entities.size()) {
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (scene.entities[i].markov) markov_[i] = replay(scene, seed, i, hits_[i], last_frame, every_);
  content_ = content_bounds(scene, entity_states(*this, 1));
}

Timeline::MarkovFrame Timeline::markov(std::uint32_t index, unsigned frame) const {
  FLATRAY_CHECK(frame >= 1 && frame <= last_frame_);
  const unsigned kept = (frame - 1) / every_;
  if (kept * every_ == frame - 1) return markov_[index][kept];
  Walk walk(*scene_, seed_, index, hits_[index], std::uint64_t{kept} * every_,
            markov_[index][kept]);
  for (unsigned at = kept * every_; at < frame - 1; ++at) walk.advance();
  return walk.now();
}

}  // namespace flatray
