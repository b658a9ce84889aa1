// needs: lamps/point formats/toml
// Colours of light; spectra of files: what is read, what is told, and the colours they have.
#include "scene/reading/spectrum_text.h"

#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "base/number_text.h"
#include "scene/scene_text.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

Result<Spectrum> parse(const std::string& text) {
  return parse_spectrum(std::make_shared<const SourceText>("s.csv", text));
}

LightColour colour(const std::string& text) {
  const auto spectrum = parse(text);
  FLATRAY_CHECK(spectrum.has_value(), spectrum ? "" : format(spectrum.error()));
  return spectrum->colour();
}

void expect_near(const LightColour& a, const LightColour& b, double error) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], error) << c;
}

// X = Y = Z, seen as sRGB: its matrix's sums of rows.
TEST(SpectrumText, OfEqualEnergyIsThatWhite) {
  const double red = 3.2406 - 1.5372 - 0.4986;
  expect_near(colour("380,1\n780,1\n"),
              {1, (-0.9689 + 1.8758 + 0.0415) / red, (0.0557 - 0.2040 + 1.0570) / red}, 1e-3);
}

TEST(SpectrumText, OfALineIsThatOfItsWavelength) {
  for (const double nm : {404.7, 435.8, 480.0, 520.0, 546.1, 589.3, 632.8, 670.8, 700.0, 766.5})
    expect_near(colour(number_text(nm - 0.1) + " 0\n" + number_text(nm) + " 5\n" +
                       number_text(nm + 0.1) + " 0\n"),
                colour_of_wavelength(nm), 1e-3);
}

TEST(SpectrumText, OfPlancksLawIsThatOfTheTemperature) {
  constexpr double kSecond_nm = 1.438776877e7;
  for (const double kelvin : {2000.0, 2856.0, 6500.0, 12000.0}) {
    std::string rows;
    for (double nm = 360; nm <= 830; nm += 5)
      rows += number_text(nm) + ';' +
              number_text(std::pow(nm / 560, -5) / std::expm1(kSecond_nm / (nm * kelvin))) + '\n';
    expect_near(colour(rows), colour_of_temperature(kelvin), 1e-3);
  }
}

// The CIE's table at single wavelengths, and its illuminant A: x = 0.4476, y = 0.4074.
TEST(SpectrumText, HasTheEyeOfTheStandardObserver) {
  EXPECT_EQ(luminance_of_wavelength(555), 1);
  EXPECT_EQ(luminance_of_wavelength(510), 0.503);
  EXPECT_EQ(luminance_of_wavelength(700), 0.004102);
  EXPECT_EQ(luminance_of_wavelength(359), 0);
  EXPECT_EQ(luminance_of_wavelength(831), 0);
  expect_near(colour_of_wavelength(700), {1, 0, 0.0919}, 1e-4);
  expect_near(colour_of_temperature(2856), {1, 0.4478, 0.1264}, 1e-3);
}

TEST(SpectrumText, TakesWhatInstrumentsWrite) {
  const LightColour plain = colour("400,0\n500,1\n600,0.5\n");
  for (const char* same : {"\xef\xbb\xbfWavelength (nm),Power\r\n400,0\r\n500,1\r\n600,0.5\r\n",
                           "# of a lamp\n\nnm;power\n400;0 # begins\n500; 1\n600 ;0.5",
                           "400\t0\n500\t1\n600\t5e-1\n", "  400   0\n500 1.0\n +600    0.5  \n",
                           "nm power\n400 0\n500 1\n600 .5", "400,0\n500,1e-200\n600,0.5e-200\n",
                           "300,0\n400,0\n500,2\n600,1\n600.0000000001,0\n900,0"}) {
    const auto spectrum = parse(same);
    ASSERT_TRUE(spectrum) << same << format(spectrum.error());
    expect_near(spectrum->colour(), plain, 1e-12);
  }
}

// Found by a reviewer: a first row that is misprinted is no row of names.
TEST(SpectrumText, RefusesAFirstRowThatBeginsANumber) {
  const auto refused = parse("40O,5\n500,1\n600,1\n");
  ASSERT_FALSE(refused);
  EXPECT_NE(format(refused.error()).find("'40O' is not a finite number"), std::string::npos);
}

