#include "scene/load.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/left_out.h"
#include "scene/keys/build_scene.h"
#include "scene/reading/format.h"
#include "scene/reading/include.h"
#include "scene/reading/overrides.h"

namespace flatray {
namespace {

Result<const Format*> choose_format(const SourceText& source) {
  const bool is_stream = source.name() == "-";
  const Format* format =
      is_stream ? format_for_text(source.text()) : format_for_name(source.name());
  if (format != nullptr) return format;
  const std::string& name = source.name();
  if (const auto problem = if_left_out(named_place(name), "format", extension_of(name)))
    return tl::unexpected(Diagnostics{*problem});
  return fail(named_place(name), "no scene format has this extension",
              "known: " + known_extensions());
}

Result<SceneDesc> describe(const SourcePtr& source, const std::vector<Override>& overrides,
                           Imports& imports, const LoadLimits& limits) {
  FLATRAY_TRY(format, choose_format(*source));
  Result<SceneDesc> desc = (*format)->read(source, limits);
  if (!desc) return desc;
  if (Result<void> taken = take_includes(*desc, source, imports, limits); !taken)
    return fail(std::move(taken));
  for (const Override& one : overrides)
    if (Result<void> applied = apply_override(*desc, one); !applied)
      return fail(std::move(applied));
  return desc;
}

std::uint64_t hash_of(const SourceText& source, const std::vector<Override>& overrides,
                      const Imports& imports) {
  Hash hash;
  hash.add(source.text());
  for (const Override& one : overrides) hash.add(one.key).add(one.value);
  imports.add_to(hash);
  return hash.value();
}

Result<ReadScene> read_text(std::string name, std::string text,
                            const std::vector<Override>& overrides, const LoadLimits& limits,
                            std::optional<std::uint64_t> seed) {
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  const auto source = std::make_shared<const SourceText>(std::move(name), std::move(text));
  Imports imports(source, limits.max_bytes, limits.threads, limits.root);
  Result<SceneDesc> desc = describe(source, overrides, imports, limits);
  Result<LoadedScene> loaded =
      desc ? build_scene(*desc, imports, limits, seed) : Result<LoadedScene>(fail(std::move(desc)));
  if (!loaded) {
    tell_where_said(loaded.error());
    return fail(std::move(loaded));
  }
  tell_where_said(loaded->warnings);
  loaded->scene.name = scene_name(source->name());
  loaded->scene.where = named_place(source->name());
  loaded->scene.ends = desc->ends;
  loaded->scene.hash = hash_of(*source, overrides, imports);
  return ReadScene{std::move(*desc), std::move(*loaded)};
}

}  // namespace

Result<ReadScene> read_scene(const std::filesystem::path& path,
                             const std::vector<Override>& overrides, const LoadLimits& limits,
                             std::optional<std::uint64_t> seed) {
  FLATRAY_TRY(text, read_file(path, {limits.max_bytes, raise_max_bytes(limits.max_bytes), true}));
  return read_text(path.string(), std::move(*text), overrides, limits, seed);
}

Result<LoadedScene> load_scene(const std::filesystem::path& path,
                               const std::vector<Override>& overrides, const LoadLimits& limits,
                               std::optional<std::uint64_t> seed) {
  FLATRAY_TRY(read, read_scene(path, overrides, limits, seed));
  return std::move(read->loaded);
}

Result<LoadedScene> load_scene_text(std::string name, std::string text,
                                    const std::vector<Override>& overrides,
                                    const LoadLimits& limits, std::optional<std::uint64_t> seed) {
  FLATRAY_TRY(read, read_text(std::move(name), std::move(text), overrides, limits, seed));
  return std::move(read->loaded);
}

}  // namespace flatray
