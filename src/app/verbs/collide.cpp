#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/answers/paper_table.h"
#include "app/files/scene_input.h"
#include "app/frames/frames.h"
#include "app/verb.h"
#include "collide/edge_ray_meetings.h"
#include "collide/scene_timeline.h"
#include "collide/simulate.h"
#include "scene/names.h"
#include "scene/responses.h"

namespace flatray::collide_verb {
namespace {

enum class Method : std::uint8_t { minkowski, edge_rays, boxes };
constexpr Word<Method> kMethods[] = {
    {"minkowski", Method::minkowski}, {"edge-rays", Method::edge_rays}, {"boxes", Method::boxes}};

struct Options : Arguments {
  SceneOptions scene;
  std::optional<unsigned> last;
  std::optional<std::vector<unsigned>> frames;
  Method method = Method::minkowski;
  std::optional<Response> response;
  std::vector<std::string> fixed;
  bool table = false;

  void rows(OptionTable& row) {
    row("--last K", "frame at which to stop, instead of the scene's last", last, 1, kLastFrame);
    row("-f, --frames LIST", "only what happens while one of these frames is shown", frames,
        &parse_frames);
    row("--method", "exact, as the paper's rays in each frame, or of bounding boxes", method,
        kMethods);
    row("--response", "what those do that meet, instead of what the scene says", response,
        kResponses);
    row.each("--fixed NAME", "with --response: an entity that nothing moves; may be said again",
             fixed, &as_text);
    row("--table", "the paper's tables 4 and 5 beside what they should say", table);
    scene.row_of_seed(row);
    row_of_threads(row, scene.limits.threads);
    row(kJsonRow);
    row(kCsvRow);
    scene.rows(row);
    if (table)
      return row.excludes("table", {"last", "frames", "method", "response", "fixed", "csv"});
    row.excludes("frames", {"last"});
    // Methods look for meetings of what goes on undisturbed.
    if (row.has("method") && response && response != Response::none)
      row.problem("method", "does not go with --response", "say flatray help collide");
    if (row.has("fixed") && !row.has("response"))
      row.problem("fixed", "needs --response", "say flatray help collide");
  }
};

// The frames asked for; none: all there are.
struct Asked {
  std::vector<unsigned> frames;
  unsigned last = 1;  // up to which motion is followed

  // Whether a time from low to high, in frames from 1, is partly in one of them: a frame is shown
  // until the next.
  bool shows(double low, double high) const {
    if (frames.empty()) return true;
    const auto first = std::ranges::lower_bound(frames, std::floor(low));
    return first != frames.end() && *first <= high;
  }
};

Asked frames_asked(const Options& options, const Scene& scene) {
  if (!options.frames) return {{}, options.last.value_or(scene.frames)};
  const unsigned last = options.frames->back();
  const bool shows_next = last != scene.frames && last < kLastFrame;
  return {*options.frames, shows_next ? last + 1 : last};
}

// Without the sign of a zero, which rounding leaves.
double plain(double x) { return x + 0.0; }

// What a method does not know is null.
enum class Knows : std::uint8_t { all, times };

Table meeting_table(const Scene& scene, const std::vector<Meeting>& meetings, const Asked& asked,
                    Knows knows = Knows::all) {
  Table table({"a", "b", "class", "t_first", "t_last", "frame", "start", "x", "y", "normal_x",
               "normal_y", "motion", "width"});
  for (const Meeting& meeting : meetings) {
    const auto& [times, kind, start, point, normal, width, certain] = meeting.part;
    const double frame = frame_at(scene, times.low);
    if (!asked.shows(frame, frame_at(scene, times.high))) continue;
    const bool turning = width > 0;  // those too close to tell are called boundary
    const char* from = times.low > 0                              ? "apart"
                       : turning && start == StartPlace::boundary ? "undecided"
                                                                  : contact_name(start);
    const auto known = [knows](JsonValue value) {
      return knows == Knows::all ? std::move(value) : JsonValue();
    };
    table.add({entity_name(scene, meeting.a), entity_name(scene, meeting.b),
               known(certain ? name(kind) : "undecided"), times.low, times.high, frame, known(from),
               known(plain(point.x())), known(plain(point.y())), known(plain(normal.x())),
               known(plain(normal.y())),
               meeting.straight      ? "straight"
               : knows == Knows::all ? "changing"
                                     : "by frames",
               known(width)});
  }
  return table;
}

// The names of at most three of many, and how many more there are.
template <class Many, class NameOf>
std::pair<std::string, std::size_t> first_few(const Many& many, const NameOf& name_of) {
  constexpr std::size_t kMost = 3;
  const std::size_t few = std::min(many.size(), kMost);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < few; ++i) names.push_back(name_of(many[i]));
  return {comma_list(names), many.size() - few};
}

// What the answer is not about, so that nobody takes silence for a miss; "" for nothing.
std::string left_out(const Scene& scene) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (is_left_out(scene, i)) all.push_back(i);
  if (all.empty()) return {};
  const auto [few, more] = first_few(all, [&](std::uint32_t i) { return entity_name(scene, i); });
  return fmt::format(
      "left out are outlines that cross themselves and curves but circles, capsules and ellipses: "
      "{}{}",
      few, more == 0 ? "" : fmt::format(" and {} more", more));
}

