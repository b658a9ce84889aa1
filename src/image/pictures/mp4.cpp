#include "image/y4m.h"

namespace flatray::mp4_format {
namespace {

// Colours at half the size, as all players show; so sizes are even. What is added to odd ones, right and below, is as
// its neighbour, with which it shares its colour: the picture lies over itself moved by one.
constexpr const char* kEven =
    "split=3[a][b][c];[a]pad=ceil(iw/2)*2:ceil(ih/2)*2[p];"
    "[p][b]overlay=W-w:H-h:format=yuv444[q];[q][c]overlay=format=yuv444";
// A file counts in up to 20000 ticks a second; players ignore the order of frames that are 2^28 ticks apart, as those
// may be that are five apart.
constexpr double kLeastRate = 0.001;
constexpr const char* kArguments[] = {"-c:v",      "libx264",    "-crf", "18",
                                      "-pix_fmt",  "yuv420p",    "-vf",  kEven,
                                      "-movflags", "+faststart", "-f",   "mp4"};

}  // namespace

extern const PictureFormat entry = {
    .name = "mp4",
    .summary = "video as H.264, by ffmpeg: of odd sizes the last column or row comes twice",
    .kind = "an MP4 video",
    .beginning = {"\0\0\0 ftyp", 8},
    .of_picture = &y4m_picture,
    .part = &y4m_part,
    .least_fps = kLeastRate,
    .by_ffmpeg = kArguments};

}  // namespace flatray::mp4_format
