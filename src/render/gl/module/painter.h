#pragma once
#include <vector>

#include "render/gl/module.h"
#include "render/gl/module/functions.h"
#include "render/gl/module/programs.h"
#include "render/gl/module/sheets.h"

namespace flatray::gl {

/// Draws tiles in one context, which is current whenever anything here is called. Keeps shaders,
/// buffers and sheets from one tile to the next.
class Painter {
 public:
  explicit Painter(const Functions& gl) : gl_(gl), programs_(gl), sheets_(gl) {}

  /// Fails where this GL cannot do what is needed.
  void start(FlatrayGlInfo& info, const char* maker);
  void draw(const FlatrayGlTile& tile);
  void stop();

 private:
  struct Table {
    GLuint buffer = 0, texture = 0;
  };

  void fill_table(Unit unit, const void* data, std::size_t bytes);
  void draw_batches(const FlatrayGlTile& tile);
  void draw_batch(const FlatrayGlBatch& batch);
  void draw_triangles(const FlatrayGlBatch& batch);
  void draw_samples(const FlatrayGlBatch& batch);
  void choose_sheet(int32_t kind);

  const Functions& gl_;
  Programs programs_;
  Sheets sheets_;
  Sheets::Name target_ = Sheets::picture;  // of what is blended
  GLuint vertex_array_ = 0, buffer_ = 0;
  std::array<Table, 2> tables_;  // by unit
  std::vector<float> again_;     // a further picture of the same tile
};

}  // namespace flatray::gl
