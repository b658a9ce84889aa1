#include <algorithm>
#include <cmath>
#include <set>

#include "base/number_text.h"
#include "scene/keys/look_keys.h"
#include "scene/keys/scene_keys.h"
#include "scene/outlines/holes.h"
#include "scene/outlines/lattice_cell.h"
#include "scene/part_counts.h"

namespace flatray {
namespace {

using Hole = WallHole;
using Pillar = Chamber::Pillar;

constexpr Key<Pillar> kPillarKeys[] = {
    kNameKey<Pillar>,
    kShapeKey<Pillar>,
    kAtKey<Pillar>,
    kAngleKey<Pillar>,
    material_key<Pillar>("\"mirror\""),
    fill_key<Pillar>("\"#999999\", of glass \"#ffffff18\", without a stroke, else \"none\""),
    stroke_key<Pillar>("\"none\""),
};

void read_pillars(Builder& builder, const Field& field, Chamber& chamber) {
  each_table(builder, field, [&](const Value& table) {
    Pillar pillar;
    pillar.where = table.where;
    read_keys(builder, table, "pillar", kPillarKeys, pillar);
    if (table.find("fill") == nullptr && table.find("stroke") == nullptr)
      pillar.fill = default_fill(builder.scene, pillar.scatterer, kPillarColour);
    chamber.pillars.push_back(std::move(pillar));
  });
}

constexpr Key<Hole> kHoleKeys[] = {
    kNameKey<Hole>,
    {{"edge", "whole number", "0"}, &set_integer<&Hole::edge, 0, 1'000'000'000>},
    {{"from", "number", kRequired}, &set<&Hole::from>},
    {{"to", "number", kRequired}, &set<&Hole::to>},
};

void read_holes(Builder& builder, const Field& field, Chamber& chamber) {
  std::set<std::string> taken;
  each_table(builder, field, [&](const Value& table) {
    Hole hole;
    hole.where = table.where;
    read_keys(builder, table, "hole", kHoleKeys, hole);
    if (hole.name.empty())
      for (std::size_t n = chamber.holes.size() + 1; hole.name.empty() || taken.contains(hole.name);
           ++n)
        hole.name = fmt::format("hole {}", n);
    if (!(hole.from >= 0 && hole.from < hole.to && hole.from <= 1))
      builder.in.problem(table.where, "the hole is nowhere",
                         "from and to are shares of the wall: 0 <= from < to <= 1; round a circle "
                         "to may lie beyond 1");
    if (!taken.insert(hole.name).second)
      builder.in.problem(table.where, fmt::format("two holes are named '{}'", hole.name),
                         "give each hole its own name");
    chamber.holes.push_back(std::move(hole));
  });
}

// Once the shape and all holes are read without a problem.
void cut_walls_of(Builder& builder, Chamber& chamber) {
  const Shape& shape = builder.scene.shapes[chamber.shape];
  const Hole& first = chamber.holes.front();
  if (part_counts(shape).lines() > 0)
    return builder.in.problem(first.where, "the walls are lines, which enclose nothing",
                              "leave the hole out of them");
  if (chamber.material == Material::periodic)
    return builder.in.problem(first.where, "periodic walls have no holes",
                              "leave material = \"periodic\" out");
  builder.in.add(cut_walls(shape, chamber));
}

void read_walls(Builder& builder, const Field& field, Chamber& chamber) {
  const auto shape = read_shape(builder, field);
  if (!shape) return;
  if (!builder.scene.shapes[*shape].crossing_rings.empty())
    builder.in.problem(field.value.where, "the walls of the chamber cross",
                       "a chamber needs an inside: part the edges that cross");
  chamber.shape = *shape;
}

constexpr Word<Material> kChamberMaterials[] = {
    {"absorb", Material::absorb}, {"mirror", Material::mirror}, {"periodic", Material::periodic}};

constexpr Key<Chamber> kChamberKeys[] = {
    kNameKey<Chamber>,
    {{"shape", "{ KIND = { ... } }", kRequired}, &read_walls},
    {{"material", R"("absorb", "mirror", "periodic" or { MATERIAL = { ... } })", "\"mirror\""},
     &set_material<Chamber, kChamberMaterials>},
    fill_key<Chamber>("\"none\""),
    stroke_key<Chamber>("{ width_px = 1.5, colour = \"#333333\" } without a fill"),
    kOpacityKey<Chamber>,
    kLayerKey<Chamber>,
    {{"pillars", "[{ shape = ... }, ...]", "[]"}, &read_pillars},
    {{"holes", "[{ from = 0.2, to = 0.3 }, ...]", "[]"}, &read_holes},
    {{"field", "number", "0"}, &set<&Chamber::field>},
};

void read_chamber(Builder& builder, const Value& table) {
  Chamber chamber;
  chamber.where = table.where;
  chamber.order = draw_order(builder, table.where);
  const std::size_t problems = builder.in.problems.size();
  read_keys(builder, table, "chamber", kChamberKeys, chamber);
  if (table.find("fill") == nullptr && table.find("stroke") == nullptr)
    chamber.stroke = kDefaultStroke;
  const Member* shape = table.find("shape");
  if (!chamber.holes.empty() && builder.in.problems.size() == problems)
    cut_walls_of(builder, chamber);
  if (chamber.material == Material::periodic && shape != nullptr &&
      builder.in.problems.size() == problems) {
    if (auto fault = cell_fault(builder.scene.shapes[chamber.shape]))
      builder.in.problem(shape->value.where, std::move(fault->message), std::move(fault->hint));
    else
      add_copies_of_discs(builder.scene, chamber);
  }
  builder.scene.chambers.push_back(std::move(chamber));
}

// Whether all its curves are circles, or arcs of them.
bool bends_in_circles(const Shape& shape) {
  return shape.beziers.empty() && std::ranges::all_of(shape.arc_paths, [&](const ArcPath& path) {
           return std::ranges::all_of(path.arcs, &EllipseArc::is_circular);
         });
}

// What of a chamber with a field no flight can be bent among.
void check_walls_in_field(Builder& builder, const Chamber& chamber) {
  const auto refuse = [&](const Place& where, const char* what, const char* hint) {
    builder.in.problem(where, std::string(what) + " in a magnetic field", hint);
  };
  if (chamber.material == Material::periodic)
    refuse(chamber.where, "no periodic walls", "leave field out, or make the walls mirrors");
  if (const Place* glass = place_of_glass(builder.scene))
    refuse(*glass, "no glass",
           "leave the field of the chamber out, or write material = \"mirror\"");
  constexpr const char* kRound =
      "flights are followed among straight walls, circles and their arcs: leave field out, or the "
      "curve";
  if (!bends_in_circles(builder.scene.shapes[chamber.shape]))
    refuse(chamber.where, "no ellipses or Bezier curves", kRound);
  for (const Chamber::Pillar& pillar : chamber.pillars)
    if (!bends_in_circles(builder.scene.shapes[pillar.shape]))
      refuse(pillar.where, "no ellipses or Bezier curves", kRound);
}

}  // namespace

void check_field(Builder& builder) {
  const Scene& scene = builder.scene;
  const bool periodic =
      !scene.chambers.empty() && scene.chambers.front().material == Material::periodic;
  if (const Place* glass = place_of_glass(scene); glass != nullptr && periodic)
    builder.in.problem(*glass, "no glass between periodic walls",
                       "make the walls of the chamber mirrors, or write material = \"mirror\"");
  if (!builder.in.problems.empty() || scene.chambers.empty() || scene.chambers.front().field == 0)
    return;
  if (!std::isnormal(scene.chambers.front().field))
    builder.in.problem(scene.chambers.front().where,
                       "a magnetic field of " + number_text(scene.chambers.front().field),
                       "write 0, or 1 over the radius of the circles that rays fly");
  check_walls_in_field(builder, scene.chambers.front());
  for (const Entity& entity : scene.entities)
    if (entity.material)
      builder.in.problem(entity.where, "an entity that rays meet, in a magnetic field",
                         "write it as a pillar of the chamber, or leave its material out");
  for (const RayPath& ray : scene.rays)
    if (ray.speed)
      builder.in.problem(ray.where, "a ray of finite speed in a magnetic field",
                         "leave its speed out");
  if (!scene.edge_rays.empty())
    builder.in.problem(scene.edge_rays.front().where,
                       "straight edge rays in a magnetic field, which bends rays",
                       "leave them out, or the field of the chamber");
  if (!scene.lamps.empty())
    builder.in.problem(scene.lamps.front().where, "a lamp in a magnetic field, which bends rays",
                       "leave the lamp out, or the field of the chamber");
}

void read_chambers(Builder& builder, const Field& field, Scene&) {
  if (field.value.kind == Value::Kind::array && field.value.items.size() > 1)
    builder.in.problem(field.value.items[1].where, "a second chamber",
                       "a scene holds at most one for now: make the others entities of mirrors");
  each_table(builder, field, [&](const Value& table) { read_chamber(builder, table); });
}

std::vector<TableInfo> chamber_tables() {
  return {{"chamber", key_infos<Chamber>(kChamberKeys)},
          {"chamber.pillars", key_infos<Pillar>(kPillarKeys)},
          {"chamber.holes", key_infos<Hole>(kHoleKeys)}};
}

}  // namespace flatray
