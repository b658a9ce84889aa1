#pragma once
#include <filesystem>
#include <map>

#include "base/hash.h"
#include "base/result.h"

namespace flatray {

/// The files a scene refers to, each read once.
class Imports {
 public:
  /// Needs   `scene` outlives the object: paths are relative to its folder, and its own name gives
  ///         its text.
  Imports(SourcePtr scene, std::size_t max_file_bytes, unsigned threads);

  /// Error   the file's own, at `where`.
  Result<SourcePtr> open(const std::string& file, const Place& where);
  /// Adds the bytes of every file read so far, by name.
  void add_to(Hash& hash) const;
  /// Threads to read outlines with.
  unsigned threads() const { return threads_; }

 private:
  SourcePtr scene_;
  std::size_t max_file_bytes_;
  unsigned threads_;
  std::map<std::string, SourcePtr> files_;
};

}  // namespace flatray
