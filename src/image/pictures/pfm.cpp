#include "image/pfm.h"

#include "image/picture_format.h"

namespace flatray::pfm_format {

extern const PictureFormat entry = {.name = "pfm",
                                    .summary = "light, every float as it is",
                                    .kind = "a PFM picture",
                                    .beginning = kPfmSignature,
                                    .of_light = &encode_pfm,
                                    .read_light = &decode_pfm};

}  // namespace flatray::pfm_format
