#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "image/picture_format.h"

namespace flatray {

/// Error   Trouble::usage for a name that no format has; Trouble::unavailable for one left out.
Result<const PictureFormat*> picture_format(const std::string& name, const Place& where);

/// How files of one frame end (arguments.h's Words): those of pictures; of films of light, too.
std::vector<std::string> endings_of_pictures();
std::vector<std::string> endings_of_frames();

/// Where in a text the number of a frame goes; nowhere without a length.
struct FramePlace {
  std::size_t at = 0, length = 0;
  int digits = 1;
};

/// Where pictures go: "out/{scene}/frame_####.png". `####` (any number of #, the last run in the
/// file name) or `%04d` is the frame number, `{scene}` the scene's name. Nothing else is special,
/// and no name is ever a format string.
class OutputPattern {
 public:
  /// `format` is --format, if given; else the extension decides.
  /// Error   Trouble::usage: empty, a folder, no known extension, extension against `format`, a
  ///         name too long; names of frames that are not UTF-8.
  static Result<OutputPattern> parse(std::string text, const std::optional<std::string>& format,
                                     const Place& where);
  /// out/<scene>/frame_####.png for sequences, out/<scene>.png for one picture, out/<scene>.y4m for
  /// a video.
  static OutputPattern standard(bool sequence, const PictureFormat& format);

  bool is_stdout() const { return text_ == "-"; }
  bool has_frame() const { return place_.length > 0; }
  bool has_scene() const { return text_.find("{scene}") != std::string::npos; }
  const PictureFormat& format() const { return *format_; }

  /// `scene` is a `plain_name`.
  std::filesystem::path path(std::string_view scene, unsigned frame) const;
  /// The name of its files, with as many # as the frame number has digits.
  std::string file_pattern(std::string_view scene) const;
  /// The first folder of the path that the scene's name chose and that is a symbolic link: through
  /// it the name would choose a place elsewhere. Links the user wrote out are the user's word.
  std::optional<std::filesystem::path> link_chosen_by(std::string_view scene) const;

 private:
  OutputPattern(std::string text, const PictureFormat& format);
  std::filesystem::path with_number(std::string_view scene, const std::string& number) const;

  std::string text_;
  const PictureFormat* format_;
  FramePlace place_;
};

/// A text in which letters, digits, '_', '-' and '.' stay, and any other byte becomes '_'.
std::string plain_letters(std::string text);
/// A scene's name as part of a path: letters, digits, '_', '-' and inner '.' stay, any other byte
/// becomes '_', so it can neither leave the output folder nor hide in it nor be a device. Error
/// Trouble::usage for more than kLongestName bytes.
inline constexpr std::size_t kLongestName = 100;
Result<std::string> plain_name(std::string_view scene);

}  // namespace flatray
