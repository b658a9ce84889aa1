// The least program that draws the ten polygons of whole_process through OSMesa and writes a PNG:
// osmesa_frame OUT.png
#include <GL/gl.h>
#include <GL/osmesa.h>

#include "polygons.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

int main(int count, char** arguments) {
  constexpr int kWidth = 1920, kHeight = 1080;
  if (count != 2) return 2;
  std::vector<unsigned char> pixels(4ULL * kWidth * kHeight);
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
  if (!OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, kWidth, kHeight)) return 1;
  OSMesaPixelStore(OSMESA_Y_UP, 0);
  glMatrixMode(GL_PROJECTION);
  glOrtho(0, kWidth, kHeight, 0, -1, 1);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  for (const bench::Polygon& polygon : bench::polygons(10, kWidth, kHeight)) {
    glColor3ubv(polygon.colour.data());
    glBegin(GL_TRIANGLE_FAN);
    for (const auto& corner : polygon.corners) glVertex2d(corner.x(), corner.y());
    glEnd();
  }
  glFinish();
  std::vector<unsigned char> rgb;
  rgb.reserve(3ULL * kWidth * kHeight);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (i % 4 != 3) rgb.push_back(pixels[i]);
  const bool written =
      stbi_write_png(arguments[1], kWidth, kHeight, 3, rgb.data(), 3 * kWidth) != 0;
  OSMesaDestroyContext(context);
  return written ? 0 : 1;
}
