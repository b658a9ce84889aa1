#pragma once
#include <filesystem>
#include <map>

#include "base/hash.h"
#include "base/result.h"
#include "scene/reading/format.h"

namespace flatray {

/// The files a scene refers to, each read once.
class Imports {
 public:
  /// Needs   `scene` outlives the object: paths in it are relative to its folder. `max_bytes` counts
  ///         it and all other files together.
  ///         What lies outside of `root`, or is reached by links that leave it, is refused unread; ""
  ///         stands for import_root(scene).
  Imports(SourcePtr scene, std::size_t max_bytes, unsigned threads,
          std::filesystem::path root = {});

  /// A file by its path from the folder of the file `where` stands in; that file itself by its name.
  /// Error   the file's own, at `where`.
  Result<SourcePtr> open(const std::string& file, const Place& where);
  /// The same for a scene that is included there: paths in it are relative to its own folder.
  Result<SourcePtr> include(const std::string& file, const Place& where);
  /// The outline in a file that `open` gave. `warnings` are told with the first of each.
  Result<Shape> outline(const SourcePtr& file, const Format& format, double scale, bool centre,
                        Diagnostics& warnings);
  /// Adds the bytes of every file read so far, by name.
  void add_to(Hash& hash) const;

 private:
  struct Scene {
    SourcePtr source;
    std::filesystem::path folder;  ///< from that of the scene
  };
  /// Path from the folder of the scene.
  std::string path_from_scene(const std::string& file, const Place& where) const;
  Result<SourcePtr> read(const std::string& file, const std::string& path, const Place& where,
                         bool included);

  SourcePtr scene_;
  std::size_t max_bytes_, bytes_left_;
  unsigned threads_;
  std::filesystem::path root_;
  std::map<std::string, SourcePtr> files_;  ///< by path from the scene
  std::map<std::string, Scene> scenes_;     ///< by their own names
  /// By file, format, scale and centre; kept from the second import on, as one alone needs no copy, and
  /// where it is wrong.
  std::map<std::tuple<const SourceText*, const Format*, double, bool>, std::optional<Result<Shape>>>
      outlines_;
};

/// The folder beneath which the files lie that a scene may refer to, if nobody says another: the one the
/// program runs in where the scene lies beneath it, else the scene's own.
std::filesystem::path import_root(const std::filesystem::path& scene);

/// What to do about files too large.
std::string raise_max_bytes(std::size_t max_bytes);

}  // namespace flatray
