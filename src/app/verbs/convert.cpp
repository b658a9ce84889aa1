#include <fmt/core.h>

#include <filesystem>

#include "app/files/outputs.h"
#include "app/files/scene_input.h"
#include "app/verb.h"
#include "scene/reading/file_names.h"
#include "scene/reading/write_toml.h"

namespace flatray::convert_verb {
namespace {

namespace fs = std::filesystem;

struct Options : Arguments {
  SceneOptions scene;

  void rows(OptionTable& row) {
    row(kForceRow);
    scene.rows(row);
  }
};

Result<void> check_output(const Arguments& options, const fs::path& output) {
  if (output == "-") return {};
  if (output.extension() != ".toml")
    return usage_error(named_place(output.string()), "scenes are written as TOML",
                       fmt::format("say {}.toml", output.stem().string()));
  std::error_code error;
  if (fs::symlink_status(output, error).type() != fs::file_type::not_found && !options.has("force"))
    return fail(named_place(output.string()), "is there already", "--force writes over it",
                Trouble::output);
  return Outputs(options).allow(output, "");
}

Result<VerbOutput> run(const Options& options) {
  const std::string& input = options.operands()[0];
  const fs::path output = options.operands()[1];
  if (auto checked = check_output(options, output); !checked) return fail(std::move(checked));
  FLATRAY_TRY(read, read_input(options.scene, input));
  report_warnings(read->loaded.warnings, options);
  const fs::path folder = output == "-" ? fs::path() : output.parent_path();
  FLATRAY_TRY(rebased, rebase_file_names(read->desc, input, folder));
  std::string text = write_toml(read->desc);
  if (output == "-") return VerbOutput{{std::move(text)}};
  return Outputs(options).write(output, text).map([] { return VerbOutput{}; });
}

}  // namespace

extern const Verb entry = {"convert",
                           "SCENE OUT.toml",
                           "write a scene of any format as TOML; comments are left out",
                           kCommand<Options, &run>,
                           "  flatray convert scenes/imported/castle.obj castle.toml\n"
                           "  flatray convert scene.toml - -D film.size=[64,64] > small.toml\n",
                           "nothing written"};

}  // namespace flatray::convert_verb
