#pragma once
#include "anim/frame_state.h"
#include "base/check.h"
#include "geom/curved_path.h"
#include "scene/scatterer.h"
#include "trace/surfaces.h"

namespace flatray {

/// What a surface belongs to.
struct SurfaceOwner {
  enum class Kind : std::uint8_t { entity, chamber, pillar } kind;
  std::uint32_t index;   ///< entity; chamber
  std::uint32_t pillar;  ///< of the chamber; 0 for what is no pillar
  /// The number of the edge in the shape as given; lone segments, and Bezier curves after them, are
  /// counted from 0, and so are the arcs of a path with the lines that join them; kNoEdge for a
  /// circle.
  std::int32_t edge;
  Material material;              ///< of an entity without one: absorbs
  std::uint32_t hole = kNoEntry;  ///< of the chamber: what of the edge is this hole
  bool turned = false;            ///< the edge as given runs the other way
};

/// The walls of one frame in world coordinates, each with its owner.
///
/// Which edges are left out depends on where things stand: a surface number means something in the
/// world it comes from alone.
struct World {
  Surfaces surfaces;
  std::vector<SurfaceOwner> owners;  ///< by surface number

  template <class Wall>
  void add(const Wall& wall, const SurfaceOwner& owner) {
    surfaces.add(wall);
    owners.push_back(owner);
  }
  /// Needs   the number of one of its surfaces.
  const SurfaceOwner& owner(std::uint32_t surface) const {
    FLATRAY_CHECK(surface < owners.size());
    return owners[surface];
  }

  /// By surface number, as orbits take them.
  std::vector<Material> materials() const;
};

/// What each wall of a world does with light, by surface; nullptr: its material says all.
std::vector<const Scatterer*> scatterers_of(const Scene& scene, const World& world);

/// The whole curve of an arc in the world; one of a circle stays a circle.
Ellipse curve_of(const EllipseArc& arc, const Pose& place);

/// Arcs and the lines that join them in the world, numbered in turn.
CurvedPath path_in_world(const ArcPath& path, const Pose& place);

/// What a world is made of.
enum class WorldOf : std::uint8_t {
  mirrors,    ///< entities with a material, as orbits meet them
  everything  ///< entities without one, too
};

/// Adds the outline of a shape, all with one owner but for the edge.
void add_shape(World& world, const Shape& shape, const Pose& place, SurfaceOwner owner);

/// Outlines of every chamber and pillar, and of entities as `of` says. Left out: cuts and shared
/// edges between the pieces of one shape, crossing rings, and edges whose ends are one point in
/// the world.
///
/// Gives   entities, then chambers each with its pillars; of a shape its edges, its lone segments,
///         its Bezier curves, its circles, its arcs with the lines that join them. Edges run
///         counter-clockwise. Edges that share a vertex in the shape share its doubles in the
///         world.
/// Cost    O(n log n) edges for shapes of several pieces, else O(n).
World build_world(const Scene& scene, const FrameState& state, WorldOf of = WorldOf::mirrors);

/// How many the next makes: at most 1024.
std::size_t count_of_worlds(const Scene& scene);
/// The worlds of entities with alternatives: the first as above, then with all of their second shapes,
/// and so on, beginning again with those that have fewer. The numbers of their surfaces mean the same.
std::vector<World> alternative_worlds(const Scene& scene, const FrameState& state);

}  // namespace flatray
