#pragma once
#include <string>
#include <vector>

#include "render/gl/module.h"
#include "render/gl/module/functions.h"
#include "render/gl/module/programs.h"

namespace flatray::gl {

/// Draws tiles in one context, which is current whenever anything here is called. Keeps shader,
/// buffers and pictures from one tile to the next.
class Painter {
 public:
  explicit Painter(const Functions& gl) : gl_(gl), programs_(gl) {}

  /// False where this GL cannot do what is needed; `error` says what.
  bool start(FlatrayGlInfo& info, const char* maker, std::string& error);
  bool draw(const FlatrayGlTile& tile, std::string& error);
  void stop();

 private:
  // A framebuffer with light as floats, and room for marks where it is drawn into.
  struct Picture {
    GLuint framebuffer = 0, light = 0, marks = 0;
  };

  struct Table {
    GLuint buffer = 0, texture = 0;
  };
  struct Size {
    int32_t width = 0, height = 0, samples = 0;
    bool operator==(const Size&) const = default;
  };

  bool make_pictures(const Size& size, std::string& error);
  Picture make_picture(const Size& size, bool with_marks);
  void drop(Picture& picture);
  bool fill_table(Unit unit, const void* data, std::size_t bytes, std::string& error);
  bool draw_batches(const FlatrayGlTile& tile, std::string& error);
  bool set_up(const FlatrayGlBatch& batch, std::string& error);
  void set_marks(int32_t kind);
  void read(const FlatrayGlTile& tile, float* rgba);

  const Functions& gl_;
  Programs programs_;
  GLuint vertex_array_ = 0, buffer_ = 0;
  std::array<Table, 2> tables_;  // by unit
  Picture drawn_, resolved_;
  Size size_;
  std::vector<float> again_;  // a further picture of the same tile
};

}  // namespace flatray::gl
