#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/load.h"
#include "scene/scene.h"

namespace flatray {

/// Of a file of lines, or a question, so many mistakes are told.
inline constexpr std::size_t kMostProblems = 20;

/// How an outline is laid before it becomes a shape.
struct OutlineOptions {
  double scale = 1;
  bool centre = false;  ///< moves the centre of its bounds to the origin first
  unsigned threads = 1;
};

/// A way to write scenes: one file in formats/, registered in CMake.
struct Format {
  const char* name;
  const char* usage;
  std::span<const std::string_view> extensions;  ///< without the point, lower case
  /// Whether text without a name looks like it.
  bool (*recognises)(std::string_view text);
  /// Whole scene. Error   the first mistake of syntax; more entries than the limits allow.
  Result<SceneDesc> (*read)(const SourcePtr&, const LoadLimits&);
  /// Outline for the shape `import`; nullptr where the format holds none.
  Result<Shape> (*outline)(const SourcePtr&, const OutlineOptions&, Diagnostics& warnings);
};

/// Registered formats by name.
std::vector<const Format*> formats();
/// What follows the last point, in lower case.
std::string extension_of(std::string_view file_name);
/// nullptr: none of that name or extension.
const Format* find_format(std::string_view name);
const Format* format_for_name(std::string_view file_name);
/// By content: for standard input.
const Format* format_for_text(std::string_view text);

/// Extensions of all formats, for hints: ".toml, .obj".
std::string known_extensions();

/// What some editors begin a text with; it is passed over.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// First line that is neither blank nor a comment ('#'), without blanks at its ends.
std::string_view first_line(std::string_view text);
std::string_view trimmed(std::string_view text);

/// What a scene is called: its file name without folder and extension.
std::string scene_name(std::string_view file_name);

}  // namespace flatray
