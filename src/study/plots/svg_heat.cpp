#include "study/plots/svg_heat.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/plots/svg_text.h"

namespace flatray {
namespace {

constexpr double kLeft = 80, kTop = 40, kSide = 420, kBottom = 56, kRight = 110;
constexpr int kTicks = 4;

// By the fourth root, so that small shares are not pale.
std::string colour(double share) {
  if (share <= 0) return "#fff";
  const double deep = std::sqrt(std::sqrt(std::min(share, 1.0)));
  const auto part = [&](double from, double to) {
    return static_cast<int>(std::lround(from + deep * (to - from)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", part(255, 120), part(230, 0), part(150, 20));
}

std::string label(double x, double y, const std::string& words, const char* anchor) {
  return fmt::format("<text x=\"{}\" y=\"{}\" dy=\"0.35em\" text-anchor=\"{}\">{}</text>\n",
                     svg_number(x), svg_number(y), anchor, svg_text(words));
}

std::string cells(const HeatMap& map) {
  std::string text = "<g shape-rendering=\"crispEdges\">\n";  // no seams
  const double width = kSide / static_cast<double>(map.x.size());
  const double height = kSide / static_cast<double>(map.y.size());
  for (std::size_t row = 0; row < map.y.size(); ++row)
    for (std::size_t column = 0; column < map.x.size(); ++column) {
      const double share = map.shares[row * map.x.size() + column];
      if (share <= 0) continue;
      const double x = kLeft + width * static_cast<double>(column);
      const double y = kTop + kSide - height * static_cast<double>(row + 1);
      text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                          svg_number(x), svg_number(y), svg_number(width), svg_number(height),
                          colour(share));
    }
  return text + "</g>\n";
}

// Numbers at the middles of some cells, the first and the last among them.
std::string ticks(const HeatMap& map) {
  std::string text;
  for (int k = 0; k <= kTicks; ++k) {
    const auto at = [&](const std::vector<double>& places) {
      return (places.size() - 1) * static_cast<std::size_t>(k) / kTicks;
    };
    const auto middle = [&](const std::vector<double>& places) {
      return kSide * (static_cast<double>(at(places)) + 0.5) / static_cast<double>(places.size());
    };
    text += label(kLeft + middle(map.x), kTop + kSide + 16, fmt::format("{:g}", map.x[at(map.x)]),
                  "middle");
    text += label(kLeft - 9, kTop + kSide - middle(map.y), fmt::format("{:g}", map.y[at(map.y)]),
                  "end");
  }
  return text;
}

std::string legend() {
  std::string text;
  double y = kTop + 8;
  for (const double share : {1.0, 0.5, 0.1, 0.01, 0.0}) {
    const double x = kLeft + kSide + 16;
    text += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"16\" height=\"16\" fill=\"{}\" stroke=\"#444\"/>\n",
        svg_number(x), svg_number(y - 8), colour(share));
    text += label(x + 24, y, fmt::format("{:g} %", 100 * share), "start");
    y += 22;
  }
  return text;
}

}  // namespace

std::string svg(const HeatMap& map) {
  const double width = kLeft + kSide + kRight, height = kTop + kSide + kBottom;
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height);
  text += cells(map);
  text += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#444\"/>\n", kLeft,
      kTop, kSide, kSide);
  text += ticks(map) + legend();
  text += label(kLeft + kSide / 2, kTop / 2, map.title, "middle");
  text += label(kLeft + kSide / 2, height - 12, map.x_label, "middle");
  text += fmt::format(
      "<text transform=\"translate(20 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      svg_number(kTop + kSide / 2), svg_text(map.y_label));
  return text + "</svg>\n";
}

}  // namespace flatray
