#include <fmt/core.h>

#include "app/files/scene_input.h"
#include "app/verb.h"
#include "base/counted.h"
#include "base/shown_text.h"
#include "collide/scene_timeline.h"
#include "render/coverage/unseen.h"

namespace flatray::check_verb {
namespace {

struct Options : Arguments {
  SceneOptions scene;

  void rows(OptionTable& row) {
    row(kJsonRow);
    scene.rows(row);
  }
};

std::string facts(const Scene& scene) {
  return fmt::format("{}, {}, {}, {} of {}x{}",
                     counted(scene.entities.size(), "entity", "entities"),
                     counted(scene.chambers.size(), "chamber"), counted(scene.rays.size(), "ray"),
                     counted(scene.frames, "frame"), scene.film.width, scene.film.height);
}

Result<VerbOutput> run(const Options& options) {
  Diagnostics problems;
  VerbOutput output;
  for (const std::string& path : options.operands()) {
    const Result<LoadedScene> loaded = load_input(options.scene, path);
    Diagnostics errors = loaded ? Diagnostics{} : loaded.error(), warnings;
    if (loaded) {
      if (auto bodies = timeline_before_trouble(loaded->scene, loaded->scene.seed, 1); !bodies)
        errors = std::move(bodies).error();
      warnings = loaded->warnings;
      const Diagnostics unseen = unseen_in(loaded->scene, loaded->scene.seed);
      warnings.insert(warnings.end(), unseen.begin(), unseen.end());
    }
    report_warnings(warnings, options);
    const bool told = errors.empty() && !options.has("quiet");
    output.add(Fields{{"scene", path},
                      {"valid", errors.empty()},
                      {"errors", as_values(errors)},
                      {"warnings", as_values(warnings)}},
               told ? fmt::format("{}: valid, {}\n", shown_text(path), facts(loaded->scene)) : "");
    problems.insert(problems.end(), errors.begin(), errors.end());
  }
  if (!problems.empty()) output.exit_code = report_failure(problems, "");
  return output;
}

}  // namespace

extern const Verb entry = {"check", "SCENE...",
                           "read scenes and report every mistake, without drawing",
                           kCommand<Options, &run>, "  flatray check scenes/*.toml\n"};

}  // namespace flatray::check_verb
