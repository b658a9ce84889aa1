// needs: shapes/arc shapes/box shapes/capsule shapes/circle shapes/lens shapes/mushroom shapes/ngon shapes/polygon shapes/sector lamps/beam lamps/point lamps/ray materials/glass materials/mix passes/light passes/entities formats/toml
// Light that fades in glass, light of spectra, and light that goes by the place on a wall.
#include <fmt/core.h>

#include <cmath>

#include "anim/world.h"
#include "oracle/families.h"
#include "render/lit.h"
#include "transport/light/bodies.h"

namespace flatray {
namespace {

// A body 2 units long in the way of a beam that it neither bends nor reflects: of each channel
// exp(-2 a) is left behind it, and (1 - exp(-2 a)) / a falls on the film in it.
TEST(TintedLight, FadesByBeerAndLambert) {
  const double absorption[] = {0.7, 40, 1e-3};
  for (const char* at : {"[-3.5, 0]", "[-1.5, 0]"}) {  // before the body; the beam begins in it
    const bool inside = at[1] == '-' && at[2] == '1';
    const Fluence made =
        fluence(lit("[[lamp]]\nsource = { beam = { width = 1 } }\nat = " + std::string(at) +
                        "\n[[entity]]\nshape = { box = { min = [-2, -2], max = [0.5, 2] } }\n"
                        "material = { glass = { index = 1, absorption = [0.7, 40, 1e-3] } }\n",
                    "rays = 4096"));
    EXPECT_EQ(made.counts.emitted, accounted(made.counts));
    EXPECT_GT(made.counts.absorbed, 0);
    const double length = inside ? 2 : 2.5;
    for (int c = 0; c < 3; ++c) {
      double within = 0, behind = 0;
      for (int y = 0; y < 64; ++y)
        for (int x = 16; x < 64; ++x) (x < 36 ? within : behind) += made.at(x, y, c) / 64;
      const double a = absorption[c], left = std::exp(-a * length);
      const double error = c == 1 ? 1e-3 : 3e-5;  // within a fifth of a pixel
      EXPECT_NEAR(within * a / (1 - left), 1, error) << at << c;
      EXPECT_NEAR(behind / 3.5, left, 1e-5) << at << c;
    }
  }
}

// Bodies of arcs and of straight walls, that neither bend nor reflect: what is left of a ray is
// exp(-length in them / 4), whether it comes from outside, from within, or from a hollow of them.
TEST(TintedLight, FadesInWhatArcsEnclose) {
  struct Case {
    const char* shape;
    double from, y, length;  // from where the ray goes to the right
  };
  const double root = std::sqrt(1 - 0.25), ring = std::sqrt(4 - 0.25) - root;
  const Case cases[] = {
      {"capsule = { from = [-1, 0], to = [1, 0], radius = 1 }", -3.5, 0.5, 2 + 2 * root},
      {"capsule = { from = [-1, 0], to = [1, 0], radius = 1 }", 0.25, 0.5, 0.75 + root},
      {"capsule = { from = [-1, 0], to = [1, 0], radius = 1 }", -1, 0, 3},
      {"sector = { radius = 2, inner = 1, from = 10, to = 350 }", -3.5, 0.5, 2 * ring},
      {"sector = { radius = 2, inner = 1, from = 10, to = 350 }", 0, 0.5, ring},
      {"sector = { radius = 2, inner = 1, from = 10, to = 350 }", -1.5, 0.5, 1.5 - root + ring},
      {"sector = { radius = 2, from = 90, to = 360 }", 0.25, 0.5, 0},
      {"sector = { radius = 2, from = 90, to = 360 }", -0.25, 0.5, 0.25},
      {"sector = { radius = 2, from = 90, to = 360 }", -0.25, -0.5, 0.25 + std::sqrt(4 - 0.25)},
      {"arc = { radius = 2, from = 270, to = 90, chord = true }", -1, 0, 2},
      {"lens = { height = 2, thickness = 0.5, radii = [-1, -1] }", -3.5, 0.5, 2.5 - 2 * root},
      {"lens = { height = 2, thickness = 0.5, radii = [-1, -1] }", 0, 0.5, 1.25 - root},
      {"mushroom = { radius = 2, width = 1, height = 1.5 }", -3.5, -0.75, 1},
      {"mushroom = { radius = 2, width = 1, height = 1.5 }", 0.25, 0.5, std::sqrt(3.75) - 0.25},
      {"mushroom = { radius = 2, width = 1, height = 1.5 }", 1, -0.25, 0},
  };
  for (const Case& one : cases) {
    const Fluence made =
        fluence(lit("[[lamp]]\nsource = { ray = {} }\nat = [" + std::to_string(one.from) + ", " +
                        std::to_string(one.y) + "]\n[[entity]]\nshape = { " + one.shape +
                        " }\nmaterial = { glass = { index = 1, absorption = 0.25 } }\n",
                    "rays = 4096"));
    double behind = 0;
    for (int y = 0; y < 64; ++y) behind += made.at(60, y);
    EXPECT_NEAR(behind / 8, std::exp(-0.25 * one.length), 3e-5)
        << one.shape << one.from << ' ' << one.y;
  }
}

// A column has the mean of exp(-a x) over it, though light is laid on it in pieces.
TEST(TintedLight, FadesEvenlyAlongItsWay) {
  const Fluence made =
      fluence(lit("[[lamp]]\nsource = { beam = { width = 1 } }\nat = [-3.5, 0]\n"
                  "[[entity]]\nshape = { box = { min = [-2, -2], max = [2, 2] } }\n"
                  "material = { glass = { index = 1, absorption = 1.5 } }\n"));
  for (int x = 16; x < 48; ++x) {
    const double left = std::exp(-1.5 * (x - 16) / 8.0);
    EXPECT_NEAR(made.at(x, 32) / (left * (1 - std::exp(-1.5 / 8)) / (1.5 / 8)), 1, 0.001) << x;
  }
}

// Also where many pixels lie in a piece of 16 to the depth.
TEST(TintedLight, HasNoStepsWherePixelsAreSmall) {
  const Fluence made =
      fluence(lit("[[lamp]]\nsource = { beam = { width = 1 } }\nat = [-3.5, 0]\n"
                  "[[entity]]\nshape = { box = { min = [-2, -2], max = [2, 2] } }\n"
                  "material = { glass = { index = 1, absorption = 0.1 } }\n"));
  for (int x = 16; x < 48; ++x)
    EXPECT_NEAR(made.at(x, 32) / std::exp(-0.1 * (x + 0.5 - 16) / 8.0), 1, 0.002) << x;
}

// The innermost body absorbs: a bubble nothing, what lies in two the inner one's part.
TEST(TintedLight, FadesInTheInnermostBody) {
  const auto behind = [](const char* inner) {
    const Fluence made =
        fluence(lit("[[lamp]]\nsource = { beam = { width = 0.5 } }\nat = [-3.5, 0]\n"
                    "[[entity]]\nshape = { box = { min = [-2, -2], max = [2, 2] } }\n"
                    "material = { glass = { index = 1, absorption = 0.1 } }\n"
                    "[[entity]]\nshape = { box = { min = [-1, -1], max = [1, 1] } }\n"
                    "material = { glass = { index = 1, absorption = " +
                    std::string(inner) + " } }\n"));
    return made.at(60, 32);
  };
  EXPECT_NEAR(behind("0") / behind("0.1"), std::exp(0.2), 1e-4);
  EXPECT_NEAR(behind("0.4") / behind("0.1"), std::exp(-0.6), 1e-4);
}

// Two lines are seen where lamps of those wavelengths are, and nowhere between, with the colour of both.
TEST(TintedLight, OfASpectrumIsTakenApartIntoItsLines) {
  const auto prism = [](double nm, std::span<const Spectrum::Row> rows, const char* dispersion) {
    Scene scene =
        lit("[[lamp]]\nsource = { beam = { width = 0.02 } }\nat = [-3.5, -1]\nangle = 15\n"
            "nm = " +
            std::to_string(nm) +
            "\n[[entity]]\nshape = { ngon = { sides = 3, radius = 1.5 } }\n"
            "material = { glass = { dispersion = " +
            std::string(dispersion) + " } }\n");
    if (!rows.empty()) {
      scene.lamps[0].wavelength.reset();
      scene.lamps[0].spectrum = std::make_shared<const Spectrum>(rows);
    }
    return fluence(scene);
  };
  const Spectrum::Row rows[] = {{449.9, 0}, {450, 1}, {450.1, 0}, {639.9, 0}, {640, 2}, {640.1, 0}};
  const Fluence both = prism(450, rows, "60000");
  const Fluence blue = prism(450, {}, "60000"), red = prism(640, {}, "60000");
  double seen = 0, elsewhere = 0;
  for (int y = 0; y < 64; ++y) {
    double of_both = 0, of_one = 0;
    for (int c = 0; c < 3; ++c)
      of_both += both.at(60, y, c), of_one += blue.at(60, y, c) + red.at(60, y, c);
    (of_one > 0 ? seen : elsewhere) += of_both;
  }
  EXPECT_GT(seen, 0);
  EXPECT_EQ(elsewhere, 0);
  const Fluence plain = prism(450, rows, "0"), weak = prism(450, rows, "0.001");
  for (int c = 0; c < 3; c += 2) {
    double with = 0, without = 0;
    for (std::size_t i = static_cast<std::size_t>(c); i < plain.rgb.size(); i += 3)
      with += weak.rgb[i], without += plain.rgb[i];
    EXPECT_NEAR(with / without, 1, 0.03) << c;
  }
}

// The first end of a wall is the one that was written first, whichever way a polygon runs round.
TEST(Light, OfAMirrorTurnedAlongItsWallGoesByTheEndsAsWritten) {
  const auto light_of = [](const std::string& shape, const char* turn) {
    return fluence(lit("[[lamp]]\nsource = { point = {} }\nat = [-2.5, 0.3]\n[[" + shape +
                       "\nmaterial = { mix = { mirror = 1, mirror_turn = " + turn + " } }\n"))
        .rgb;
  };
  const auto difference = [](const std::vector<double>& one, const std::vector<double>& other) {
    double all = 0, off = 0;
    for (std::size_t i = 0; i < one.size(); ++i) all += one[i], off += std::abs(one[i] - other[i]);
    return off / all;
  };
  struct Case {
    const char *counter_clockwise, *clockwise;
  };
  const Case cases[] = {
      {"entity]]\nshape = { polygon = { points = [[0, -1], [2, -1], [2, 1], [0, 1]] } }",
       "entity]]\nshape = { polygon = { points = [[0, 1], [2, 1], [2, -1], [0, -1]] } }"},
      {"entity]]\nshape = { polygon = { points = [[-1, -2], [3, 0], [-1, 2], [1, 0]] } }",
       "entity]]\nshape = { polygon = { points = [[1, 0], [-1, 2], [3, 0], [-1, -2]] } }"},
      {"chamber]]\nshape = { polygon = { points = [[-3, -1], [2, -1], [2, 1], [-3, 1]] } }\n"
       "holes = [{ edge = 2, from = 0.25, to = 0.5 }]",
       "chamber]]\nshape = { polygon = { points = [[-3, 1], [2, 1], [2, -1], [-3, -1]] } }\n"
       "holes = [{ edge = 0, from = 0.25, to = 0.5 }]"}};
  for (const auto& [counter_clockwise, clockwise] : cases) {
    const std::vector<double> light = light_of(counter_clockwise, "[5, 30]");
    EXPECT_LE(difference(light_of(clockwise, "[30, 5]"), light), 1e-6) << clockwise;
    EXPECT_GE(difference(light_of(clockwise, "[5, 30]"), light), 1e-2) << clockwise;
  }
}

// By Pythagoras in whole numbers: the smaller disc is the inner one, of equal ones the later, and eight
// are known.
TEST(Bodies, AroundAPointAreTheDiscsThatHoldIt) {
  constexpr std::uint32_t kDiscs = 60, kKnown = 8;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    oracle::Draw draw(seed, 0, 0);
    std::vector<Vec2> centres;
    std::vector<double> radii;
    std::string text;
    for (std::uint32_t i = 0; i < kDiscs; ++i) {
      centres.push_back(draw.whole_point(-20, 21));
      radii.push_back(draw.whole(1, seed % 2 == 0 ? 6 : 16));
      text += fmt::format(
          "[[entity]]\nshape = {{ circle = {{ radius = {} }} }}\nmaterial = {{ glass = {{}} }}\n"
          "at = [{}, {}]\n",
          radii[i], centres[i].x(), centres[i].y());
    }
    const Scene scene = lit(text);
    const World world = build_world(scene, at(Timeline(scene, 0, 1), 1));
    const std::vector<const Scatterer*> scatterers = scatterers_of(scene, world);
    const Bodies bodies(world, scatterers);
    std::size_t most = 0;
    for (int k = 0; k < 500; ++k) {
      const Vec2 point = draw.whole_point(-24, 25);
      std::vector<std::uint32_t> holding;
      for (std::uint32_t i = 0; i < kDiscs; ++i)
        if ((point - centres[i]).squaredNorm() < radii[i] * radii[i]) holding.push_back(i);
      std::ranges::stable_sort(holding, std::ranges::greater(),
                               [&](std::uint32_t i) { return radii[i]; });
      most = std::max(most, holding.size());
      Media media = bodies.around(point);
      EXPECT_EQ(media.forgets(), holding.size() > kKnown);
      for (std::uint32_t i = 0; i < kKnown && !holding.empty(); ++i, holding.pop_back()) {
        ASSERT_EQ(media.around(Media::kNone), bodies.of(holding.back())) << seed << ' ' << k;
        media.leave(bodies.of(holding.back()));
      }
      EXPECT_EQ(media.around(Media::kNone), Media::kNone) << seed << ' ' << k;
    }
    EXPECT_EQ(most > kKnown, seed % 2 == 1);
  }
}

TEST(Fading, IsExpAndItsMeanForDepthsOfAnySize) {
  for (double depth = 1e-18; depth < 600; depth *= 1.07) {
    const Fading made = fading(depth / 8, 8);
    EXPECT_NEAR(made.left / std::exp(-depth), 1, 1e-12) << depth;
    EXPECT_NEAR(made.mean / (-std::expm1(-depth) / depth), 1, 1e-12) << depth;
  }
  EXPECT_EQ(fading(0, 1e300).left, 1);
  EXPECT_EQ(fading(0, 1e300).mean, 1);
  EXPECT_EQ(fading(1e30, 1e300).left, 0);
  EXPECT_EQ(fading(1e30, 1e300).mean, 0);
}

}  // namespace
}  // namespace flatray
