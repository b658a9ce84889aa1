#include "scene/imports/imports.h"

#include <fmt/core.h>

#include "base/beneath.h"
#include "base/file.h"

namespace flatray {
namespace fs = std::filesystem;

Imports::Imports(SourcePtr scene, std::size_t max_bytes, unsigned threads, fs::path root)
    : scene_(std::move(scene)),
      max_bytes_(max_bytes),
      bytes_left_(max_bytes - std::min(max_bytes, scene_->text().size())),
      threads_(threads),
      root_(std::move(root)),
      scenes_{{scene_->name(), {scene_, {}}}} {}

std::string Imports::path_from_scene(const std::string& file, const Place& where) const {
  const auto known = where ? scenes_.find(where.source->name()) : scenes_.end();
  if (known == scenes_.end() || known->second.folder.empty()) return file;
  return (known->second.folder / file).generic_string();
}

Result<SourcePtr> Imports::open(const std::string& file, const Place& where) {
  if (where && where.source->name() == file && scenes_.contains(file)) return where.source;
  return read(file, path_from_scene(file, where), where, false);
}

Result<SourcePtr> Imports::include(const std::string& file, const Place& where) {
  const std::string path = path_from_scene(file, where);
  Result<SourcePtr> source = read(file, path, where, true);
  if (source) scenes_[(*source)->name()] = {*source, fs::path(path).parent_path()};
  return source;
}

Result<SourcePtr> Imports::read(const std::string& file, const std::string& path,
                                const Place& where, bool included) {
  if (file.empty() || file.find('\0') != std::string::npos)
    return fail(where, "this is not a file name", R"(write file = "outline.obj")");
  if (const auto known = files_.find(path); known != files_.end()) return known->second;
  const fs::path full = fs::path(scene_->name()).parent_path() / path;
  if (root_.empty()) root_ = import_root(scene_->name());
  if (!path_beneath(root_, full))
    return fail(where,
                fmt::format("'{}' lies outside of {}", file,
                            fs::absolute(root_).lexically_normal().string()),
                "files of a scene lie beneath it; --root DIR names another");
  std::error_code missing;  // a pipe or device could keep the reader for ever
  if (fs::exists(full, missing) && !fs::is_regular_file(full, missing))
    return fail(where, fmt::format("'{}' is not a plain file", file),
                included ? "name a scene file to include" : "name an OBJ or list file",
                Trouble::missing);
  // "-" is a file beside the scene here, never standard input.
  Result<std::string> text =
      read_file(full == "-" ? fs::path("./-") : full, {bytes_left_, raise_max_bytes(max_bytes_)});
  if (!text) {
    const Diagnostic& cause = text.error().front();
    return fail(where, fmt::format("file '{}': {}", file, cause.message),
                cause.hint.empty() ? fmt::format("looked for {}", full.string()) : cause.hint,
                cause.trouble);
  }
  if (text->starts_with(kByteOrderMark)) text->erase(0, kByteOrderMark.size());
  bytes_left_ -= text->size();
  auto source = std::make_shared<const SourceText>(full.string(), std::move(*text),
                                                   std::make_shared<const Place>(where));
  return files_.emplace(path, std::move(source)).first->second;
}

Result<Shape> Imports::outline(const SourcePtr& file, const Format& format, double scale,
                               bool centre, Diagnostics& warnings) {
  const auto [kept, is_first] = outlines_.try_emplace({file.get(), &format, scale, centre});
  if (kept->second) return *kept->second;
  Diagnostics told;
  Result<Shape> shape = format.outline(file, {scale, centre, threads_}, is_first ? warnings : told);
  if (!shape || !is_first) kept->second = shape;
  return shape;
}

fs::path import_root(const fs::path& scene) {
  const fs::path folder = folder_of(scene);
  return path_beneath(".", folder) ? fs::path(".") : folder;
}

std::string raise_max_bytes(std::size_t max_bytes) {
  return fmt::format("the limit of a scene and its files is {}; --max-bytes raises it", max_bytes);
}

void Imports::add_to(Hash& hash) const {
  for (const auto& [name, source] : files_) hash.add(name).add(source->text());
}

}  // namespace flatray
