#include "scene/build_scene.h"

#include <tuple>

#include "scene/keys.h"
#include "scene/look_keys.h"
#include "scene/repeat.h"
#include "scene/scene_keys.h"

namespace flatray {
namespace {

constexpr std::int64_t kVersion = 1;
constexpr std::int64_t kMaxFrames = 9'999'999;
constexpr std::int64_t kMaxSeed = 0x7fffffffffffffff;  // what a TOML integer holds

void read_version(Builder& builder, const Field& field, Scene&) {
  const auto version = builder.in.integer(field, 1, kMaxSeed);
  if (version && *version > kVersion)
    builder.in.problem(field.value.where,
                       fmt::format("scene version {} is newer than this program", *version),
                       fmt::format("it reads version {}", kVersion));
}

void read_fps(Builder& builder, const Field& field, Scene& scene) {
  const auto fps = builder.in.number(field);
  if (!fps) return;
  if (!(*fps > 0))
    return builder.in.problem(field.value.where, "fps is not above 0", "write frames a second");
  scene.fps = *fps;
}

void read_seed(Builder& builder, const Field& field, Scene& scene) {
  const auto seed = builder.in.integer(field, 0, kMaxSeed);
  if (seed && !builder.seed) scene.seed = static_cast<std::uint64_t>(*seed);
}

// In the order in which one builds on another, not that of the file.
constexpr Key<Scene> kSceneKeys[] = {
    {{"flatray", "1", kRequired}, &read_version},
    {{"film", "{ size = [w, h], ... }", "{}"}, &read_film},
    {{"frames", "whole number", "1"}, &set_integer<&Scene::frames, 1, kMaxFrames>},
    {{"fps", "frames a second", "24"}, &read_fps},
    {{"seed", "whole number", "0"}, &read_seed},
    {{"markov", "[markov.NAME]", "{}"}, &read_chains},
    {{"group", "[[group]]", "[]"}, &read_groups},
    {{"entity", "[[entity]]", "[]"}, &read_entities},
    {{"chamber", "[[chamber]]", "[]"}, &read_chambers},
    {{"ray", "[[ray]]", "[]"}, &read_rays},
    {{"edge_rays", "[[edge_rays]]", "[]"}, &read_edge_rays},
    {{"camera", "{ at = [x, y], ... }", "{}"}, &read_camera},
};

void sort_by_source(Diagnostics& diagnostics, const SourcePtr& main) {
  const auto rank = [&](const Diagnostic& d) {
    const bool here = d.where.source == main;
    return std::tuple(!here, here ? d.where.offset : 0);
  };
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return rank(a) < rank(b); });
}

void append_tables(std::vector<TableInfo>& to, std::vector<TableInfo> from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

Result<LoadedScene> build_scene(const SceneDesc& desc, Imports& imports, const LoadLimits& limits,
                                std::optional<std::uint64_t> seed) {
  Builder builder{.in = {}, .scene = {}, .imports = imports, .limits = limits, .seed = seed};
  builder.in.warnings = desc.warnings;
  builder.scene.seed = seed.value_or(0);
  read_keys<Scene>(builder, desc.root, "scene", kSceneKeys, builder.scene);
  sort_by_source(builder.in.problems, desc.root.where.source);
  sort_by_source(builder.in.warnings, desc.root.where.source);
  if (!builder.in.problems.empty()) return tl::unexpected(std::move(builder.in.problems));
  return LoadedScene{std::move(builder.scene), std::move(builder.in.warnings)};
}

std::vector<TableInfo> language_tables() {
  std::vector<TableInfo> all{{"scene", key_infos<Scene>(kSceneKeys)}};
  for (auto* tables : {&film_tables, &group_tables, &entity_tables, &look_tables, &repeat_tables,
                       &chamber_tables, &ray_tables, &markov_tables})
    append_tables(all, tables());
  return all;
}

}  // namespace flatray
