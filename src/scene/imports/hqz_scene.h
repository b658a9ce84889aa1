#pragma once
#include <array>
#include <optional>

#include "geom/vec.h"
#include "scene/load.h"
#include "scene/reading/scene_desc.h"

namespace flatray {

/// A number that may be drawn evenly from a range; its ends in any order.
struct HqzRange {
  double low = 0, high = 0;
  Place where{};

  bool is_number() const { return low == high; }
  double middle() const { return low / 2 + high / 2; }
};

/// A light: what its numbers are drawn from, degrees clockwise and y down.
struct HqzLight {
  HqzRange power{}, x{}, y{}, polar_angle{}, polar_distance{}, ray_angle{};
  enum class Colour : std::uint8_t { white, nm, kelvin } colour = Colour::white;
  HqzRange wavelength{};  ///< nm or kelvin
  Place where{};
};

/// A straight wall from `at` to `at` + `along`.
struct HqzObject {
  std::size_t material = 0;
  HqzRange x{}, y{}, dx{}, dy{};
  /// Degrees of its normal at the beginning, and how much more there are at its end.
  struct Normal {
    HqzRange angle, turn;
  };
  std::optional<Normal> normal{};
  std::optional<Vec2> end{};  ///< of a part of a wall, instead of what dx and dy lead to
  Place where{};
};

/// What part of the light goes where; the rest is absorbed.
struct HqzMaterial {
  double scattered = 0, through = 0, mirrored = 0;
  auto operator<=>(const HqzMaterial&) const = default;
};

/// A scene of HQZ, one line of an animation.
struct HqzScene {
  Place where;
  std::array<double, 2> resolution{};
  Value size{};  ///< the resolution as it is written
  double left = 0, top = 0, width = 0, height = 0;
  double exposure = 0, gamma = 0;
  std::optional<Value> rays{}, seed{};
  std::vector<HqzLight> lights{};
  std::vector<HqzObject> objects{};
  std::vector<HqzMaterial> materials{};
};

/// What the values mean.
///
/// Error   every mistake, with its place. What cannot be honoured, and what is not known, goes to
///         `warnings`.
/// Source  the format as hqz/README.md of github.com/scanlime/zenphoton describes it.
Result<HqzScene> read_hqz_scene(const Value& scene, const LoadLimits& limits,
                                Diagnostics& warnings);

/// Leaves of walls that lie on one another only the first there: light ends at what lies on another
/// wall. Walls with ranges or normals of their own stay. Exact for the doubles given.
///
/// Gives   the walls, in order; of one that is covered in parts the parts left.
/// Cost    O(n log n), and O(k^2) of k walls nearly on one line; more than 4096 such are not looked at,
///         which is warned of.
std::vector<HqzObject> without_overlaps(std::vector<HqzObject> objects, Diagnostics& warnings);

/// The scenes of all frames as one description: what differs between them are curves that step. A wall
/// that is drawn for every ray is one of 64 alternatives, of an animation the one in its middle.
///
/// Needs   at least one scene.
/// Error   an exposure or a viewport that leaves no picture.
Result<SceneDesc> describe_hqz(std::vector<HqzScene> scenes, Diagnostics& warnings);

}  // namespace flatray
