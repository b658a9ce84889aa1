#include "app/frames/profile.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/files/scene_input.h"
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
    return std::find(known.begin(), known.end(), value) != known.end();
  }
  return name == "samples" || (name == "define" && (value.starts_with("film.coverage=") ||
                                                    value.starts_with("film.rows=")));
}

// nullopt where it is none.
std::optional<Way> way_of(const JsonValue& line, const Place& where) {
  Way way{line.text_of("setting"), 0, 0, line.find("at_most") != nullptr, {}, where};
  const auto error = line.number_of("error"), seconds = line.number_of("seconds");
  const JsonValue* options = line.find("options");
  const auto* fields = options == nullptr ? nullptr : std::get_if<Fields>(&options->data);
  if (way.words.empty() || !error || !seconds || fields == nullptr) return std::nullopt;
  way.error = *error;
  way.seconds = *seconds;
  for (const auto& [name, value] : *fields) {
    const auto text = value.as_text();
    if (!text || !may_choose(name, *text)) return std::nullopt;
    way.options.emplace_back(name, *text);
  }
  return way;
}

Result<Profile> read_profile(const std::string& path) {
  auto text = read_file(path);
  if (!text) return fail(std::move(text));
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

// A number of 0 or more given to an option; infinity where none is.
Result<double> limit(const Arguments& arguments, const char* option) {
  const auto text = arguments.text(option);
  if (!text) return kInfinity;
  const bool of_time = std::string_view(option) == "time";
  const auto number = of_time ? parse_seconds(*text) : parse_number(*text);
  if (!number || !(*number >= 0))
    return usage_error(arguments.where(option), "is not a number of 0 or more", "say 0.001");
  return *number;
}

struct Wish {
  double error, seconds;
};

Result<Wish> read_wish(const Arguments& arguments) {
  if (!arguments.has("error") && !arguments.has("time"))
    return usage_error(arguments.where("profile"), "needs --error or --time",
                       "say --error 0.001, or --time 0.1");
  if (arguments.operands().size() != 1)
    return usage_error(arguments.where("profile"), "goes with one scene only",
                       "render the scenes one by one");
  for (const char* other : {"backend", "samples", "view", "size", "seed"})
    if (arguments.has(other))
      return usage_error(arguments.where(other), "does not go with --profile",
                         "leave one of them out");
  const auto error = limit(arguments, "error"), seconds = limit(arguments, "time");
  if (!error) return tl::unexpected(error.error());
  if (!seconds) return tl::unexpected(seconds.error());
  return Wish{*error, *seconds};
}

// The cheapest that is near enough; without an error asked for, the nearest that is cheap enough.
Result<Way> choose(const Profile& profile, const Wish& wish) {
  const bool cheapest = wish.error < kInfinity;
  const Way *best = nullptr, *nearest = nullptr, *quickest = nullptr;
  for (const Way& way : profile.ways) {
    if (way.seconds <= wish.seconds && (nearest == nullptr || way.error < nearest->error))
      nearest = &way;
    if (quickest == nullptr || way.seconds < quickest->seconds) quickest = &way;
    if (way.error > wish.error || way.seconds > wish.seconds) continue;
    if (best == nullptr || (cheapest ? way.seconds < best->seconds : way.error < best->error))
      best = &way;
  }
  if (best != nullptr) return *best;
  if (nearest == nullptr)
    return fail(quickest->where,
                fmt::format("no setting takes {} s or less: this is the quickest", wish.seconds),
                fmt::format("say --time {:.2g}", 1.1 * quickest->seconds));
  if (nearest->at_most && nearest->seconds <= wish.seconds)
    return fail(
        nearest->where,
        fmt::format("no setting is known to have an error of {} or less: of the nearest one "
                    "the reference tells only that it is at most {:.3g}",
                    wish.error, nearest->error),
        fmt::format("measure longer, flatray accuracy SCENE --budget 60s --profile FILE, or "
                    "say --error {:.2g}",
                    1.1 * nearest->error));
  return fail(
      nearest->where,
      fmt::format(
          "no setting has an error of {} or less{}: this is the nearest", wish.error,
          wish.seconds < kInfinity ? fmt::format(" within {} s", wish.seconds) : std::string()),
      fmt::format("say --error {:.2g}", 1.1 * nearest->error));
}

Arguments with_options(const Arguments& arguments, const Way& way) {
  auto given = arguments.given();
  for (const auto& [name, value] : way.options) {
    Arguments::Given& one = given[name];
    if (one.origin.empty()) one.origin = "--profile";
    one.values.push_back(value);
  }
  return {std::move(given), arguments.operands()};
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
      Fields options;
      for (const auto& [name, value] : *point.options) options.emplace_back(name, value);
      Fields way{{"choice", report.name},
                 {"setting", point.setting},
                 {"error", point.outcome.error},
                 {"seconds", point.seconds},
                 {"options", std::move(options)}};
      if (point.outcome.at_most) way.emplace_back("at_most", true);
      text += json_text(std::move(way)) + "\n";
    }
  return text;
}

Result<Arguments> with_profile(const Arguments& arguments) {
  const auto path = arguments.text("profile");
  if (!path) return arguments;
  const auto wish = read_wish(arguments);
  if (!wish) return tl::unexpected(wish.error());
  const auto profile = read_profile(*path);
  if (!profile) return tl::unexpected(profile.error());
  const auto scene = load_input(arguments, arguments.operands()[0]);
  if (!scene) return tl::unexpected(scene.error());
  if (hash_of(scene->scene) != profile->hash)
    return fail(profile->head, "is of another scene, of another state of it, or of another size",
                "measure it as it is to be drawn: flatray accuracy SCENE --profile FILE");
  const auto way = choose(*profile, *wish);
  if (!way) return tl::unexpected(way.error());
  if (!arguments.has("quiet"))
    report_note(fmt::format("profile: {}, error {}{:.3g}, {:.3g} s a frame", way->words,
                            way->at_most ? "at most " : "", way->error, way->seconds));
  return with_options(arguments, *way);
}

}  // namespace flatray
