#include "image/picture_format.h"

namespace flatray::png_format {

extern const PictureFormat entry = {
    .name = "png",
    .summary = "8-bit values, as shown",
    .kind = "a PNG",
    .beginning = kPngSignature,
    .of_picture = [](const Image& image, PngEncoder& encoder,
                     const RowsChanged& changed) { return encoder.encode(image, changed); },
    .read_picture = [](std::span<const std::byte> bytes,
                       const std::string& name) { return decode_png(bytes, name); }};

}  // namespace flatray::png_format
