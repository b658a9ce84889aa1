#include "image/png.h"

namespace flatray {

namespace png_writer {
#define FLATRAY_ENTRY(name) extern const PngWriter name;
#include "encoders.inc"
#undef FLATRAY_ENTRY
}  // namespace png_writer

std::vector<const PngWriter*> png_writers() {
  return {
#define FLATRAY_ENTRY(name) &png_writer::name,
#include "encoders.inc"
#undef FLATRAY_ENTRY
  };
}

std::vector<std::byte> encode_png(const Image& image, unsigned threads) {
  return PngEncoder(threads).encode(image, [](int, int) { return true; });
}

}  // namespace flatray
