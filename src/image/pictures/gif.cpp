#include "image/y4m.h"

namespace flatray::gif_format {
namespace {

// Delays are whole hundredths of a second, of 16 bits. Players show shorter ones for longer, most for 10.
constexpr double kLeastDelay = 2;

// A palette a frame: colours of one frame, and no memory of all of them.
constexpr const char* kPalettes =
    "scale=in_color_matrix=bt709:in_range=limited:out_range=full,format=rgb24,split[a][b];"
    "[a]palettegen=stats_mode=single:reserve_transparent=0[p];[b][p]paletteuse=new=1";
constexpr const char* kArguments[] = {"-vf", kPalettes, "-loop", "0", "-f", "gif"};

}  // namespace

extern const PictureFormat entry = {.name = "gif",
                                    .summary = "video of 256 colours a frame, by ffmpeg; for ever",
                                    .kind = "a GIF",
                                    .beginning = "GIF8",
                                    .of_picture = &y4m_picture,
                                    .part = &y4m_part,
                                    .least_fps = 100.0 / 65535,
                                    .most_fps = 100.0 / kLeastDelay,
                                    .by_ffmpeg = kArguments};

}  // namespace flatray::gif_format
