#include "scene/imports.h"

#include <fmt/core.h>

#include "base/file.h"

namespace flatray {
namespace fs = std::filesystem;

Imports::Imports(SourcePtr scene, std::size_t max_file_bytes, unsigned threads)
    : scene_(std::move(scene)), max_file_bytes_(max_file_bytes), threads_(threads) {}

Result<SourcePtr> Imports::open(const std::string& file, const Place& where) {
  if (file == scene_->name()) return scene_;
  if (file.empty() || file.find('\0') != std::string::npos)
    return fail(where, "this is no file name", R"(write file = "outline.obj")");
  if (const auto known = files_.find(file); known != files_.end()) return known->second;
  const fs::path path = fs::path(scene_->name()).parent_path() / file;
  std::error_code missing;  // a pipe or device could keep the reader for ever
  if (fs::exists(path, missing) && !fs::is_regular_file(path, missing))
    return fail(where, fmt::format("'{}' is no regular file", file), "name an OBJ or list file",
                Trouble::missing);
  // "-" is a file beside the scene here, never standard input.
  Result<std::string> text = read_file(path == "-" ? fs::path("./-") : path, max_file_bytes_);
  if (!text) {
    const Diagnostic& cause = text.error().front();
    return fail(where, fmt::format("file '{}': {}", file, cause.message),
                fmt::format("looked for {}", path.string()), cause.trouble);
  }
  auto source = std::make_shared<const SourceText>(path.string(), std::move(*text));
  return files_.emplace(file, std::move(source)).first->second;
}

void Imports::add_to(Hash& hash) const {
  for (const auto& [name, source] : files_) hash.add(name).add(source->text());
}

}  // namespace flatray
