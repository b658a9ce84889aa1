#include "scene/keys/build_scene.h"

#include <tuple>

#include "scene/keys/curve_keys.h"
#include "scene/keys/keys.h"
#include "scene/keys/look_keys.h"
#include "scene/keys/motion_keys.h"
#include "scene/keys/scene_keys.h"
#include "scene/repeat.h"

namespace flatray {
namespace {

constexpr std::int64_t kVersion = 1;
constexpr std::int64_t kMaxSeed = 0x7fffffffffffffff;  // what a TOML integer holds

void read_version(Reader& in, const Field& field) {
  const auto version = in.integer(field, 1, kMaxSeed);
  if (version && *version > kVersion)
    in.problem(field.value.where,
               fmt::format("scene version {} is newer than this program", *version),
               fmt::format("it reads version {}", kVersion));
}

// Those of files are gone by now.
void refuse_include(Builder& builder, const Field& field, Scene&) {
  builder.in.problem(field.value.where, "include stands only in a file",
                     "write a file that includes both");
}

constexpr NumberRule kFpsRule{&is_above_zero, "is not above 0", "write frames a second"};

// So that the times of all frames are numbers.
void read_fps(Builder& builder, const Field& field, Scene& scene) {
  constexpr double kLeast = 1e-100;
  set_number<&Scene::fps, kFpsRule>(builder, field, scene);
  if (scene.fps < kLeast)
    builder.in.problem(field.value.where, "fps is below 1e-100", "write 1e-100 or more");
}

void read_seed(Builder& builder, const Field& field, Scene& scene) {
  const auto seed = builder.in.integer(field, 0, kMaxSeed);
  if (seed && !builder.seed) scene.seed = static_cast<std::uint64_t>(*seed);
}

// In the order in which one builds on another, not that of the file.
constexpr Key<Scene> kSceneKeys[] = {
    {{"flatray", "1", kRequired},
     [](Builder& builder, const Field& field, Scene&) { read_version(builder.in, field); }},
    {{"include", "[\"part.toml\", ...]", "[]"}, &refuse_include},
    {{"film", "{ size = [w, h], ... }", "{}"}, &read_film},
    {{"frames", "whole number", "1"}, &set_integer<&Scene::frames, 1, kLastFrame>},
    {{"fps", "frames a second", "24"}, &read_fps},
    {{"seed", "whole number", "0"}, &read_seed},
    {{"markov", "[markov.NAME]", "{}"}, &read_chains},
    {{"group", "[[group]]", "[]"}, &read_groups},
    {{"collisions", "{ ... }", "{}"}, &read_collisions},
    {{"entity", "[[entity]]", "[]"}, &read_entities},
    {{"chamber", "[[chamber]]", "[]"}, &read_chambers},
    {{"ray", "[[ray]]", "[]"}, &read_rays},
    {{"edge_rays", "[[edge_rays]]", "[]"}, &read_edge_rays},
    {{"lamp", "[[lamp]]", "[]"}, &read_lamps},
    {{"light", "{ rays = n, ... }", "{}"}, &read_light},
    {{"camera", "{ at = [x, y], ... }", "{}"}, &read_camera},
};

// Files in the order of their entries, what is in none of them last.
void sort_by_source(Diagnostics& diagnostics, const Builder& builder) {
  const auto rank = [&](const Diagnostic& d) {
    const bool here = builder.text_order.is_in_a_file(d.where);
    return std::tuple(!here, here ? builder.text_order.at(d.where) : 0);
  };
  std::ranges::stable_sort(diagnostics, {}, rank);
}

}  // namespace

Result<LoadedScene> build_scene(const SceneDesc& desc, Imports& imports, const LoadLimits& limits,
                                std::optional<std::uint64_t> seed) {
  Builder builder{.in = {}, .scene = {}, .imports = imports, .limits = limits, .seed = seed};
  builder.in.warnings = desc.warnings;
  builder.scene.seed = seed.value_or(0);
  builder.scene.max_corners = limits.max_corners;
  builder.text_order = TextOrder(desc);
  read_keys(builder, desc.root, "scene", kSceneKeys, builder.scene);
  const Member* film = desc.root.find("film");
  if (!builder.scene.lamps.empty() && (film == nullptr || !film->value.find("background")))
    builder.scene.film.background = {0, 0, 0, 255};
  check_light(builder);
  check_field(builder);
  sort_by_source(builder.in.problems, builder);
  sort_by_source(builder.in.warnings, builder);
  if (!builder.in.problems.empty()) return tl::unexpected(std::move(builder.in.problems));
  return LoadedScene{std::move(builder.scene), std::move(builder.in.warnings)};
}

void check_version(Reader& in, const Value& scene) {
  if (const Member* version = scene.find("flatray"))
    read_version(in, {"flatray", version->value, "1"});
  else
    in.problem(scene.where, "the included scene needs 'flatray'", "write flatray = 1");
}

std::vector<TableInfo> language_tables() {
  std::vector<TableInfo> all{{"scene", key_infos<Scene>(kSceneKeys)}};
  for (auto* tables : {&film_tables, &group_tables, &entity_tables, &gradient_tables, &look_tables,
                       &curve_tables, &motion_tables, &repeat_tables, &collision_tables,
                       &chamber_tables, &ray_tables, &lamp_tables, &markov_tables})
    for (TableInfo& table : tables()) all.push_back(std::move(table));
  return all;
}

}  // namespace flatray
