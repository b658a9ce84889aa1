#include "image/y4m.h"

namespace flatray::y4m_format {

extern const PictureFormat entry = {.name = "y4m",
                                    .summary = "video, not packed: what programs for video read",
                                    .kind = "a Y4M video",
                                    .beginning = kY4mSignature,
                                    .of_picture = &y4m_picture,
                                    .part = &y4m_part};

}  // namespace flatray::y4m_format
