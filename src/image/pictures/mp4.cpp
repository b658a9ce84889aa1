#include "image/y4m.h"

namespace flatray::mp4_format {
namespace {

// Colours at half the size, as all players show; so sizes are even.
constexpr const char* kArguments[] = {
    "-c:v",      "libx264",    "-crf", "18",
    "-pix_fmt",  "yuv420p",    "-vf",  "pad=ceil(iw/2)*2:ceil(ih/2)*2",
    "-movflags", "+faststart", "-f",   "mp4"};

}  // namespace

extern const PictureFormat entry = {
    .name = "mp4",
    .summary = "video as H.264, by ffmpeg: odd sizes get a black column or row more",
    .kind = "an MP4 video",
    .beginning = {"\0\0\0 ftyp", 8},
    .of_picture = &y4m_picture,
    .part = &y4m_part,
    .by_ffmpeg = kArguments};

}  // namespace flatray::mp4_format
