
#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "anim/rays.h"
#include "app/answers/hit_report.h"
#include "app/files/scene_input.h"
#include "app/options/option_values.h"
#include "app/verb.h"
#include "scene/names.h"

namespace flatray::hit_verb {
namespace {

constexpr Word<const Range*> kDomains[] = {
    {"line", &kLine}, {"ray", &kRay}, {"segment", &kSegment}};

struct Options : Arguments {
  SceneOptions scene;
  std::optional<Ray> ray;
  std::string from, against;
  const Range* domain = nullptr;
  std::optional<HitOperation> operation;
  unsigned frame = 1;

  Range within(const Range& usual) const { return domain ? *domain : usual; }
  void rows(OptionTable& row) {
    row("-r, --ray x,y,dx,dy", "this ray, against every entity", ray, &parse_ray);
    row("--from ENTITY", "the edges of this entity as rays", from);
    row("--against ENTITY", "against this entity only", against);
    row("--domain", "part of the line that counts (edges: segment)", domain, kDomains);
    row("--op",
        "instead of each hit the parts of a ray inside any entity, all of them, or that of "
        "--against and no other; their length in world units",
        operation, kHitOperations);
    row_of_frame(row, frame);
    scene.row_of_seed(row);
    row("--svg", "print a diagram, what lies inside thick");
    row(kJsonRow);
    row(kCsvRow);
    scene.rows(row);
    row.excludes("ray", {"from"});
    row.excludes("op", {"svg"});
    if (operation == &difference_of && against.empty())
      row.problem("op", "needs an entity to take the others from", "add --against ENTITY");
  }
};

// Rays and what they are clipped against.
struct Question {
  std::vector<NamedRay> rays;
  std::vector<std::uint32_t> against;
  Range within = kRay;
  std::optional<std::uint32_t> from{};  // whose edges the rays are
};

Result<std::uint32_t> find_entity(const Options& options, const char* option, const Scene& scene) {
  const std::string wanted = *options.text(option);
  const std::vector<std::string> known = names_of(scene.entities);
  const auto found = std::ranges::find(known, wanted);
  if (found != known.end()) return static_cast<std::uint32_t>(found - known.begin());
  return unknown_name(options.where(option), "entity of the scene", wanted, known);
}

// Against all entities, or the one of --against; never the one the rays come from.
Result<Question> ask(const Options& options, const Scene& scene, std::vector<NamedRay> rays,
                     std::optional<std::uint32_t> from = std::nullopt) {
  Question question{std::move(rays), {}, options.within(from ? kSegment : kRay), from};
  if (options.has("against"))
    return find_entity(options, "against", scene).map([&](std::uint32_t entity) {
      question.against = {entity};
      return std::move(question);
    });
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (from != i) question.against.push_back(i);
  return question;
}

// What the scene itself asks: its edge rays and its rays.
Result<std::vector<Question>> scene_questions(const Options& options, const Scene& scene,
                                              const FrameState& state) {
  std::vector<Question> questions;
  for (const EdgeRays& pair : scene.edge_rays)
    questions.push_back(
        {edge_rays(scene, state, pair.from), {pair.against}, options.within(kSegment)});
  std::vector<NamedRay> rays;
  for (const RayState& ray : ray_states(scene, state))
    rays.push_back({ray_name(scene, ray.ray), ray.start});
  if (rays.empty()) return questions;
  return ask(options, scene, std::move(rays)).map([&](Question question) {
    questions.push_back(std::move(question));
    return std::move(questions);
  });
}

Result<std::vector<Question>> read_questions(const Options& options, const Scene& scene,
                                             const FrameState& state) {
  const auto alone = [](Question question) { return std::vector{std::move(question)}; };
  if (options.ray) return ask(options, scene, {{"ray", *options.ray}}).map(alone);
  if (!options.has("from")) return scene_questions(options, scene, state);
  return find_entity(options, "from", scene).and_then([&](std::uint32_t from) {
    return ask(options, scene, edge_rays(scene, state, from), from).map(alone);
  });
}

// The entities of a question: those it is against, and of --op difference all others then.
std::vector<std::uint32_t> operands_of(const std::optional<HitOperation>& operation,
                                       const Question& question, const Scene& scene) {
  std::vector<std::uint32_t> entities = question.against;
  if (operation != &difference_of) return entities;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (i != question.against.front() && question.from != i) entities.push_back(i);
  return entities;
}

// Every entity that a question is about, once, by number.
std::vector<std::uint32_t> asked_about(const Options& options, const Scene& scene,
                                       const std::vector<Question>& questions) {
  std::set<std::uint32_t> entities;
  for (const Question& question : questions) {
    const std::vector<std::uint32_t> asked = operands_of(options.operation, question, scene);
    entities.insert(asked.begin(), asked.end());
  }
  return {entities.begin(), entities.end()};
}

tl::unexpected<Diagnostics> nothing_to_clip(const Options& options) {
  if (!options.has("ray") && !options.has("from"))
    return usage_error(named_place("hit"), "there is no ray to ask about",
                       "say --ray x,y,dx,dy, or --from ENTITY --against ENTITY");
  const std::string of_rays =
      options.has("from") ? "the entity of --from needs straight edges, which are its rays; " : "";
  return usage_error(named_place("hit"),
                     "no ray meets a convex piece, a curve or a segment to clip it by",
                     of_rays +
                         "even-odd polygons have no inside to clip to; walls of chambers and their "
                         "pillars: flatray orbit");
}

// --op: what is left of each ray, by the entities that have an inside.
Result<VerbOutput> show_sets(const Options& options, const Scene& scene, const FrameState& state,
                             const std::vector<Question>& questions) {
  std::vector<HitSet> sets;
  bool any = false;
  for (const Question& question : questions)
    for (const NamedRay& ray : question.rays) {
      std::vector<std::vector<HitReport>> by_entity;
      for (const std::uint32_t entity : operands_of(options.operation, question, scene))
        by_entity.push_back(hit_reports(scene, state, ray, entity, question.within));
      any = any ||
            std::ranges::any_of(by_entity, [](const auto& reports) { return !reports.empty(); });
      if (!by_entity.empty()) sets.push_back(combine(ray, *options.operation, by_entity));
    }
  if (!any) return nothing_to_clip(options);
  VerbOutput output{.table = csv_rows(sets)};
  for (const HitSet& set : sets) output.add(as_value(set), text_of(set));
  return output;
}

// Of the entities asked about, what no ray is clipped to: nobody may take silence for a miss.
void tell_left_out(const Options& options, const Scene& scene,
                   const std::vector<Question>& questions) {
  Diagnostics warnings;
  for (const std::uint32_t number : asked_about(options, scene, questions)) {
    const Entity& entity = scene.entities[number];
    if (!scene.shapes[entity.shape].crossing_rings.empty())
      warnings.push_back({entity.where,
                          called("entity", entity.name, entity.where) +
                              " is left out: its outline crosses itself, and is only drawn",
                          "write it as polygons that do not cross themselves"});
  }
  constexpr std::size_t kMostNamed = 3;
  if (warnings.size() > kMostNamed) {
    const std::size_t more = warnings.size() - kMostNamed;
    warnings.erase(warnings.begin() + kMostNamed, warnings.end());
    warnings.push_back({scene.where, fmt::format("{} more left out for that", more), ""});
  }
  report_warnings(warnings, options);
}

VerbOutput show(const Options& options, std::vector<HitReport> reports) {
  if (options.has("csv")) return {.table = csv_rows(std::move(reports))};
  VerbOutput output{.of_all = {{"primitives", primitives_hit(reports)}}};
  for (const HitReport& report : reports)
    output.add(as_value(report), (output.text.empty() ? "" : "\n") + text_of(report));
  return output;
}

Result<VerbOutput> run(const Options& options) {
  FLATRAY_TRY(scene, load_only_input(options, options.scene));
  if (auto straight = expect_no_field(*scene, "hit"); !straight) return fail(std::move(straight));
  FLATRAY_TRY(state, frame_of(options.scene, *scene, options.frame));
  FLATRAY_TRY(questions, read_questions(options, *scene, *state));
  tell_left_out(options, *scene, *questions);
  if (options.operation) return show_sets(options, *scene, *state, *questions);
  std::vector<HitReport> reports;
  for (const Question& question : *questions)
    for (const NamedRay& ray : question.rays)
      for (const std::uint32_t entity : question.against)
        for (HitReport& report : hit_reports(*scene, *state, ray, entity, question.within))
          reports.push_back(std::move(report));
  if (reports.empty()) return nothing_to_clip(options);
  if (options.has("svg"))
    return VerbOutput{{svg_of(*scene, *state, asked_about(options, *scene, *questions), reports)}};
  return show(options, std::move(reports));
}

}  // namespace

extern const Verb entry = {"hit", "SCENE",
                           "show which parts of rays lie inside each shape, edge by edge",
                           kCommand<Options, &run>,
                           "  flatray hit scenes/paper/case_one.toml --from ray --against polygon\n"
                           "  flatray hit scene.toml --ray 1,2,22,10 --domain line --json\n"
                           "  flatray hit scene.toml --ray 1,2,22,10 --svg > hit.svg\n"
                           "  flatray hit scene.toml --ray 1,2,22,10 --op intersection\n"};

}  // namespace flatray::hit_verb
