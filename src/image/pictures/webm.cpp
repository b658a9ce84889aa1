#include "image/y4m.h"

namespace flatray::webm_format {
namespace {

constexpr const char* kArguments[] = {"-c:v", "libvpx-vp9", "-crf",    "24", "-b:v", "0", "-row-mt",
                                      "1",    "-pix_fmt",   "yuv420p", "-f", "webm"};

}  // namespace

extern const PictureFormat entry = {.name = "webm",
                                    .summary = "video as VP9, by ffmpeg",
                                    .kind = "a WebM video",
                                    .beginning = "\x1a\x45\xdf\xa3",
                                    .of_picture = &y4m_picture,
                                    .part = &y4m_part,
                                    .most_fps = 1000,  // times are whole milliseconds
                                    .by_ffmpeg = kArguments};

}  // namespace flatray::webm_format
