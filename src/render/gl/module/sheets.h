#pragma once
#include <array>

#include "render/gl/module/functions.h"
#include "render/gl/module/programs.h"

namespace flatray::gl {

/// What is drawn on: floats of one size and number of samples, made when first asked for, with one
/// stencil of marks for all.
class Sheets {
 public:
  enum Name { picture, layer, sums, resolved };
  struct Size {
    int32_t width = 0, height = 0, samples = 0;
    bool operator==(const Size&) const = default;
  };

  explicit Sheets(const Functions& gl) : gl_(gl) {}

  /// Fails where this GL has no such sheets, or no memory.
  void resize(const Size& size);
  void draw_on(Name name);
  /// Shaders read it at Unit::sheet.
  void show(Name name);
  /// The picture, the mean of its samples. Leaves another sheet to draw on.
  void read(float* rgba);
  bool multisampled() const { return size_.samples > 1; }
  int samples() const { return size_.samples; }
  void stop();

 private:
  struct Sheet {
    GLuint framebuffer = 0, texture = 0;
  };
  void make(Name name, int32_t samples);
  void make_texture(GLint format, int32_t samples);

  const Functions& gl_;
  Size size_;
  std::array<Sheet, 4> sheets_;  // by name
  GLuint marks_ = 0;
};

}  // namespace flatray::gl
