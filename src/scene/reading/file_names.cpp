#include "scene/reading/file_names.h"

#include <fmt/core.h>

#include "base/utf8.h"
#include "scene/reading/overrides.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

struct Rebase {
  const fs::path& scene;
  const fs::path& folder;
  Diagnostics problems{};

  void file(Value& name) {
    const bool in_scene = !name.where || is_override(name.where);
    const fs::path source = in_scene ? scene : fs::path(name.where.source->name());
    if (name.text == "-" && source == "-") {
      problems.push_back({named_place("-"),
                          "an outline from standard input has no name to refer to",
                          "give the file by its name", Trouble::usage});
      return;
    }
    const fs::path from = name.text == source.string() ? fs::path() : source.parent_path();
    std::error_code error;  // no such folder: as it is
    const fs::path target = fs::weakly_canonical(fs::absolute(from / name.text), error);
    const fs::path base = fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder), error);
    const fs::path relative = target.lexically_relative(base);
    name.text = (relative.empty() ? target : relative).generic_string();
    if (utf8_prefix(name.text) < name.text.size())
      problems.push_back({name.where ? name.where : named_place(scene.string()),
                          fmt::format("the file name '{}' is not UTF-8, as TOML is", name.text),
                          "rename the file or its folder"});
  }

  void value(Value& any) {
    for (Value& item : any.items) value(item);
    for (Member& member : any.members) {
      if (Value* name = file_of(member))
        file(*name);
      else
        value(member.value);
    }
  }

  // The keys that name a file: shape = { import = { file = "outline.obj" } }, spectrum = "lamp.csv".
  static Value* file_of(Member& member) {
    Member* key = member.key == "import"     ? member.value.find("file")
                  : member.key == "spectrum" ? &member
                                             : nullptr;
    return key != nullptr && key->value.kind == Value::Kind::string ? &key->value : nullptr;
  }
};

}  // namespace

Result<void> rebase_file_names(SceneDesc& desc, const fs::path& scene, const fs::path& folder) {
  Rebase rebase{scene, folder};
  rebase.value(desc.root);
  if (!rebase.problems.empty()) return tl::unexpected(std::move(rebase.problems));
  return {};
}

}  // namespace flatray
