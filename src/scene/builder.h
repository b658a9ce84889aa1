#pragma once
#include "scene/imports.h"
#include "scene/load.h"
#include "scene/reader.h"

namespace flatray {

/// What the readers of all keys share while one scene is built.
struct Builder {
  Reader in;
  Scene scene;
  Imports& imports;
  const LoadLimits& limits;
  struct Named {
    std::uint32_t index = 0, count = 0;
  };
  std::map<std::string, Named> entity_names{};  ///< of the entities read so far
};

/// Most entities, pillars, rays and states of one scene.
inline constexpr std::size_t kMaxEntries = 1'000'000;

/// Builds a shape, `{ KIND = { ... } }`, into the scene; nullopt where it is wrong.
std::optional<ShapeId> read_shape(Builder& builder, const Field& field);

/// Number of the entity of that name; unknown and ambiguous names are problems.
std::optional<std::uint32_t> find_entity(Builder& builder, const Field& field);

}  // namespace flatray
