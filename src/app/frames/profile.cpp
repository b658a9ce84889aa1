#include "app/frames/profile.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/options/backend_choice.h"
#include "app/options/option_values.h"
#include "app/report/report.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/json.h"
#include "base/number_text.h"

namespace flatray {
namespace {

constexpr const char* kProfileSchema = "flatray.profile/1";

std::string hash_of(const Scene& scene) { return Hash().add(scene.hash).hex(); }

// One way to draw, as a line of the file.
struct Way {
  std::string words;
  double error = 0, seconds = 0;
  bool at_most = false;  // as the reference of the error tells no more
  RenderOptions options;
  Place where;
};

struct Profile {
  std::string hash;
  Place head;
  std::vector<Way> ways;
};

// What a profile may say to render; all else would draw another scene.
bool may_choose(const std::string& name, const std::string& value) {
  if (name == "backend") {
    const std::vector<std::string> known = backend_names();
    return std::ranges::find(known, value) != known.end();
  }
  return name == "samples" || (name == "define" && (value.starts_with("film.coverage=") ||
                                                    value.starts_with("film.rows=")));
}

// One value of an option, or several. Older profiles write the name of an option again for each.
std::vector<std::optional<std::string>> texts_of(const JsonValue& value) {
  const auto* several = std::get_if<Values>(&value.data);
  if (several == nullptr) return {value.as_text()};
  std::vector<std::optional<std::string>> texts;
  for (const JsonValue& one : *several) texts.push_back(one.as_text());
  return texts;
}

Fields fields_of(const RenderOptions& options) {
  Fields fields;
  for (const auto& [name, value] : options) {
    const auto there = std::ranges::find(fields, name, &Fields::value_type::first);
    if (there == fields.end())
      fields.emplace_back(name, value);
    else if (auto* several = std::get_if<Values>(&there->second.data))
      several->emplace_back(value);
    else
      there->second = Values{there->second, value};
  }
  return fields;
}

// nullopt where it is none.
std::optional<Way> way_of(const JsonValue& line, const Place& where) {
  Way way{line.text_of("setting"), 0, 0, false, {}, where};
  const auto error = line.number_of("error"), seconds = line.number_of("seconds");
  const JsonValue* options = line.find("options");
  const auto* fields = options == nullptr ? nullptr : std::get_if<Fields>(&options->data);
  if (way.words.empty() || !error || !seconds || fields == nullptr) return std::nullopt;
  if (const JsonValue* at_most = line.find("at_most")) {
    const bool* told = std::get_if<bool>(&at_most->data);
    if (told == nullptr) return std::nullopt;
    way.at_most = *told;
  }
  way.error = *error;
  way.seconds = *seconds;
  for (const auto& [name, value] : *fields) {
    const auto texts = texts_of(value);
    if (texts.empty() || (texts.size() > 1 && name != "define")) return std::nullopt;
    for (const auto& text : texts) {
      if (!text || !may_choose(name, *text)) return std::nullopt;
      way.options.emplace_back(name, *text);
    }
  }
  return way;
}

Result<Profile> read_profile(const std::string& path) {
  FLATRAY_TRY(text, read_file(path));
  const auto source = std::make_shared<const SourceText>(path, std::move(*text));
  Profile profile;
  Diagnostics problems;
  const std::string_view all = source->text();
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    const Place place{source, begin, end - begin};
    const auto line = parse_json(all.substr(begin, end - begin));
    std::optional<Way> way;
    if (begin == 0) {
      profile.head = place;
      if (!line || line->text_of("schema") != kProfileSchema)
        return fail(place, "is not a profile", "flatray accuracy SCENE --profile FILE writes one");
      profile.hash = line->text_of("scene_hash");
    } else if (line && line->text_of("choice") == "light") {
      // Older profiles have them, but errors of light are no errors of coverage.
    } else if (line && (way = way_of(*line, place))) {
      profile.ways.push_back(std::move(*way));
    } else {
      problems.push_back({place, "is not a setting of a profile",
                          "write the profile anew: flatray accuracy SCENE --profile FILE"});
    }
    begin = end + 1;
  }
  if (profile.ways.empty() && problems.empty())
    problems.push_back({profile.head ? profile.head : named_place(path), "has no setting",
                        "measure more: flatray accuracy SCENE --choice coverage --profile FILE"});
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return profile;
}

template <std::optional<double> (*parse)(std::string_view)>
Result<double> at_least_0(const std::string& text, const Place& where) {
  const auto number = parse(text);
  if (number && *number >= 0) return *number;
  return usage_error(where, "is not a number of 0 or more", "say 0.001");
}

// The cheapest that is near enough; without an error asked for, the nearest that is cheap enough.
Result<Way> choose(const Profile& profile, double error, double seconds) {
  const bool cheapest = error < kInfinity;
  const Way *best = nullptr, *nearest = nullptr, *quickest = nullptr;
  for (const Way& way : profile.ways) {
    if (way.seconds <= seconds && (nearest == nullptr || way.error < nearest->error))
      nearest = &way;
    if (quickest == nullptr || way.seconds < quickest->seconds) quickest = &way;
    if (way.error > error || way.seconds > seconds) continue;
    if (best == nullptr || (cheapest ? way.seconds < best->seconds : way.error < best->error))
      best = &way;
  }
  if (best != nullptr) return *best;
  if (nearest == nullptr)
    return fail(quickest->where,
                fmt::format("no setting takes {} s or less: this is the quickest", seconds),
                fmt::format("say --time {:.2g}", 1.1 * quickest->seconds));
  if (nearest->at_most && nearest->seconds <= seconds)
    return fail(
        nearest->where,
        fmt::format("no setting is known to have an error of {} or less: of the nearest one "
                    "the reference tells only that it is at most {:.3g}",
                    error, nearest->error),
        fmt::format("measure longer, flatray accuracy SCENE --budget 60s --profile FILE, or "
                    "say --error {:.2g}",
                    1.1 * nearest->error));
  return fail(
      nearest->where,
      fmt::format("no setting has an error of {} or less{}: this is the nearest", error,
                  seconds < kInfinity ? fmt::format(" within {} s", seconds) : std::string()),
      fmt::format("say --error {:.2g}", 1.1 * nearest->error));
}

}  // namespace

