#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/film_file.h"
#include "image/image.h"
#include "image/png.h"

namespace flatray {

/// All frames that one file holds.
struct FrameSequence {
  int width = 0, height = 0;
  std::size_t frames = 0;
  double fps = 24;
};

/// A format of picture files: what --format, names of files, `flatray list pictures` and messages know
/// of it. A file in `pictures/` and a line in CMake.
struct PictureFormat {
  using Bytes = std::vector<std::byte>;

  const char* name;  ///< of --format, and how names of its files end
  const char* summary;
  const char* kind;            ///< what one of its files is: "a PNG"
  std::string_view beginning;  ///< how each of its files begins

  // One of these three is there, and says what is kept of a frame.
  /// 8-bit values. The encoder is that of the frames before, for what is packed as PNG.
  Bytes (*of_picture)(const Image& image, PngEncoder& png, const RowsChanged& changed) = nullptr;
  /// Linear light, neither exposed nor toned.
  Bytes (*of_light)(const LinearImage& image) = nullptr;
  /// Whole numbers, to which more light can be added.
  Bytes (*of_film)(const FilmFile& film) = nullptr;

  // Of videos, whose files hold all frames: `of_picture` gives what is kept of one.
  /// The bytes that frame `index`, from 0, adds to the file. All of them in order are the file.
  Bytes (*part)(std::span<const std::byte> picture, std::size_t index,
                const FrameSequence& sequence) = nullptr;
  /// Rates that the file holds, and players keep: of others the nearest.
  double least_fps = 1 / 1e6, most_fps = 1e6;
  /// Of formats that ffmpeg writes, from the bytes of `part`, which are Y4M: the arguments of ffmpeg
  /// between its input and its output.
  std::span<const char* const> by_ffmpeg = {};

  // Of formats that are read back. Error   Trouble::invalid at `name`.
  Result<Image> (*read_picture)(std::span<const std::byte> bytes,
                                const std::string& name) = nullptr;
  Result<LinearImage> (*read_light)(std::span<const std::byte> bytes,
                                    const std::string& name) = nullptr;

  bool is_video() const { return part != nullptr; }
  /// A picture that comes after no other.
  Bytes encode(const Image& image) const;
};

/// Registered formats by name.
std::vector<const PictureFormat*> picture_formats();
std::vector<std::string> picture_format_names();

/// The format of a name; null where there is none.
const PictureFormat* find_picture_format(std::string_view name);
/// The format by which a file's name ends, in letters of either case; null where it is none of them.
const PictureFormat* picture_format_by_name(const std::filesystem::path& file);
/// The format whose files begin like this content, of several the one that is read back; null where it
/// is none of them.
const PictureFormat* picture_format_of(std::span<const std::byte> content);

}  // namespace flatray
