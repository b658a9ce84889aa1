#include "app/options/places.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "app/options/option_values.h"
#include "base/beneath.h"
#include "base/file.h"
#include "base/module_file.h"
#include "base/sandbox.h"
#include "scene/imports/imports.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// Where output goes that no option names: out/NAME.
constexpr const char* kOutputFolder = "out";

struct Named {
  fs::path path;
  Place where;
  enum class Kind { scene, read, file_written, folder_written } kind;
};

Named::Kind kind_of(std::string_view metavar, const fs::path& path) {
  if (metavar == "OUT.png" && !path.has_extension()) return Named::Kind::folder_written;
  if (metavar == "SCENE") return Named::Kind::scene;
  if (metavar == "FOLDER" || metavar == "DIR") return Named::Kind::folder_written;
  return metavar == "PATTERN" || metavar.starts_with("OUT") ? Named::Kind::file_written
                                                            : Named::Kind::read;
}

// All but "-".
std::vector<Named> named_by(const Verb& verb, const Arguments& arguments) {
  std::vector<Named> all;
  const std::vector<Option> options = verb.command.options();
  if (has_own_root(options))
    return {{arguments.text("root").value_or("."), arguments.where("root"),
             Named::Kind::folder_written}};
  const std::vector<std::string>& operands = arguments.operands();
  for (std::size_t i = 0; i < operands.size(); ++i)
    if (const std::string what = operand_word(verb, i); names_path(what) && operands[i] != "-")
      all.push_back({operands[i], named_place(operands[i]),
                     what == "FOLDER" ? Named::Kind::read : kind_of(what, operands[i])});
  bool has_output = false;
  for (const Option& option : options) {
    has_output = has_output || option.name == "output";
    if (!names_path(option.metavar)) continue;
    for (const std::string& path : arguments.list(option.name))
      if (path != "-")
        all.push_back({path, arguments.where(option.name), kind_of(option.metavar, path)});
  }
  if (has_output && !arguments.has("output"))
    all.push_back({kOutputFolder, named_place(kOutputFolder), Named::Kind::folder_written});
  return all;
}

// The folder that what is written lies in, with what a scene's name chooses in it.
fs::path folder_written(const Named& one) {
  if (one.kind == Named::Kind::folder_written) return one.path;
  const std::string pattern = one.path.string();
  return folder_of(pattern.substr(0, pattern.find("{scene}")));
}

// A folder to write to is made only where something will be written, as the kernel opens none that is not there.
bool writes(const Verb& verb, const Arguments& arguments, std::span<const Named> all) {
  return !arguments.has("dry-run") && !has_own_root(verb.command.options()) &&
         std::ranges::all_of(all, [](const Named& one) {
           std::error_code error;
           return one.kind != Named::Kind::scene || fs::exists(one.path, error);
         });
}

Result<void> open_for(const Named& one, const Arguments& arguments, bool make, Sandbox& sandbox) {
  if (one.kind == Named::Kind::scene || one.kind == Named::Kind::read) {
    sandbox.read.push_back(one.path);
    if (one.kind == Named::Kind::scene)
      sandbox.read.push_back(arguments.text("root").value_or(import_root(one.path).string()));
    return {};
  }
  const fs::path folder = folder_written(one);
  std::error_code error;
  if (make) fs::create_directories(folder, error);
  if (error) return cannot("make the folder", folder, error.value(), Trouble::output);
  if (fs::exists(folder, error)) sandbox.write.push_back(folder);
  return {};
}

}  // namespace

std::string operand_word(const Verb& verb, std::size_t index) {
  const std::vector<std::string_view> words = split(verb.operands, ' ');
  std::string word(words[std::min(index, words.size() - 1)]);
  std::erase_if(word, [](char c) { return c == '[' || c == ']'; });
  return word.substr(0, word.find("..."));
}

bool has_own_root(std::span<const Option> own) {
  return std::ranges::any_of(own, [](const Option& option) { return option.name == "root"; });
}

bool names_path(std::string_view metavar) {
  for (const std::string_view word : {"SCENE", "PATTERN", "FOLDER", "DIR", "FILE"})
    if (metavar.starts_with(word)) return true;
  return metavar.ends_with(".png") || metavar.starts_with("OUT");
}

void check_root(const Verb& verb, Arguments& arguments) {
  const auto root = arguments.text("root");
  if (!root || has_own_root(verb.command.options())) return;
  if (std::error_code error; !fs::is_directory(*root, error)) {
    arguments.problems.push_back({arguments.where("root"), fmt::format("'{}' is no folder", *root),
                                  "name the folder that all files lie in", Trouble::usage});
    return;
  }
  for (const Named& one : named_by(verb, arguments))
    if (!path_beneath(*root, one.path))
      arguments.problems.push_back(
          {one.where, fmt::format("'{}' lies outside of --root {}", one.path.string(), *root),
           "name a place in that folder", Trouble::usage});
}

Result<void> expect_in_root(const std::string& root, std::span<const fs::path> files) {
  Diagnostics problems;
  for (const fs::path& file : files)
    if (!path_beneath(root, file))
      problems.push_back({named_place(file.string()), "lies outside of --root " + root,
                          "put the file itself there", Trouble::usage});
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return {};
}

Result<void> enter_sandbox(const Verb& verb, const Arguments& arguments) {
  if (!arguments.has("sandbox")) return {};
  Sandbox sandbox{{"/usr", "/lib", "/lib64", "/etc/ld.so.cache", "/proc/cpuinfo"}, {}};
  std::error_code error;
  sandbox.read.push_back(fs::read_symlink("/proc/self/exe", error).parent_path());
  for (const ModuleFile& module : kAllModules)
    if (const char* file = std::getenv(module.variable); file != nullptr)
      sandbox.read.emplace_back(file);
  const std::vector<Named> named = named_by(verb, arguments);
  const bool make = writes(verb, arguments, named);
  for (const Named& one : named)
    if (auto opened = open_for(one, arguments, make, sandbox); !opened) return opened;
  return enter_sandbox(sandbox);
}

}  // namespace flatray