// Chances, places in cells and colours together give the whole again, of all wavelengths alike.
TEST(SpectrumText, IsWholeAgainWhenItsPartsAreAddedUp) {
  const auto spectrum = parse("400,0\n436,1\n440,0\n545,0\n546,3\n547,0\n700,0.1\n");
  constexpr int kSteps = 200'000;
  LightColour sum{0, 0, 0};
  double last = 0;
  int line = 0;
  for (int i = 0; i < kSteps; ++i) {
    const auto [nm, part] = spectrum->part((i + 0.5) / kSteps);
    EXPECT_GE(nm, last);
    last = nm;
    line += nm >= 545 && nm <= 547;
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += part[c] / kSteps;
      EXPECT_LE(part[c], 3);
      EXPECT_GE(part[c], 0);
    }
  }
  EXPECT_LE(last, 700);
  EXPECT_GT(line, 0);
  expect_near(sum, {1, 1, 1}, 1e-4);
}

TEST(SpectrumText, SaysWhatIsWrong) {
  const Refused cases[] = {
      {"", "s.csv: error: a spectrum has two rows at least"},
      {"500, 1\n", "a spectrum has two rows at least"},
      {"nm, power\nnm, power\n500, 1\n", "s.csv:2:1: error: 'nm' is not a finite number"},
      {"400, 1\n500, 1e999\n", "s.csv:2:6: error: '1e999' is not a finite number"},
      {"400, 1\n500, nan\n", "'nan' is not a finite number"},
      {"400, 1\n500,\n", "s.csv:2:1: error: '' is not a finite number"},
      {"400,5; 1\n500; 1\n", "s.csv:1:1: error: a row has 3 columns, not a wavelength and a power"},
      {"400\n500\n", "s.csv:1:1: error: a row has 1 column"},
      {"400, 1\n500, 1\n500, 2\n", "s.csv:3:1: error: wavelength 500 does not lie above 500"},
      {"700, 1\n400, 1\n", "s.csv:2:1: error: wavelength 400 does not lie above 700"},
      {"-400, 1\n500, 1\n", "s.csv:1:1: error: wavelength -400 is not above 0"},
      {"400, 1\n500, -0.5\n", "s.csv:2:6: error: power -0.5 is below 0"},
      {"0.4, 1\n0.7, 1\n", "s.csv:1:1: error: the spectrum has no light between 380 and 780 nm"},
      {"300, 1\n380, 0\n780, 0\n", "no light between 380 and 780 nm"},
  };
  expect_refused(cases, [](const std::string& text) {
    const auto spectrum = parse(text);
    return spectrum ? "" : format(spectrum.error());
  });
  std::string wrong, long_one;
  for (int i = 0; i < 30; ++i) wrong += "x y z\n";
  EXPECT_EQ(parse("1 1\n" + wrong).error().size(), 20U);
  for (std::size_t i = 0; i <= kMostSpectrumRows; ++i)
    long_one += number_text(300 + static_cast<double>(i) / 256) + " 1\n";
  EXPECT_NE(format(parse(long_one).error()).find("more than 100000 rows"), std::string::npos);
}

using LampSpectrum = OwnFolder;

TEST_F(LampSpectrum, IsOfAFileBesideTheScene) {
  ASSERT_TRUE(write_file(folder_ / "l.csv", "500 0\n550 1\n600 0\n"));
  const auto load = [&](const std::string& keys) {
    return load_scene_text((folder_ / "s.toml").string(),
                           "flatray = 1\n[[lamp]]\nsource = { point = {} }\n" + keys);
  };
  const auto scene =
      load("spectrum = 'l.csv'\nrepeat = { grid = { count = [2, 1], step = [1, 1] } }");
  ASSERT_TRUE(scene) << format(scene.error());
  EXPECT_TRUE(scene->warnings.empty());
  ASSERT_EQ(scene->scene.lamps.size(), 2U);
  EXPECT_EQ(scene->scene.lamps[0].spectrum, scene->scene.lamps[1].spectrum);
  EXPECT_EQ(scene->scene.lamps[0].spectrum->colour(), colour("500 0\n550 1\n600 0\n"));
  const auto told = [&](const std::string& keys) { return format(load(keys).error()); };
  EXPECT_NE(told("spectrum = 'none.csv'").find("4:12: error: file 'none.csv': cannot read"),
            std::string::npos);
  EXPECT_EQ(load("spectrum = 'none.csv'").error()[0].trouble, Trouble::missing);
  EXPECT_NE(told("spectrum = 5").find("4:12: error: lamp.spectrum"), std::string::npos);
  EXPECT_NE(told("spectrum = 'l.csv'\nkelvin = 3000").find("a lamp has kelvin and spectrum"),
            std::string::npos);
  ASSERT_TRUE(write_file(folder_ / "l.csv", "500 0\n550 x\n600 0\n"));
  EXPECT_NE(told("spectrum = 'l.csv'").find("l.csv:2:5: error: 'x' is not a finite number"),
            std::string::npos);
  ASSERT_TRUE(write_file(folder_ / "l.csv", "500 0\n550 1\n601 0\n"));
  EXPECT_NE(load("spectrum = 'l.csv'")->scene.hash, scene->scene.hash);
}

