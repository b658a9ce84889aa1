#include "image/hdr.h"

#include "image/picture_format.h"

namespace flatray::hdr_format {

extern const PictureFormat entry = {
    .name = "hdr",
    .summary = "light, as Radiance keeps it: 8 bits a channel and an exponent",
    .kind = "an HDR picture",
    .beginning = kHdrSignature,
    .of_light = &encode_hdr,
    .read_light = [](std::span<const std::byte> bytes, const std::string& name) {
      return decode_hdr(bytes, name);
    }};

}  // namespace flatray::hdr_format
