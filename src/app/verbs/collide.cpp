#include <fmt/core.h>

#include "app/option_values.h"
#include "app/report.h"
#include "app/scene_input.h"
#include "app/verb.h"
#include "collide/meetings.h"

namespace flatray::verbs {
namespace {

constexpr auto kOptions =
    with_scene_options({{"last", '\0', "K", "frame at which to stop (default: the scene's last)"},
                        kSeedOption,
                        kJsonOption,
                        kCsvOption});

Table meeting_table(const Scene& scene, const std::vector<Meeting>& meetings) {
  Table table{{"a", "b", "class", "t_first", "t_last", "frame", "start", "x", "y", "normal_x",
               "normal_y", "motion"},
              {}};
  for (const Meeting& meeting : meetings) {
    const auto& [times, kind, start, point, normal] = meeting.part;
    table.rows.push_back({scene.entities[meeting.a].name, scene.entities[meeting.b].name,
                          name(kind), times.low, times.high, 1 + times.low * scene.fps,
                          times.low > 0 ? "apart" : contact_name(start), point.x(), point.y(),
                          normal.x(), normal.y(), meeting.straight ? "straight" : "by frames"});
  }
  return table;
}

// What the answer is not about, so that nobody takes silence for a miss; "" for nothing.
std::string left_out(const Scene& scene) {
  constexpr std::size_t kMostNames = 3;
  std::vector<std::string> names;
  std::size_t more = 0;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i) {
    if (!has_parts_left_out(scene.shapes[scene.entities[i].shape])) continue;
    if (names.size() == kMostNames)
      ++more;
    else
      names.push_back(scene.entities[i].name.empty() ? fmt::format("entity {}", i + 1)
                                                     : scene.entities[i].name);
  }
  if (names.empty()) return {};
  return fmt::format("circles and curves are left out: {}{}", comma_list(names),
                     more == 0 ? "" : fmt::format(" and {} more", more));
}

Result<VerbOutput> run(const Arguments& arguments) {
  const auto scene = load_only_input(arguments);
  if (!scene) return tl::unexpected(scene.error());
  const auto draws = seed(arguments, *scene);
  if (!draws) return tl::unexpected(draws.error());
  const auto last = arguments.whole("last", scene->frames, 1, scene->frames);
  if (!last) return tl::unexpected(last.error());
  const auto frames = static_cast<unsigned>(*last);
  const Table table =
      meeting_table(*scene, find_meetings(Timeline(*scene, *draws, frames), frames));
  if (const std::string note = left_out(*scene); !note.empty() && !arguments.has("quiet"))
    report_note(note);
  if (arguments.has("json"))
    return VerbOutput{json_report("collide", arguments, as_objects(table), 0)};
  return VerbOutput{arguments.has("csv") ? csv_text(table) : aligned_text(table)};
}

}  // namespace

extern const Verb collide = {"collide",
                             "SCENE",
                             "say when the entities of a scene meet, and where",
                             1,
                             1,
                             kOptions,
                             "  flatray collide scenes/paper/case_two.toml\n"
                             "  flatray collide scenes/demo.toml --last 60 --csv\n",
                             "nothing looked for",
                             &run};

}  // namespace flatray::verbs
