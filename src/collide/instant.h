#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "collide/body_pairs.h"
#include "collide/impact.h"

namespace flatray {

/// How a body goes on.
struct Change {
  Vec2 velocity;
  bool gone = false;
};
using Changes = std::map<std::uint32_t, Change>;  ///< by body

/// What bodies do where they meet, and which of them lie on each other since.
class Instants {
 public:
  /// Needs   all to outlive it.
  Instants(std::span<const SimulatedBody> bodies, const std::vector<std::vector<Stage>>& stages,
           const BodyPairs& pairs)
      : bodies_(bodies),
        stages_(stages),
        pairs_(pairs),
        resting_(bodies.size()),
        held_(bodies.size()) {}

  /// What follows of all hits at one instant: docs/adr/0020.
  ///
  /// Gives   the bodies that change their way, whatever the order of hits; nullopt where they have no way
  ///         out.
  std::optional<Changes> respond(std::span<const Hit> hits, double time);

  /// Contacts that hang together at the instant at which respond() has given up because they are too many; 0:
  /// there was no way out.
  std::size_t crowd() const { return crowd_; }

  bool is_fixed(std::uint32_t body) const { return bodies_[body].mass == kInfinity; }
  /// What nothing moves is a wall to all, whatever it would do itself, but for what needs no motion.
  bool does(std::uint32_t body, Response response) const;
  bool is_mark(const IndexPair& pair) const {
    return does(pair.first, Response::mark) || does(pair.second, Response::mark);
  }

 private:
  // Two of which one slides, or one goes with the other, and that have not parted since a time.
  struct Resting {
    Touch touch;
    double since;
  };
  // One that plays a part in what happens at an instant.
  struct Player {
    Vec2 velocity;
    double mass;  // infinite: a wall
    bool hit;
    std::uint32_t cluster;  // the lowest body of those that push each other

    bool wall() const { return mass == kInfinity; }
  };
  struct Push {
    Touch touch;
    bool slides;
  };
  using Players = std::map<std::uint32_t, Player>;

  Player player(std::uint32_t body, bool hit) const;
  bool stop(std::span<const Hit> hits, Players& players, double time);
  std::vector<Push> pushes_of(std::span<const Hit> hits, const Players& players) const;
  void add_resting(std::vector<Push>& pushes, Players& players, double time);
  bool still_rests(const Resting& resting, double time) const;
  bool resolve(std::span<const Push> pushes, Players& players, double time);
  void bounce(const Touch& touch, Players& players) const;
  bool push_together(std::span<const Push> pushes, Players& players, double time);
  void forget(const Touch& touch);

  const std::span<const SimulatedBody> bodies_;
  const std::vector<std::vector<Stage>>& stages_;
  const BodyPairs& pairs_;
  std::vector<std::vector<Resting>> resting_;  // by body, of each pair twice
  std::size_t crowd_ = 0;
  std::vector<std::vector<Resting>> held_;  // by body that has stopped, on walls
};

}  // namespace flatray
