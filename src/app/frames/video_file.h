#pragma once
#include <optional>

#include "base/child_program.h"
#include "base/file.h"
#include "image/picture_format.h"

namespace flatray {

/// A file of all frames of a sequence while it is written: a plain file, standard output, or what a
/// program makes of the parts. A file has its name once it is whole; where it never is, nothing is
/// left. What ends the other side of a pipe ends the write, not flatray.
class VideoFile {
 public:
  /// `path` is "-" for standard output.
  /// Error   Trouble::output; Trouble::unavailable where the format's program is not on this
  ///         machine, with what to install.
  static Result<VideoFile> begin(const PictureFormat& format, const std::filesystem::path& path);

  /// The bytes of the next part. Error   Trouble::output, with what the program said.
  Result<void> add(std::span<const std::byte> bytes);
  /// Whether it is a file, which is there whole or not at all, and not standard output.
  bool is_file() const { return file_.has_value(); }
  /// Gives it its name.
  Result<void> finish();

 private:
  explicit VideoFile(const std::filesystem::path& path) : path_(path) {}

  std::filesystem::path path_;
  std::optional<NewFile> file_;          ///< none: standard output
  std::optional<ChildProgram> program_;  ///< that writes the file
};

}  // namespace flatray
