#include <fmt/core.h>

#include <filesystem>

#include "app/files/outputs.h"
#include "app/files/scene_input.h"
#include "app/verb.h"
#include "base/utf8.h"
#include "scene/reading/file_names.h"
#include "scene/reading/format.h"
#include "scene/reading/reader.h"
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

std::size_t bytes_as_utf8(std::string_view text) {
  std::size_t bytes = text.size();
  for (std::size_t stray; (stray = utf8_prefix(text)) < text.size(); ++bytes)
    text.remove_prefix(stray + 1);
  return bytes;
}

// Names of lists may be in any encoding: those that are too long when they are written as UTF-8.
void find_long_strings(const Value& value, Diagnostics& problems) {
  const std::size_t bytes = bytes_as_utf8(value.text);
  if (value.text.size() <= kMostStringBytes && bytes > kMostStringBytes)
    problems.push_back({value.where, fmt::format("this takes {} bytes as UTF-8", bytes),
                        fmt::format("strings end at {} bytes: shorten it", kMostStringBytes)});
  for (const Value& item : value.items) find_long_strings(item, problems);
  for (const Member& member : value.members) find_long_strings(member.value, problems);
}

// What is written is read again, as a TOML scene may hold less than other formats and many files.
Result<std::string> written(const SceneDesc& desc, const std::string& input) {
  Diagnostics problems;
  find_long_strings(desc.root, problems);
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  std::string text = write_toml(desc);
  const Format* toml = find_format("toml");
  if (toml == nullptr) return text;  // left out of this build
  const auto again = toml->read(std::make_shared<const SourceText>(input, text), {});
  if (again) return text;
  const std::string file = input == "-" ? "FILE" : fs::path(input).filename().string();
  return fail(named_place(input), "as TOML, " + again.error().front().message,
              again.error().front().hint +
                  fmt::format("; a scene with include = [\"{}\"] needs none of it", file));
}

Result<VerbOutput> run(const Options& options) {
  const std::string& input = options.operands()[0];
  const fs::path output = options.operands()[1];
  if (auto checked = check_output(options, output); !checked) return fail(std::move(checked));
  FLATRAY_TRY(read, read_input(options.scene, input));
  report_warnings(read->loaded.warnings, options);
  const fs::path folder = output == "-" ? fs::path() : output.parent_path();
  FLATRAY_TRY(rebased, rebase_file_names(read->desc, input, folder));
  FLATRAY_TRY(text, written(read->desc, input));
  if (output == "-") return VerbOutput{{std::move(*text)}};
  return Outputs(options).write(output, *text).map([] { return VerbOutput{}; });
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
