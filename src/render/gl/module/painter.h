#pragma once
#include <string>
#include <vector>

#include "render/gl/module.h"
#include "render/gl/module/functions.h"

namespace flatray::gl {

/// Draws tiles in one context, which is current whenever anything here is called. Keeps shader,
/// buffers and pictures from one tile to the next.
class Painter {
 public:
  explicit Painter(const Functions& gl) : gl_(gl) {}

  /// False where this GL cannot do what is needed; `error` says what.
  bool start(FlatrayGlInfo& info, const char* maker, std::string& error);
  bool draw(const FlatrayGlTile& tile, std::string& error);
  void stop();

 private:
  // A framebuffer with light as floats, and room for marks where it is drawn into.
  struct Picture {
    GLuint framebuffer = 0, light = 0, marks = 0;
  };

  bool make_program(std::string& error);
  struct Size {
    int32_t width = 0, height = 0, samples = 0;
    bool operator==(const Size&) const = default;
  };

  bool make_pictures(const Size& size, std::string& error);
  Picture make_picture(const Size& size, bool with_marks);
  void drop(Picture& picture);
  void draw_batches(const FlatrayGlTile& tile);
  void set_up(int32_t kind);
  void read(const FlatrayGlTile& tile, float* rgba);

  const Functions& gl_;
  GLuint program_ = 0, vertex_array_ = 0, buffer_ = 0;
  GLint shift_ = -1;
  Picture drawn_, resolved_;
  Size size_;
  std::vector<float> again_;  // a further picture of the same tile
};

}  // namespace flatray::gl
