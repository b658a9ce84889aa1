#include "scene/keys/collision_keys.h"

#include "base/check.h"
#include "scene/keys/look_keys.h"
#include "scene/keys/scene_keys.h"

namespace flatray {
namespace {

constexpr std::int64_t kMostEvents = 1'000'000'000;

template <auto Pointer>
void set_line(Builder& builder, const Field& field, Collisions& collisions) {
  collisions.*Pointer = Stroke{1, true, kDefaultColour};
  set_stroke<Pointer>(builder, field, collisions);
}

constexpr Key<Collisions> line_key(const char* name,
                                   void (*read)(Builder&, const Field&, Collisions&)) {
  return {{name, R"({ width = w, colour = "#rrggbb" } or "none")", "\"none\""}, read};
}

constexpr NumberRule kShownRule{&is_above_zero, "is not above 0",
                                "write how many seconds it takes to fade"};
constexpr NumberRule kMassRule{&is_above_zero, "is not above 0",
                               "write a mass, or \"fixed\" for what nothing moves"};

constexpr Key<Collisions> kCollisionKeys[] = {
    response_key<Collisions>("\"none\""),
    {{"most", "whole number", "1000000"}, &set_integer<&Collisions::most, 1, kMostEvents>},
    {{"points", "\"#rrggbb\"", "none"}, &set<&Collisions::points>},
    line_key("normals", &set_line<&Collisions::normals>),
    line_key("ghosts", &set_line<&Collisions::ghosts>),
    line_key("time_bar", &set_line<&Collisions::time_bar>),
    {{"shown", "seconds", "to the end"}, &set_number<&Collisions::shown, kShownRule>},
    {{"layer", "whole number", "1"}, &set_integer<&Collisions::layer, -1000000, 1000000>},
};

}  // namespace

void read_collisions(Builder& builder, const Field& field, Scene& scene) {
  Collisions collisions;
  collisions.where = field.value.where;
  collisions.order = draw_order(builder, field.value.where);
  read_keys(builder, field.value, "collisions", kCollisionKeys, collisions);
  scene.collisions = collisions;
}

void read_mass(Builder& builder, const Field& field, Entity& entity) {
  static constexpr Word<double> kWords[] = {{"fixed", kInfinity}};
  if (field.value.kind == Value::Kind::string)
    set_word<&Entity::mass, kWords>(builder, field, entity);
  else
    set_number<&Entity::mass, kMassRule>(builder, field, entity);
}

void refuse_hindered(Builder& builder, const Entity& entity, const Value& table) {
  if (response_of(builder.scene, entity) == Response::none) {
    if (entity.markov && entity.markov->hit)
      builder.in.problem(table.find("markov")->value.where,
                         called("entity", entity.name, entity.where) +
                             " does not respond to contact, so nothing hits it",
                         R"(write response = "mark", or another response)");
    return;
  }
  if (entity.shape >= builder.scene.shapes.size()) return;  // a mistake that has been told
  const auto why = hindrance(builder.scene, entity);
  if (!why) return;
  const Member* key = table.find(why->key);
  builder.in.problem(
      key != nullptr ? key->value.where : table.where,
      fmt::format("{} {}, so it cannot respond to contact",
                  called("entity", entity.name, entity.where), why->what),
      "responses are for what keeps one velocity until it meets something: write response = "
      "\"none\" in the entity");
}

const char* name(Response response) {
  for (const auto& [word, meaning] : kResponses)
    if (meaning == response) return word;
  unreachable();
}

std::vector<TableInfo> collision_tables() {
  return {{"collisions", key_infos<Collisions>(kCollisionKeys)}};
}

}  // namespace flatray
