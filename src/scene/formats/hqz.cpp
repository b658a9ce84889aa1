#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "scene/imports/hqz_scene.h"
#include "scene/reading/format.h"
#include "scene/reading/json_value.h"

namespace flatray::hqz_format {
namespace {

// Bytes of each scene: the whole text, or, where its first line is a scene by itself, each line.
std::vector<std::pair<std::size_t, std::size_t>> scenes_in(const SourcePtr& source) {
  const std::string_view text = source->text();
  std::vector<std::pair<std::size_t, std::size_t>> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (!trimmed(text.substr(begin, end - begin)).empty()) {
      lines.emplace_back(begin, end);
      if (lines.size() == 1 && !json_value(source, begin, end)) break;
    }
    begin = end + 1;
  }
  if (lines.size() > 1) return lines;
  return {{0, text.size()}};
}

// Numbers that are kept, each of which may be another in every line.
constexpr std::uint64_t kOfObject = 4, kOfLight = 12;

Result<SceneDesc> read(const SourcePtr& source, const LoadLimits& limits) {
  std::vector<HqzScene> scenes;
  Diagnostics warnings, problems;
  std::uint64_t numbers = 0;
  for (const auto& [begin, end] : scenes_in(source)) {
    FLATRAY_TRY(value, json_value(source, begin, end));
    Result<HqzScene> scene = read_hqz_scene(*value, limits, warnings);
    if (!scene) {
      for (Diagnostic& one : scene.error()) problems.push_back(std::move(one));
      continue;
    }
    numbers += kOfObject * scene->objects.size() + kOfLight * scene->lights.size();
    if (numbers > limits.max_corners)
      return fail(scene->where,
                  fmt::format("objects and lights come to more than {} numbers up to here",
                              limits.max_corners),
                  "write fewer, or say --max-corners N");
    scenes.push_back(std::move(*scene));
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  const bool many = scenes.size() > 1;
  Result<SceneDesc> desc = describe_hqz(std::move(scenes), warnings);
  if (!desc) return desc;
  // Of what all lines have in common the first is told.
  const std::size_t most = many ? 1 : kMostProblems;
  std::map<std::string, Diagnostics> alike;
  for (Diagnostic& one : warnings) alike[one.message].push_back(std::move(one));
  for (auto& [message, all] : alike) {
    std::ranges::stable_sort(all, {}, [](const Diagnostic& one) { return one.where.offset; });
    const std::size_t told = std::min(all.size(), most);
    std::move(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(told),
              std::back_inserter(desc->warnings));
    if (all.size() > told && !many)
      desc->warnings.push_back(
          {all[told].where, fmt::format("{} more like this: {}", all.size() - told, message), {}});
  }
  return desc;
}

// An object whose first name is in quotes.
bool recognises(std::string_view text) {
  text = trimmed(text);
  if (!text.starts_with('{')) return false;
  text = trimmed(text.substr(1));
  if (!text.starts_with('"')) return false;
  const std::size_t quote = text.find('"', 1);
  return quote != std::string_view::npos && trimmed(text.substr(quote + 1)).starts_with(':');
}

constexpr std::string_view kExtensions[] = {"json"};

}  // namespace

extern const Format entry = {
    "hqz",       "a scene of High Quality Zen in JSON, or one in each line",
    kExtensions, &recognises,
    &read,       nullptr};

}  // namespace flatray::hqz_format