std::string profile_text(const Scene& scene, std::span<const ChoiceReport> reports) {
  std::string text =
      json_text(Fields{
          {"schema", kProfileSchema}, {"scene", scene.name}, {"scene_hash", hash_of(scene)}}) +
      "\n";
  for (const ChoiceReport& report : reports)
    for (const AccuracyPoint& point : report.points) {
      if (!point.options) continue;
      Fields way{{"choice", report.name},
                 {"setting", point.setting},
                 {"error", point.outcome.error},
                 {"seconds", point.seconds},
                 {"options", fields_of(*point.options)}};
      if (point.outcome.at_most) way.emplace_back("at_most", true);
      text += json_text(std::move(way)) + "\n";
    }
  return text;
}

void ProfileOptions::rows(OptionTable& row, LightWish& light) {
  row("--profile FILE.json", "written by flatray accuracy: choose by it how to draw", file);
  row("--error E",
      "light: rays until its relative error is E; with --profile: the cheapest way to draw so");
  row("--time S",
      "light: rays for S seconds a frame; with --profile: the nearest way to draw that takes S");
  if (!row.has("profile")) return light.read_ends(row);
  row.read("error", error, &at_least_0<&parse_number>);
  row.read("time", seconds, &at_least_0<&parse_seconds>);
  if (!row.has("error") && !row.has("time"))
    row.problem("profile", "needs --error or --time", "say --error 0.001, or --time 0.1");
  if (!row.operand(1).empty())
    row.problem("profile", "goes with one scene only", "render the scenes one by one");
  row.excludes("profile", {"backend", "samples", "view", "size", "seed"});
}

Result<void> choose_by_profile(Arguments& arguments, const ProfileOptions& options,
                               const SceneOptions& scene) {
  if (options.file.empty()) return {};
  FLATRAY_TRY(profile, read_profile(options.file));
  FLATRAY_TRY(loaded, load_input(scene, arguments.operands()[0]));
  if (hash_of(loaded->scene) != profile->hash)
    return fail(profile->head, "is of another scene, of another state of it, or of another size",
                "measure it as it is to be drawn: flatray accuracy SCENE --profile FILE");
  FLATRAY_TRY(way, choose(*profile, options.error.value_or(kInfinity),
                          options.seconds.value_or(kInfinity)));
  if (!arguments.has("quiet"))
    report_note(fmt::format("profile: {}, error {}{:.3g}, {:.3g} s a frame{}", way->words,
                            way->at_most ? "at most " : "", way->error, way->seconds,
                            loaded->scene.lamps.empty() ? "" : ", both without light"));
  for (const auto& [name, value] : way->options) arguments.add_nearer(name, {"--profile", {value}});
  return {};
}

}  // namespace flatray
