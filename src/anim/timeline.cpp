#include "anim/timeline.h"

#include <algorithm>
#include <cmath>

#include "anim/camera.h"
#include "anim/step.h"
#include "base/philox.h"

namespace flatray {

struct Timeline::Walker {
  Walker(const Entity& entity, std::uint32_t index, std::span<const std::uint64_t> hit)
      : use(*entity.markov), velocity(entity.velocity), draws(index), hits(hit) {}
  Walker(const Lamp& lamp, std::uint32_t index)
      : use(*lamp.markov), velocity(lamp.velocity), draws(kLampDraws + index) {}

  const MarkovUse& use;
  Vec2 velocity;                        // of states that have none
  std::uint32_t draws;                  // names them
  std::span<const std::uint64_t> hits;  // frames after the first
};

namespace {

// Its way through its chain, a frame at a time.
struct Walk {
  const Scene& scene;
  const std::uint64_t seed;
  const Timeline::Walker& walker;
  std::uint64_t frames;  // since the first
  Timeline::MarkovFrame now;

  void advance() {
    const MarkovChain& chain = scene.chains[walker.use.chain];
    now.moved = held(now.moved + held(velocity() / scene.fps));
    ++frames;
    const StateId before = now.state;
    if (frames % chain.hold == 0)
      now.state = step(chain, now.state,
                       random_bits(seed, Stream::markov, frames / chain.hold - 1, walker.draws));
    now.sub_state = now.state == before ? next_sub_state() : 0;
    take_hit();
  }
  // Of the state it is in: its sub-states, if it has any.
  std::span<const Look> looks() const {
    const auto& all = walker.use.looks;
    return now.state < all.size() ? std::span(all[now.state]) : std::span<const Look>();
  }
  Vec2 velocity() const {
    if (looks().empty()) return walker.velocity;
    return looks()[now.sub_state].velocity.value_or(walker.velocity);
  }
  std::uint32_t next_sub_state() const {
    return now.sub_state + 1 < looks().size() ? now.sub_state + 1 : 0;
  }
  void take_hit() {
    if (!std::ranges::binary_search(walker.hits, frames)) return;
    now.state = *walker.use.hit;
    now.sub_state = 0;
  }
};

// Frames 1, 1 + every, 1 + 2 every...
std::vector<Timeline::MarkovFrame> replay(const Scene& scene, std::uint64_t seed,
                                          const Timeline::Walker& walker, unsigned last_frame,
                                          unsigned every) {
  std::vector<Timeline::MarkovFrame> kept;
  kept.reserve((last_frame - 1) / every + 1);
  Walk walk{scene, seed, walker, 0, {walker.use.start, 0, {0, 0}}};
  walk.take_hit();
  kept.push_back(walk.now);
  for (unsigned frame = 2; frame <= last_frame; ++frame) {
    walk.advance();
    if ((frame - 1) % every == 0) kept.push_back(walk.now);
  }
  return kept;
}

// So that no more than kMostKept are kept.
unsigned frames_between(const Scene& scene, unsigned last_frame) {
  const auto has_chain = [](const auto& thing) { return thing.markov.has_value(); };
  const auto walks = std::ranges::count_if(scene.entities, has_chain) +
                     std::ranges::count_if(scene.lamps, has_chain);
  const std::uint64_t frames = static_cast<std::uint64_t>(walks) * last_frame;
  const std::uint64_t every = (frames + Timeline::kMostKept - 1) / Timeline::kMostKept;
  return static_cast<unsigned>(
      std::max<std::uint64_t>(std::min<std::uint64_t>(every, last_frame), 1));
}

// The first frame that shows a time, counted from 0.
std::uint64_t frame_after(const Scene& scene, double time) {
  const double shown = std::floor(frame_at(scene, time)) - 1;
  return static_cast<std::uint64_t>(shown / scene.fps < time ? shown + 1 : shown);
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

double frame_at(const Scene& scene, double time) {
  double before = std::floor(time * scene.fps);
  if (before / scene.fps > time) --before;
  if ((before + 1) / scene.fps <= time) ++before;
  if (before / scene.fps == time) return 1 + before;
  return std::clamp(1 + time * scene.fps, 1 + before, std::nextafter(2 + before, 0.0));
}

Timeline::Timeline(const Scene& scene, std::uint64_t seed, unsigned last_frame, Responses responses)
    : scene_(&scene),
      seed_(seed),
      last_frame_(last_frame),
      every_(frames_between(scene, last_frame)),
      responses_(std::move(responses)),
      hits_(hits_of(scene, responses_.events, last_frame)),
      markov_(scene.entities.size()),
      lamps_(scene.lamps.size()) {
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (const Entity& entity = scene.entities[i]; entity.markov)
      markov_[i] = replay(scene, seed, {entity, i, hits_[i]}, last_frame, every_);
  for (std::uint32_t i = 0; i < scene.lamps.size(); ++i)
    if (const Lamp& lamp = scene.lamps[i]; lamp.markov)
      lamps_[i] = replay(scene, seed, {lamp, i}, last_frame, every_);
  if (is_window_of_content(scene)) content_ = content_bounds(scene, entity_states(*this, 1));
}

Timeline::MarkovFrame Timeline::markov(std::uint32_t index, unsigned frame) const {
  return frame_of({scene_->entities[index], index, hits_[index]}, markov_[index], frame);
}

Timeline::MarkovFrame Timeline::lamp(std::uint32_t index, unsigned frame) const {
  return frame_of({scene_->lamps[index], index}, lamps_[index], frame);
}

Timeline::MarkovFrame Timeline::frame_of(const Walker& walker, std::span<const MarkovFrame> kept,
                                         unsigned frame) const {
  FLATRAY_CHECK(frame >= 1 && frame <= last_frame_);
  const unsigned before = (frame - 1) / every_;
  if (before * every_ == frame - 1) return kept[before];
  Walk walk{*scene_, seed_, walker, std::uint64_t{before} * every_, kept[before]};
  for (unsigned at = before * every_; at < frame - 1; ++at) walk.advance();
  return walk.now;
}

}  // namespace flatray