Table event_table(const Scene& scene, const Simulation& done, const Asked& asked) {
  Table table({"a", "b", "t", "frame", "x", "y", "normal_x", "normal_y", "a_velocity_x",
               "a_velocity_y", "b_velocity_x", "b_velocity_y"});
  for (const CollisionEvent& e : done.events) {
    const double frame = frame_at(scene, e.time);
    if (!asked.shows(frame, frame)) continue;
    table.add({entity_name(scene, e.a), entity_name(scene, e.b), e.time, frame, plain(e.point.x()),
               plain(e.point.y()), plain(e.normal.x()), plain(e.normal.y()),
               plain(e.velocity_a.x()), plain(e.velocity_a.y()), plain(e.velocity_b.x()),
               plain(e.velocity_b.y())});
  }
  return table;
}

// "a and b", more separated by commas.
std::string named_pairs(const Scene& scene,
                        std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
  const auto [few, more] = first_few(pairs, [&](const auto& pair) {
    return fmt::format("{} and {}", entity_name(scene, pair.first),
                       entity_name(scene, pair.second));
  });
  return few + (more == 0 ? "" : fmt::format(" ({} more)", more));
}

Result<VerbOutput> events(const Options& options, const Timeline& timeline, const Asked& asked) {
  const std::vector<std::string> known = names_of(timeline.scene().entities);
  for (const std::string& entity : options.fixed)
    if (std::ranges::find(known, entity) == known.end())
      return unknown_name(options.where("fixed"), "entity", entity, known);
  FLATRAY_TRY(bodies, bodies_of(timeline, options.response, options.fixed));
  const double end = (asked.last - 1) / timeline.scene().fps;
  const Simulation done = simulate(*bodies, end, most_events(timeline.scene()));
  const Place where =
      options.response ? options.where("response") : where_responds(timeline.scene());
  if (!done.overlaps.empty())
    report_warnings({{timeline.scene().entities[done.overlaps.front().first].where,
                      fmt::format("in each other at the start, so that they respond only where "
                                  "they come nearer: {}",
                                  named_pairs(timeline.scene(), done.overlaps)),
                      "move them apart"}},
                    options);
  VerbOutput answer{.table = event_table(timeline.scene(), done, asked)};
  if (auto complete = check_complete(timeline.scene(), done, end, where); !complete)
    answer.problems = std::move(complete.error());
  return answer;
}

Result<VerbOutput> meetings(const Options& options, const Timeline& timeline, const Asked& asked) {
  const Scene& scene = timeline.scene();
  if (options.method == Method::edge_rays) {
    report_warnings(
        {{options.where("method"),
          "edge-rays knows polygons only, and neither how nor where they meet", "leave it out"}},
        options);
    FLATRAY_TRY(met, find_edge_ray_meetings(timeline, asked.last));
    return VerbOutput{.table = meeting_table(scene, *met, asked, Knows::times)};
  }
  const Outline outline = options.method == Method::boxes ? Outline::box : Outline::own;
  if (auto refused = refused_meetings(scene, outline)) return tl::unexpected(*std::move(refused));
  if (std::string note = left_out(scene); outline == Outline::own && !note.empty())
    report_warnings({{named_place(options.operands()[0]), std::move(note), ""}}, options);
  FLATRAY_TRY(met, find_meetings(timeline, asked.last, outline, options.scene.limits.threads));
  return VerbOutput{.table = meeting_table(scene, *met, asked)};
}

// Methods look for meetings of what goes on undisturbed.
Result<void> check_method(const Options& options, const Scene& scene) {
  if (!options.has("method") || options.response || !responds(scene)) return {};
  return usage_error(where_responds(scene),
                     "entities respond to contact, and --method looks at what goes on undisturbed",
                     "say --response none with it, or leave --method out");
}

Result<VerbOutput> run(const Options& options) {
  FLATRAY_TRY(scene, load_only_input(options, options.scene));
  if (options.table) return paper_tables(*scene, options.where("table"));
  if (auto checked = check_method(options, *scene); !checked) return fail(std::move(checked));
  const Asked asked = frames_asked(options, *scene);
  const Timeline timeline(*scene, options.scene.seed_of(*scene), asked.last);
  const bool respond = options.response ? *options.response != Response::none : responds(*scene);
  return respond ? events(options, timeline, asked) : meetings(options, timeline, asked);
}

}  // namespace

extern const Verb entry = {
    "collide",
    "SCENE",
    "say when the entities of a scene meet, and where",
    kCommand<Options, &run>,
    "  flatray collide scenes/paper/case_two.toml\n"
    "  flatray collide scenes/paper/case_two.toml --table\n"
    "  flatray collide scenes/collision/cradle.toml\n"
    "  flatray collide scenes/collision/cradle.toml --response stop --fixed wall\n"
    "  flatray collide scenes/tutorial/11_journey.toml -f 30..60 --csv\n",
    "nothing looked for"};

}  // namespace flatray::collide_verb
