#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "flatray/owned.h"
#include "flatray/status.h"

/// Takes a scene as text and gives the pixels of one of its frames. It writes no file.
namespace flatray::api {

/// A picture in memory, drawn by the software back end: the same bytes on every machine.
///
/// Owns    its pixels and texts. What it gives is valid until it draws again, is moved or is
///         destroyed.
/// Threads one at a time for one picture; any number of pictures may draw at once.
class Picture {
 public:
  Picture();
  Picture(Picture&&) noexcept;
  Picture& operator=(Picture&&) noexcept;
  ~Picture();

  /// Draws one frame, on `threads` threads.
  ///
  /// Needs   a `name` whose extension is that of the text's format: "scene.toml". Files that the scene
  ///         refers to are looked for beside that name.
  /// Gives   whether there is a picture now. Where there is none, messages() says why.
  bool draw(std::string_view name, std::string_view text, unsigned frame = 1, unsigned threads = 1);
  /// Every mistake of the scene as `file:line:column: error: ...`, or `file: error: ...`, with its remedy;
  /// warnings where a picture was drawn.
  std::string_view messages() const;

  int width() const;     ///< 0 where there is no picture
  int height() const;    ///< likewise
  int channels() const;  ///< 3: red, green, blue; 4: and opacity
  /// width * height * channels bytes of sRGB, row after row from the top, opacity not multiplied in.
  std::span<const std::uint8_t> pixels() const;
  /// The picture as a PNG file holds it; empty where there is none. Packed anew by each call.
  std::span<const std::uint8_t> png(unsigned threads = 1);

 private:
  struct Data;
  Data& data();
  Owned<Data> data_;
};

}  // namespace flatray::api
