#include "app/golden/golden.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "app/options/backend_choice.h"
#include "app/options/option_values.h"
#include "base/file.h"
#include "base/json.h"
#include "collide/scene_timeline.h"
#include "scene/load.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "golden_images/manifest.json";
constexpr const char* kSchema = "flatray.goldens/1";
constexpr const char* kBackend = "software";
constexpr const char* kGlBackend = "gl";

JsonValue as_value(const GoldenRow& row) {
  Fields fields{{"file", row.file()},
                {"scene", row.scene},
                {"frame", row.frame},
                {"seed", row.seed},
                {"size", Values{row.width, row.height}},
                {"backend", row.backend}};
  if (!row.exact()) fields.emplace_back("renderer", row.renderer);
  fields.insert(fields.end(), {{"tolerance", row.tolerance.text()},
                               {"drift", row.drift},
                               {"pixels", row.pixels},
                               {"scene_hash", row.scene_hash},
                               {"why", row.why}});
  return fields;
}

// Takes the fields of one row, and what is wrong with each.
class RowReader {
 public:
  RowReader(const JsonValue& value, const std::string& name, Diagnostics& problems)
      : value_(value), name_(name), problems_(problems) {}

  GoldenRow read() {
    GoldenRow row;
    row.scene = text("scene");
    if (!is_scene_path(row.scene)) wrong("scene", "is not a path below scenes/");
    row.frame = static_cast<unsigned>(whole("frame", 1, 9'999'999));
    row.seed = whole("seed", 0, ~std::uint64_t{0});
    read_size(row);
    row.drift = text("drift"), row.pixels = text("pixels");
    row.scene_hash = text("scene_hash"), row.why = text("why");
    read_backend(row);
    expect("file", row.file());
    return row;
  }

 private:
  static bool is_scene_path(const std::string& text) {
    const fs::path path(text);
    return text.starts_with("scenes/") && path.lexically_normal() == path && path.has_stem();
  }

  void wrong(const char* key, const std::string& what) {
    problems_.push_back({named_place(kManifest), fmt::format("'{}' of {} {}", key, name_, what),
                         "flatray golden update writes the manifest; edit it by hand only to "
                         "remove rows"});
  }

  std::string text(const char* key) {
    std::string text = value_.text_of(key);
    if (text.empty()) wrong(key, "is missing");
    return text;
  }

  std::uint64_t whole(const char* key, std::uint64_t low, std::uint64_t high) {
    const JsonValue* field = value_.find(key);
    return in_range(field == nullptr ? JsonValue() : *field, key, low, high);
  }

  std::uint64_t in_range(const JsonValue& value, const char* key, std::uint64_t low,
                         std::uint64_t high) {
    const auto number = value.as_whole();
    if (number && *number >= low && *number <= high) return *number;
    wrong(key, fmt::format("is not a number from {} to {}", low, high));
    return low;
  }

  void read_size(GoldenRow& row) {
    const JsonValue* field = value_.find("size");
    const auto* sides = field == nullptr ? nullptr : std::get_if<Values>(&field->data);
    if (sides == nullptr || sides->size() != 2) return wrong("size", "is not [width, height]");
    row.width = static_cast<int>(in_range((*sides)[0], "size", 1, kGoldenWidth));
    row.height = static_cast<int>(in_range((*sides)[1], "size", 1, kGoldenHeight));
  }

  void read_backend(GoldenRow& row) {
    row.backend = text("backend");
    if (row.backend != kBackend && row.backend != kGlBackend)
      wrong("backend",
            fmt::format("is '{}', expected {} or {}", row.backend, kBackend, kGlBackend));
    const std::string tolerance = text("tolerance");
    const std::optional<Tolerance> read = Tolerance::parse(tolerance);
    if (!read)
      wrong("tolerance", fmt::format("is '{}', expected '{}'", tolerance, Tolerance().text()));
    if (!read) return;
    row.tolerance = *read;
    if (row.exact()) return expect("tolerance", Tolerance().text());
    row.renderer = text("renderer");
  }

