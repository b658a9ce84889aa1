#include "scene/keys/corner_limit.h"

#include <fmt/core.h>

#include <algorithm>

namespace flatray {
namespace {

// Bytes kept for a shape or a look without corners, in corners of about 24 bytes.
constexpr std::uint64_t kEmptyShape = 8, kLook = 8;
constexpr std::uint64_t kLettersACorner = 16;

}  // namespace

bool take_corners(Builder& builder, std::uint64_t count, const Place& where) {
  const std::uint64_t limit = builder.limits.max_corners;
  if (builder.full) return false;
  builder.corners += count;
  if (builder.corners <= limit) return true;
  builder.full = true;
  builder.in.problem(
      where, fmt::format("the corners of the scene come to more than {}", limit),
      "points, keys, stops, dashes, states and names count, with every copy: draw less of them at "
      "random, or say --max-corners N");
  return false;
}

std::uint64_t corner_count(const Shape& shape) {
  std::uint64_t count =
      kEmptyShape + shape.vertices.size() + shape.circles.size() + shape.segments.size();
  for (const std::vector<Vec2>& ring : shape.crossing_rings) count += ring.size();
  for (const ArcPath& path : shape.arc_paths) count += 4 * path.arcs.size();
  count += 4 * shape.beziers.size();
  return count;
}

std::uint64_t corner_count(const std::string& name) { return name.size() / kLettersACorner; }

std::uint64_t corner_count(const Scene& scene, const Entity& entity) {
  const auto walls = [&](ShapeId id) {
    const bool met = entity.material && id < scene.shapes.size();
    return met ? corner_count(scene.shapes[id]) : 0;
  };
  std::uint64_t count = corner_count(entity.name), most = walls(entity.shape);
  if (!entity.markov) return count + most;
  for (const std::vector<Look>& looks : entity.markov->looks)
    for (const Look& look : looks)
      if (look.shape) most = std::max(most, walls(*look.shape));
  return count + corner_count(entity.markov) + most;
}

std::uint64_t corner_count(const std::optional<MarkovUse>& markov) {
  std::uint64_t count = 0;
  if (!markov) return count;
  for (const std::vector<Look>& looks : markov->looks) {
    ++count;
    for (const Look& look : looks) count += kLook + corner_count(look.name);
  }
  return count;
}

}  // namespace flatray
