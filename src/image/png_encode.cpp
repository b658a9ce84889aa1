#include "image/png.h"

namespace flatray {

#include "encoders.inc"  // png_writers()

std::vector<std::byte> encode_png(const Image& image, unsigned threads) {
  return PngEncoder(threads).encode(image, [](int, int) { return true; });
}

}  // namespace flatray
