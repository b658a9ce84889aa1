#pragma once
#include "anim/responses.h"
#include "scene/scene.h"

namespace flatray {

/// A scene in motion. Kinematic scenes need nothing stored but Markov states: all up to the last
/// frame, or where those are many every n-th, from which the frames between are replayed. Where
/// entities respond to contact, collide/simulate.h has found out what follows.
class Timeline {
 public:
  /// Needs   `scene` to outlive the timeline. `seed` replaces the scene's own where the command
  ///         line gives one.
  /// Cost    at most one draw for each frame and entity with a chain, and 32 bytes for each that is
  ///         kept: at most kMostKept and one for each entity.
  Timeline(const Scene& scene, std::uint64_t seed, unsigned last_frame, Responses responses = {});

  const Scene& scene() const { return *scene_; }
  std::uint64_t seed() const { return seed_; }

  struct MarkovFrame {
    StateId state;
    std::uint32_t sub_state;
    Vec2 moved;  ///< sum of the velocities so far, world units
  };
  /// For entity `index` with a chain, at frame k in [1, last_frame]. Frame k has made
  /// floor((k-1)/hold) draws, draw s (from 0) named random_bits(seed, Stream::markov, s, index).
  /// The sub-states of a state follow in order, one a frame, round and round; they start over when
  /// the state is entered from another one, so a transition to itself does not start them over. A
  /// hit puts it into MarkovUse::hit, at its first sub-state, after the draws of that frame.
  /// Cost    O(1); where more than kMostKept frames of entities were to be kept, draws as many as
  ///         frames since the one kept.
  MarkovFrame markov(std::uint32_t index, unsigned frame) const;
  /// The same of lamp `index`, whose draws are named kLampDraws + index.
  MarkovFrame lamp(std::uint32_t index, unsigned frame) const;
  static constexpr std::uint32_t kLampDraws = 1U << 31;
  static constexpr std::uint64_t kMostKept = std::uint64_t{1} << 21;

  /// How an entity moves that responds to contact; empty for others.
  std::span<const Stage> stages(std::uint32_t index) const {
    return index < responses_.stages.size() ? std::span<const Stage>(responses_.stages[index])
                                            : std::span<const Stage>();
  }
  std::span<const CollisionEvent> events() const { return responses_.events; }

  /// Of frame 1, where the window is made of it.
  const Bounds& content() const { return content_; }

  struct Walker;  ///< what goes through a chain

 private:
  MarkovFrame frame_of(const Walker& walker, std::span<const MarkovFrame> kept,
                       unsigned frame) const;

  const Scene* scene_;
  std::uint64_t seed_;
  unsigned last_frame_;
  unsigned every_ = 1;  ///< frames from one kept to the next
  Responses responses_;
  /// By entity, frames after the first at which a hit shows, ascending; empty where none is asked for.
  std::vector<std::vector<std::uint64_t>> hits_;
  std::vector<std::vector<MarkovFrame>> markov_;  ///< by entity, empty without a chain
  std::vector<std::vector<MarkovFrame>> lamps_;   ///< by lamp, likewise
  Bounds content_;
};

/// Frame that shows a time, from 1, and how much of it is over: f with k <= f < k + 1 from the time of
/// frame k on, (k - 1) / fps as a double, until that of the next.
/// Needs   a time of at least 0 whose frame is below 2^52.
double frame_at(const Scene& scene, double time);

}  // namespace flatray
