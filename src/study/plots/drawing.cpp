#include "study/plots/drawing.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/shown_text.h"
#include "image/png.h"

namespace flatray {
namespace {

struct Ink {
  const char *name, *light, *dark;
};
constexpr std::array kInks = {
    Ink{"text", "#1a1a1a", "#eeeeee"}, Ink{"axis", "#595959", "#a6a6a6"},
    Ink{"grid", "#e2e2e2", "#33373d"}, Ink{"paper", "#ffffff", "#16181c"},
    // Okabe and Ito, Color Universal Design, 2008; their black is the text's. On white their orange
    // and light blue are too pale: one is a brown there, the other the first blue on dark paper, and
    // a violet its place.
    Ink{"blue", "#0072b2", "#56b4e9"}, Ink{"vermillion", "#d55e00", "#d55e00"},
    Ink{"green", "#009e73", "#009e73"}, Ink{"purple", "#cc79a7", "#cc79a7"},
    Ink{"brown", "#7a3e00", "#e69f00"}, Ink{"violet", "#7a3ce0", "#9a6cff"}};
constexpr std::array kSeries = {"blue", "vermillion", "green", "purple", "brown", "violet", "text"};

constexpr double kFontSize = 13, kLetterWidth = 7.8;

// Two digits after the point, never "-0.00".
std::string svg_number(double x) { return fmt::format("{:.2f}", std::round(x * 100) / 100 + 0.0); }

// Of both themes. A class for each use of an ink, as not every reader of SVG knows variables.
std::string style() {
  const auto rules = [](bool dark) {
    std::string text;
    for (const Ink& ink : kInks)
      text += fmt::format(".s-{0}{{stroke:{1}}}.f-{0}{{fill:{1}}}", ink.name,
                          dark ? ink.dark : ink.light);
    return text;
  };
  return fmt::format(
      "<style>text{{paint-order:stroke;stroke-width:3px;stroke-linejoin:round}}{}"
      "@media(prefers-color-scheme:dark){{{}}}</style>\n",
      rules(false), rules(true));
}

// Attributes of a pen; elements without a fill have none.
std::string painted(const Pen& pen) {
  std::string classes, text;
  for (const auto& [ink, letter, name] :
       {std::tuple(pen.stroke, 's', "stroke"), std::tuple(pen.fill, 'f', "fill")}) {
    if (ink.empty()) continue;
    if (ink.front() == '#')
      text += fmt::format(" {}=\"{}\"", name, ink);
    else
      classes += fmt::format("{}{}-{}", classes.empty() ? "" : " ", letter, ink);
  }
  if (!classes.empty()) text += fmt::format(" class=\"{}\"", classes);
  if (pen.width != 1) text += fmt::format(" stroke-width=\"{:g}\"", pen.width);
  std::string dashes;
  for (const double length : dashes_of(pen)) dashes += fmt::format(" {:g}", length);
  if (!dashes.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", dashes.substr(1));
  return text;
}

std::string element(const Drawing::Path& path) {
  std::string way;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const char* letter = i == 0                    ? "M"
                         : !path.bezier            ? "L"
                         : i > 1                   ? " "
                         : path.points.size() == 3 ? "Q"
                                                   : "C";
    way += letter + svg_number(path.points[i].x()) + " " + svg_number(path.points[i].y());
  }
  const std::string start =
      fmt::format("<path d=\"{}{}\"{}", way, path.closed ? "Z" : "", painted(path.pen));
  return path.title.empty()
             ? start + "/>\n"
             : fmt::format("{}><title>{}</title></path>\n", start, svg_text(path.title));
}

std::string element(const Drawing::Disc& disc) {
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{:g}\"{}/>\n", svg_number(disc.centre.x()),
                     svg_number(disc.centre.y()), disc.radius, painted(disc.pen));
}

std::string element(const Drawing::Words& words) {
  const std::string x = svg_number(words.at.x()), y = svg_number(words.at.y());
  return fmt::format("<text x=\"{}\" y=\"{}\" dy=\"0.35em\"{}{}{}{}>{}</text>\n", x, y,
                     words.anchor == 0   ? ""
                     : words.anchor == 1 ? " text-anchor=\"end\""
                                         : " text-anchor=\"middle\"",
                     words.upright ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "",
                     words.bold ? " font-weight=\"bold\"" : "", painted({"paper", words.ink}),
                     svg_text(words.words));
}

std::string element(const Drawing::Picture& picture) {
  return fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "style=\"image-rendering:pixelated\" href=\"{}\"/>\n",
      svg_number(picture.corner.x()), svg_number(picture.corner.y()), svg_number(picture.size.x()),
      svg_number(picture.size.y()), data_address(picture.image));
}

}  // namespace

std::string series_ink(std::size_t n) { return kSeries[n % kSeries.size()]; }

std::string ink_colour(const std::string& ink, bool dark) {
  for (const Ink& one : kInks)
    if (ink == one.name) return dark ? one.dark : one.light;
  return ink;
}

std::vector<double> dashes_of(const Pen& pen) {
  static const std::array<std::vector<double>, 5> kDashes = {
      {{}, {7, 3}, {2, 2}, {9, 3, 2, 3}, {4, 6}}};
  return kDashes[pen.dash % kDashes.size()];
}

double words_width(const std::string& words) {
  const auto letters = std::ranges::count_if(
      words, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return kLetterWidth * static_cast<double>(letters);
}

std::string svg(const Drawing& drawing) {
  const std::string width = svg_number(drawing.size.x()), height = svg_number(drawing.size.y());
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" style=\"max-width:100%;height:auto;color-scheme:light dark\" "
      "font-family=\"sans-serif\" font-size=\"{2:g}\" "
      "fill=\"none\">\n<title>{3}</title>\n{4}"
      "<rect width=\"100%\" height=\"100%\" class=\"f-paper\"/>\n",
      width, height, kFontSize, svg_text(drawing.title), style());
  for (const auto& mark : drawing.marks)
    text += std::visit([](const auto& one) { return element(one); }, mark);
  return text + "</svg>\n";
}

// RFC 4648.
std::string data_address(const Image& image) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::vector<std::byte> bytes = encode_png(image);
  std::string text = "data:image/png;base64,";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      group = group << 8U | (k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
  }
  return text;
}

std::string svg_text(const std::string& text) {
  struct Special {
    char letter;
    const char* reference;
  };
  static constexpr Special kSpecial[] = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string safe, shown = with_stray_bytes_shown(text);
  for (const char* not_in_xml : {"\xef\xbf\xbe", "\xef\xbf\xbf"})  // U+FFFE, U+FFFF
    for (std::size_t at; (at = shown.find(not_in_xml)) != std::string::npos;)
      shown.replace(at, 3, "?");
  for (const char c : shown) {
    const auto special = std::ranges::find(kSpecial, c, &Special::letter);
    if (special != std::end(kSpecial))
      safe += special->reference;
    else
      safe += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  }
  return safe;
}

}  // namespace flatray