  void expect(const char* key, const std::string& expected) {
    if (const std::string given = text(key); !given.empty() && given != expected)
      wrong(key, fmt::format("is '{}', expected '{}'", given, expected));
  }

  const JsonValue& value_;
  const std::string& name_;
  Diagnostics& problems_;
};

tl::unexpected<Diagnostics> bad_manifest(const std::string& what) {
  return fail(named_place(kManifest), what, fmt::format("expected {}", kSchema));
}

std::string without_extension(const fs::path& path) {
  return (path.parent_path() / path.stem()).generic_string();
}

// Files below `folder` as paths below `root`, sorted; none where there is no folder.
Result<std::vector<std::string>> names_below(const fs::path& root, const std::string& folder) {
  FLATRAY_TRY(below, files_below(root / folder));
  std::vector<std::string> files;
  std::error_code ignored;
  for (const fs::path& path : *below)
    if (fs::is_regular_file(path, ignored))
      files.push_back(path.lexically_relative(root).generic_string());
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::string Tolerance::text() const { return fmt::format("max={};pixels={}", levels, pixels); }

std::optional<Tolerance> Tolerance::parse(std::string_view text) {
  constexpr std::string_view kLevels = "max=", kPixels = ";pixels=";
  const std::size_t second = text.find(kPixels);
  if (!text.starts_with(kLevels) || second == text.npos) return std::nullopt;
  const auto levels = parse_whole(text.substr(kLevels.size(), second - kLevels.size()));
  const auto pixels = parse_whole(text.substr(second + kPixels.size()));
  if (!levels || !pixels || *levels > 255) return std::nullopt;
  return Tolerance{static_cast<int>(*levels), *pixels};
}

std::string GoldenRow::name() const {
  return without_extension(fs::path(scene).lexically_relative("scenes"));
}

std::string GoldenRow::folder() const {
  std::string folder = name();
  std::replace(folder.begin(), folder.end(), '/', '_');
  return folder;
}

std::string GoldenRow::file() const {
  return fmt::format("golden_images/{}/{}frame_{:04}.png", folder(), exact() ? "" : "gl_", frame);
}

std::string GoldenRow::look() const {
  return fmt::format("out/golden/{}/{}frame_{:04}", folder(), exact() ? "" : "gl_", frame);
}

Result<std::vector<GoldenRow>> read_goldens(const fs::path& root) {
  Result<std::string> text = read_file(root / kManifest);
  if (!text) {
    Diagnostic& missing = text.error().front();
    if (missing.hint.empty())
      missing.hint =
          "name the folder that has goldens by --root; flatray golden update writes them";
    return tl::unexpected(text.error());
  }
  const std::optional<JsonValue> json = parse_json(*text);
  if (!json) return bad_manifest("is not JSON");
  const JsonValue* list = json->find("goldens");
  const auto* values = list == nullptr ? nullptr : std::get_if<Values>(&list->data);
  if (json->text_of("schema") != kSchema || values == nullptr)
    return bad_manifest("is not a manifest of goldens");
  std::vector<GoldenRow> rows;
  Diagnostics problems;
  for (const JsonValue& value : *values)
    rows.push_back(RowReader(value, fmt::format("row {}", rows.size() + 1), problems).read());
  std::ranges::sort(rows, {}, &GoldenRow::file);
  if (const auto twice = std::ranges::adjacent_find(rows, {}, &GoldenRow::file);
      twice != rows.end() && problems.empty())
    return bad_manifest(fmt::format("has two rows of {}", twice->file()));
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return rows;
}

Result<void> write_goldens(const fs::path& root, std::vector<GoldenRow> rows,
                           const Outputs& outputs) {
  std::ranges::sort(rows, {}, &GoldenRow::file);
  std::string lines;
  for (const GoldenRow& row : rows)
    lines += (lines.empty() ? "" : ",\n") + json_text(as_value(row));
  return outputs.write(
      root / kManifest,
      fmt::format("{{\"schema\": \"{}\", \"goldens\": [\n{}\n]}}\n", kSchema, lines));
}

Result<std::string> find_scene(const fs::path& root, const std::string& name) {
  const std::string wanted = fs::path(name).lexically_normal().generic_string();
  std::vector<std::string> found, known;
  FLATRAY_TRY(files, names_below(root, "scenes"));
  for (const std::string& file : *files) {
    const std::string below = fs::path(file).lexically_relative("scenes").generic_string();
    known.push_back(without_extension(below));
    if (wanted == file || wanted == below) return file;
    if (wanted == known.back()) found.push_back(file);
  }
  if (found.size() == 1) return found.front();
  if (found.size() > 1)
    return fail(named_place(name), fmt::format("may be {} or {}", found[0], found[1]),
                "name the file", Trouble::usage);
  const std::string near = nearest_word(wanted, known);
  return fail(named_place(name), "there is no such scene below scenes/",
              near.empty() ? "" : fmt::format("did you mean '{}'?", near), Trouble::missing);
}

std::string scene_hash(const Scene& scene) { return fmt::format("{:016x}", scene.hash); }

Result<Scene> scene_of_size(Scene scene, const fs::path& root, const GoldenRow& row) {
  if (scene.film.width == row.width && scene.film.height == row.height) return scene;
  const Override size{"film.size", fmt::format("[{}, {}]", row.width, row.height)};
  FLATRAY_TRY(loaded, load_scene(root / row.scene, {size}, {.root = root}));
  loaded->scene.hash = scene.hash;
  return std::move(loaded->scene);
}

Result<GoldenScene> load_golden_scene(const fs::path& root, const GoldenRow& row) {
  FLATRAY_TRY(loaded, load_scene(root / row.scene, {}, {.root = root}));
  std::string options;
  if (const Film& own = loaded->scene.film; own.width != row.width || own.height != row.height)
    options = fmt::format(" --size {}x{}", row.width, row.height);
  FLATRAY_TRY(scene, scene_of_size(std::move(loaded->scene), root, row));
  GoldenScene golden{*std::move(scene), std::move(options)};
  if (golden.scene.seed != row.seed) golden.options += fmt::format(" --seed {}", row.seed);
  if (limit_golden_light(golden.scene))
    golden.options += fmt::format(" -D light.rays={}", golden.scene.light.rays);
  return golden;
}

bool limit_golden_light(Scene& scene) {
  constexpr std::uint64_t kMostRays = std::uint64_t{1} << 15;
  if (scene.lamps.empty() || scene.light.rays <= kMostRays) return false;
  scene.light.rays = kMostRays;
  return true;
}

Result<GoldenPicture> render_golden(const Scene& scene, const GoldenRow& row,
                                    const std::string& backend, unsigned threads) {
  FLATRAY_TRY(renderer, open_backend(backend, {threads, 4}));
  FLATRAY_TRY(timeline, make_timeline(scene, row.seed, row.frame));
  GoldenPicture picture{{}, (*renderer)->description()};
  FLATRAY_TRY(list,
              draw_list(make_plan(scene, false), *timeline, row.frame, {std::nullopt, threads}));
  FLATRAY_TRY(drawn, (*renderer)->draw(*list, {std::nullopt, threads}, picture.image));
  return picture;
}

Result<std::vector<std::string>> stray_goldens(const fs::path& root,
                                               const std::vector<GoldenRow>& rows) {
  std::set<std::string> known;
  for (const GoldenRow& row : rows) known.insert(row.file());
  FLATRAY_TRY(stray, names_below(root, "golden_images"));
  std::erase_if(*stray, [&](const std::string& file) {
    return known.count(file) != 0 || !file.ends_with(".png");
  });
  return stray;
}

}  // namespace flatray
