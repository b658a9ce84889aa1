#include "image/pfm.h"

#include "image/picture_format.h"

namespace flatray::picture {

extern const PictureFormat pfm = {.name = "pfm",
                                  .summary = "light, every float as it is",
                                  .kind = "a PFM picture",
                                  .beginning = kPfmSignature,
                                  .of_light = &encode_pfm,
                                  .read_light = &decode_pfm};

}  // namespace flatray::picture
