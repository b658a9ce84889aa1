#pragma once
#include "scene/imports/imports.h"
#include "scene/load.h"
#include "scene/reading/reader.h"

namespace flatray {

/// What the readers of all keys share while one scene is built.
struct Builder {
  Reader in;
  Scene scene;
  Imports& imports;
  const LoadLimits& limits;
  std::optional<std::uint64_t> seed;  ///< instead of the scene's
  TextOrder text_order{};
  std::uint32_t entity_tables = 0;  ///< read so far
  /// Copies by the name in the file; a group without any stands in itself, which is told.
  std::map<std::string, std::vector<std::uint32_t>> groups{};
  std::vector<std::string> group_suffixes{};  ///< what copying added to the name of each group
  /// Shapes in which nothing is drawn, so that copies share them.
  std::map<const Value*, ShapeId> fixed_shapes{};
  std::map<const Value*, CurveId> fixed_curves{};  ///< likewise
  std::map<const Value*, ScattererId> fixed_scatterers{};
  std::map<const Member*, std::uint32_t> fixed_paths{};
  std::map<const SourceText*, std::shared_ptr<const Spectrum>>
      spectra{};              ///< null: wrong, and told
  std::uint64_t corners = 0;  ///< counted so far; see corner_limit.h
  bool full = false;          ///< more than the limit: told
  bool may_change = false;    ///< whether the shape, paint or width being read may be a curve
  std::uint64_t checked_corners = 0;  ///< of shapes that change, at all times looked at
  struct Named {
    std::uint32_t index = 0, count = 0;
  };
  std::map<std::string, Named> entity_names{};  ///< of the entities read so far
};

/// Names of a map to suggest one of them: the first, as thousands of words may be wrong.
template <class Map>
std::vector<std::string> some_names(const Map& known) {
  constexpr std::size_t kEnough = 1000;
  std::vector<std::string> names;
  for (auto one = known.begin(); one != known.end() && names.size() < kEnough; ++one)
    if (!one->first.empty()) names.push_back(one->first);
  return names;
}

/// Builds a shape, `{ KIND = { ... } }`, into the scene; nullopt where it is wrong.
std::optional<ShapeId> read_shape(Builder& builder, const Field& field);

/// Where copy `number` of what stands there comes in the order of drawing: that of the text, files
/// included first, copies by number.
std::uint64_t draw_order(const Builder& builder, const Place& where, std::uint64_t number = 0);

/// Number of the entity of that name; unknown and ambiguous names are problems.
std::optional<std::uint32_t> find_entity(Builder& builder, const Field& field);

}  // namespace flatray
