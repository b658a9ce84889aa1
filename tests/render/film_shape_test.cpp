// needs: formats/toml shapes/sector
#include "support/pictures.h"

namespace flatray {
namespace {

// The middle of the ring lies 30 px right of the centre, where a seam at 0 degrees would be.
TEST(FilmShape, AWholeSectorHasNoSeam) {
  for (const char* inner : {"20", "0"}) {
    const Image image =
        picture(std::string("flatray = 1\n"
                            "film = { size = [101, 101], world = [[-50.5, -50.5], [50.5, 50.5]] }\n"
                            "[[entity]]\nfill = \"#336699\"\n"
                            "stroke = { width = 4, colour = \"#ff0000\" }\n"
                            "shape = { sector = { radius = 40, from = 0, to = 360, inner = ") +
                inner + " } }\n");
    const std::size_t pixel = (50 * 101 + 80) * 3;
    EXPECT_EQ(image.pixels[pixel], 0x33) << inner;
    EXPECT_EQ(image.pixels[pixel + 3 * 10], 0xff) << inner;
  }
}

}  // namespace
}  // namespace flatray