TEST_F(LampSpectrum, CountsToTheBytesOfAScene) {
  ASSERT_TRUE(write_file(folder_ / "l.csv", std::string(5000, '#')));
  LoadLimits limits;
  limits.max_bytes = 1000;
  const auto scene = load_scene_text((folder_ / "s.toml").string(),
                                     "flatray = 1\n[[lamp]]\nsource = { point = {} }\n"
                                     "spectrum = 'l.csv'\n",
                                     {}, limits);
  ASSERT_FALSE(scene);
  EXPECT_NE(format(scene.error()).find("--max-bytes raises it"), std::string::npos)
      << format(scene.error());
}

TEST(Spectrum, HasTheColoursOfWavelengthsAndTemperatures) {
  const auto brightest = [](const LightColour& c) {
    return std::max_element(c.begin(), c.end()) - c.begin();
  };
  EXPECT_EQ(brightest(colour_of_wavelength(650)), 0);
  EXPECT_EQ(brightest(colour_of_wavelength(530)), 1);
  EXPECT_EQ(brightest(colour_of_wavelength(450)), 2);
  for (double nm = 380; nm <= 780; nm += 1) {
    const LightColour c = colour_of_wavelength(nm);
    EXPECT_EQ(*std::max_element(c.begin(), c.end()), 1) << nm;
    EXPECT_GE(*std::min_element(c.begin(), c.end()), 0) << nm;
  }
  EXPECT_EQ(colour_of_wavelength(200), (LightColour{0, 0, 0}));
  // By chromaticities of the CIE's table of 1931: (0.1741, 0.0050) at 380 nm, (0.7347, 0.2653) from 700 nm on.
  for (const double nm : {380.0, 390.0, 400.0, 410.0})
    expect_near(colour_of_wavelength(nm), {0.270, 0, 1}, 0.03);
  for (const double nm : {660.0, 680.0, 700.0, 740.0, 780.0})
    expect_near(colour_of_wavelength(nm), {1, 0, 0.091}, 0.03);
  for (const double channel : colour_of_temperature(6500)) EXPECT_NEAR(channel, 1, 0.1);
  EXPECT_LT(colour_of_temperature(2000)[2], 0.1);
  EXPECT_LT(colour_of_temperature(20000)[0], 0.6);
}

// The eye's curve has its peak, 1, at 555 nm; of a blackbody's light most is seen near 6640 K: 96 of 683
// lumens a watt.
TEST(Spectrum, KnowsHowBrightLightIs) {
  EXPECT_NEAR(luminance_of_wavelength(555), 1, 0.02);
  EXPECT_LT(luminance_of_wavelength(400), 0.01);
  EXPECT_NEAR(luminance_of_temperature(6640), 96.0 / 683, 0.003);
  EXPECT_GT(luminance_of_temperature(6640), luminance_of_temperature(6000));
  EXPECT_GT(luminance_of_temperature(6640), luminance_of_temperature(7300));
  EXPECT_LT(luminance_of_temperature(1000), 1e-4);
  EXPECT_NEAR(luminance({1, 1, 1}), 1, 1e-12);
}

TEST(Spectrum, IsWhiteAgainWhenItsPartsAreAddedUp) {
  LightColour sum{0, 0, 0};
  constexpr int kSteps = 100'000;
  for (int i = 0; i < kSteps; ++i) {
    const double nm = kFirstWavelength + (i + 0.5) / kSteps * (kLastWavelength - kFirstWavelength);
    const LightColour part = part_of_wavelength(nm);
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += part[c] / kSteps;
      EXPECT_LE(part[c], kMostOfWavelength);
      EXPECT_GE(part[c], 0);
    }
  }
  for (const double channel : sum) EXPECT_NEAR(channel, 1, 1e-4);
}

}  // namespace
}  // namespace flatray
