#pragma once
#include <optional>
#include <utility>

#include "base/diagnostic.h"
#include "scene/scene.h"

namespace flatray {

/// What an entity does where it meets another that responds: its own word, else the scene's.
Response response_of(const Scene& scene, const Entity& entity);

/// What a response is called.
inline constexpr std::pair<const char*, Response> kResponses[] = {
    {"none", Response::none},     {"mark", Response::mark},   {"stop", Response::stop},
    {"bounce", Response::bounce}, {"slide", Response::slide}, {"remove", Response::remove}};
const char* name(Response response);

/// Whether any entity responds.
bool responds(const Scene& scene);

/// What says so. Needs   a scene that responds.
Place where_responds(const Scene& scene);
/// Why it is refused where what entities do when they meet is not looked at: `what` says who does not
/// look.
Diagnostic refused_responses(const Scene& scene, const std::string& what);

/// Events after which a scene is given up.
inline std::uint64_t most_events(const Scene& scene) {
  return scene.collisions ? scene.collisions->most : Collisions{}.most;
}

/// Why an entity cannot respond: it does not keep one velocity and one outline, or has parts that
/// nothing meets. `key` is that of its table that says so.
struct Hindrance {
  const char* key;
  const char* what;  ///< "turns"
};
std::optional<Hindrance> hindrance(const Scene& scene, const Entity& entity);

/// Whether the states of a chain change the shape or the velocity of who has it.
bool changes_outline_or_velocity(const MarkovUse& markov);

/// Whether a shape has parts that contacts leave out: curves other than circles, or than those and ellipses;
/// outlines that cross.
bool has_parts_left_out(const Shape& shape, bool but_ellipses = false);

/// Whether a group moves in the one it stands in.
bool moves(const Group& group);
/// Whether neither a group moves nor any it stands in; true for none.
bool stands_still(const Scene& scene, std::optional<std::uint32_t> group);

}  // namespace flatray
