#include "image/y4m.h"

namespace flatray::picture {

extern const PictureFormat y4m = {.name = "y4m",
                                  .summary = "video, not packed: what programs for video read",
                                  .kind = "a Y4M video",
                                  .beginning = kY4mSignature,
                                  .of_picture = &y4m_picture,
                                  .part = &y4m_part};

}  // namespace flatray::picture
