#include "scene/keys/collision_keys.h"
#include "scene/keys/copies.h"
#include "scene/keys/corner_limit.h"
#include "scene/keys/look_keys.h"
#include "scene/keys/markov_keys.h"
#include "scene/keys/motion_keys.h"
#include "scene/keys/scene_keys.h"
#include "scene/part_counts.h"

namespace flatray {
namespace {

// A look can hide what the entity shows: "none" is a colour no one sees.
constexpr Colour kUnseen{0, 0, 0, 0};

void read_look_fill(Builder& builder, const Field& field, Look& look) {
  read_fill(builder, field, look.fill);
  if (!look.fill) look.fill = kUnseen;
}

void read_look_stroke(Builder& builder, const Field& field, Look& look) {
  read_optional_stroke(builder, field, look.stroke);
  if (!look.stroke) look.stroke = Stroke{kDefaultStroke.width, true, kUnseen};
}

constexpr const char* kChangingFill =
    R"("#rrggbb", "none", a curve, { linear = { ... } } or { radial = { ... } })";

constexpr Key<Look> kLookKeys[] = {
    kNameKey<Look>,
    {{"shape", "{ KIND = { ... } }", "the entity's"}, &set_shape<Look>, true},
    {{"fill", kChangingFill, "the entity's"}, &read_look_fill, true},
    {{"stroke", R"({ width = w, colour = "#rrggbb" } or "none")", "the entity's"},
     &read_look_stroke,
     true},
    {{"velocity", "[vx, vy]", "the entity's"}, &set<&Look::velocity>},
};

void read_states(Builder& builder, const Field& field, Entity& entity) {
  const auto read_look = [&](const Value& table, const std::string& name) {
    Look look;
    read_keys(builder, table, name, kLookKeys, look);
    return look;
  };
  read_looks(builder, field, entity.markov, read_look);
}

bool is_one_segment(const Scene& scene, ShapeId id) {
  if (id >= scene.shapes.size()) return true;  // told
  const Shape& shape = scene.shapes[id];
  return shape.changes == kNoEntry && part_counts(shape) == PartCounts{.segments = 1};
}

void read_alternatives(Builder& builder, const Field& field, Entity& entity) {
  if (!builder.in.is(field, Value::Kind::array, "a list of shapes")) return;
  constexpr std::size_t kMostAlternatives = 1023;
  if (field.value.items.size() > kMostAlternatives)
    return builder.in.problem(field, "holds more than 1023 shapes", "write fewer");
  for (std::size_t i = 0; i < field.value.items.size(); ++i)
    if (const auto shape = read_shape(builder, field.item(i)))
      entity.alternatives.push_back(*shape);
}

// Worlds differ in where a wall is, not in which there are.
void check_alternatives(Builder& builder, const Entity& entity, const Value& table) {
  const Scene& scene = builder.scene;
  bool right = is_one_segment(scene, entity.shape) && !entity.markov;
  for (const ShapeId shape : entity.alternatives) right = right && is_one_segment(scene, shape);
  const Member* key = table.find("alternatives");
  if (!right && key != nullptr)
    builder.in.problem(key->where, "alternatives are not one segment each, as the shape must be",
                       "write alternatives = [{ segment = { from = [0, 0], to = [1, 0] } }]");
}

constexpr Key<Entity> kEntityKeys[] = {
    kNameKey<Entity>,
    {kShapeKey<Entity>.info, &set_shape<Entity>, true},
    kGroupKey<Entity>,
    kMovingAtKey<Entity>,
    kMovingAngleKey<Entity>,
    kVelocityKey<Entity>,
    kAngularVelocityKey<Entity>,
    {{"fill", kChangingFill,
      "\"#333333\", of glass \"#ffffff18\", without a stroke, else \"none\""},
     &set_fill<Entity>,
     true},
    {{"stroke", R"({ width = w, colour = "#rrggbb" } or "none")",
      "\"none\"; a segment without fill and stroke has one"},
     &set_stroke<&Entity::stroke>,
     true},
    {{"bounding_box", R"({ width = w, colour = "#rrggbb" } or "none")", "\"none\""},
     &set_stroke<&Entity::bounding_box>},
    kMovingOpacityKey<Entity>,
    kLayerKey<Entity>,
    material_key<Entity>("none: rays pass"),
    {{"alternatives", "[{ segment = { from = [x, y], to = [x, y] } }, ...]", "[]"},
     &read_alternatives},
    response_key<Entity>("that of collisions"),
    {{"mass", "number or \"fixed\"", "its area"}, &read_mass},
    kMarkovKey<Entity>,
    states_key<Entity>(&read_states),
    kFollowKey<Entity>,
    kRepeatKey<Entity>,
};

// What is hidden on purpose says that it has no stroke, either.
void warn_of_unseen(Builder& builder, const Value& table, const Entity& entity) {
  const Member* fill = table.find("fill");
  if (fill == nullptr || entity.fill || table.find("stroke") != nullptr || entity.bounding_box ||
      entity.markov || entity.material || entity.scatterer != kNoEntry)
    return;
  builder.in.warning(fill->value.where, "the entity draws nothing: it has no fill and no stroke",
                     R"(write stroke = { colour = "#333333" }, or stroke = "none" to hide it)");
}

// Whether a shape has no inside.
bool is_lines(const Scene& scene, ShapeId shape) {
  return shape < scene.shapes.size() && part_counts(scene.shapes[shape]).areas() == 0;
}

// Filled as the entity is.
void warn_of_unseen_states(Builder& builder, const Value& table, const Entity& entity) {
  const Member* states = table.find("states");
  if (states == nullptr || !entity.markov || !entity.fill || entity.stroke || entity.material ||
      table.find("stroke") != nullptr)
    return;
  const auto is_unseen = [&](const Look& look) {
    return look.shape && !look.stroke && is_lines(builder.scene, *look.shape);
  };
  if (std::ranges::any_of(entity.markov->looks, [&](const std::vector<Look>& looks) {
        return std::ranges::any_of(looks, is_unseen);
      }))
    builder.in.warning(states->where, "a state's shape of lines has no inside to fill",
                       "write stroke = { colour = \"#rrggbb\" } in that state");
}

void dress(Builder& builder, const Value& table, Entity& entity) {
  const Scene& scene = builder.scene;
  const bool lines = is_lines(scene, entity.shape);
  const Member* fill = table.find("fill");
  if (fill != nullptr && entity.fill && lines)
    builder.in.warning(fill->value.where, "a shape of lines has no inside to fill",
                       "write stroke = { colour = \"#rrggbb\" }");
  warn_of_unseen(builder, table, entity);
  if (fill == nullptr && table.find("stroke") == nullptr) {
    if (lines)
      entity.stroke = kDefaultStroke;
    else
      entity.fill = default_fill(scene, entity.scatterer, kDefaultColour);
  }
  warn_of_unseen_states(builder, table, entity);
}

void add_entity(Builder& builder, Entity&& entity) {
  auto& named = builder.entity_names[entity.name];
  named.index = static_cast<std::uint32_t>(builder.scene.entities.size());
  ++named.count;
  builder.scene.entities.push_back(std::move(entity));
}

void read_entity(Builder& builder, const Value& table) {
  expect_chain(builder, table, "entity");
  const Scene& scene = builder.scene;
  const auto add = [&](Entity&& entity, std::uint64_t copy, const std::string&) {
    if (!take_corners(builder, corner_count(scene, entity), table.where)) return;
    refuse_hindered(builder, entity, table);
    dress(builder, table, entity);
    if (!entity.alternatives.empty()) check_alternatives(builder, entity, table);
    entity.order = draw_order(builder, table.where, copy);
    if (entity.group) entity.layer += scene.groups[*entity.group].layer;
    add_entity(builder, std::move(entity));
  };
  make_copies<Entity>(builder, table, {"entity", builder.entity_tables++, scene.entities.size()},
                      kEntityKeys, add);
}

}  // namespace

void read_entities(Builder& builder, const Field& field, Scene&) {
  each_table(builder, field, [&](const Value& table) { read_entity(builder, table); });
}

std::uint64_t draw_order(const Builder& builder, const Place& where, std::uint64_t number) {
  constexpr unsigned kCopyBits = 24;
  constexpr std::uint64_t kLastCopy = (std::uint64_t{1} << kCopyBits) - 1;
  return builder.text_order.at(where) << kCopyBits | std::min(number, kLastCopy);
}

std::optional<std::uint32_t> find_entity(Builder& builder, const Field& field) {
  const auto name = builder.in.string(field);
  if (!name) return std::nullopt;
  const auto found = builder.entity_names.find(*name);
  const auto copy = builder.entity_names.lower_bound(*name + ".");
  if (found == builder.entity_names.end() && copy != builder.entity_names.end() &&
      copy->first.starts_with(*name + "."))
    return builder.in.refuse({field.value.where, fmt::format("'{}' has copies", *name),
                              fmt::format("call one of them: \"{}\"", copy->first)});
  if (found == builder.entity_names.end())
    return builder.in.refuse(
        unknown_word(field.value.where, "entity", *name, some_names(builder.entity_names)));
  if (found->second.count == 1) return found->second.index;
  return builder.in.refuse({field.value.where, fmt::format("two entities are named '{}'", *name),
                            "give each a name of its own"});
}

std::vector<TableInfo> entity_tables() {
  return {{"entity", key_infos<Entity>(kEntityKeys), true},
          {"entity.markov", markov_use_keys()},
          {"entity.states", key_infos<Look>(kLookKeys), true}};
}

}  // namespace flatray
