// A picture in memory: a scene as text in, pixels out, written as a PPM by hand and as a PNG by the
// library. Prints the size and one pixel. The box covers the left half of the picture exactly, so
// that the pixels beside its edge are pure red and pure white.
#include <flatray/picture.h>

#include <cstdio>
#include <string_view>

namespace fr = flatray::api;

constexpr std::string_view kScene = R"(
flatray = 1
film = { size = [64, 32], world = [[0, 0], [64, 32]], background = "#ffffff" }
[[entity]]
name = "left half"
shape = { box = { min = [0, 0], max = [32, 32] } }
fill = "#ff0000"
)";

void write(const char* file, const char* head, std::span<const std::uint8_t> bytes) {
  if (std::FILE* out = std::fopen(file, "wb")) {
    std::fputs(head, out);
    std::fwrite(bytes.data(), 1, bytes.size(), out);
    std::fclose(out);
  }
}

int main() {
  fr::Picture picture;
  if (!picture.draw("scene.toml", kScene)) {
    const std::string_view why = picture.messages();
    std::fwrite(why.data(), 1, why.size(), stderr);
    return 1;
  }
  write("picture.ppm", "P6 64 32 255\n", picture.pixels());
  write("picture.png", "", picture.png());

  const auto is = [&](int column, std::uint8_t red, std::uint8_t green) {
    const std::uint8_t* pixel = picture.pixels().data() + 3 * (16 * picture.width() + column);
    std::printf("pixel (%d, 16) is %d %d %d\n", column, pixel[0], pixel[1], pixel[2]);
    return pixel[0] == red && pixel[1] == green && pixel[2] == green;
  };
  return picture.width() == 64 && picture.height() == 32 && picture.channels() == 3 &&
                 is(31, 255, 0) && is(32, 255, 255)
             ? 0
             : 1;
}
