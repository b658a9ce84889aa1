#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/portable_math.h"
#include "study/plots/plot.h"
#include "study/plots/plot_axes.h"

namespace flatray {
namespace {

constexpr double kPixels = 1000;  // of the longer side of a picture
constexpr int kSteps = 256;       // of a bar

// By the fourth root, so that small shares are not pale.
std::array<std::uint8_t, 3> share_colour(double share) {
  if (share <= 0) return {255, 255, 255};
  const double deep = std::sqrt(std::sqrt(std::min(share, 1.0)));
  const auto part = [&](double from, double to) {
    return static_cast<std::uint8_t>(std::lround(from + deep * (to - from)));
  };
  return {part(255, 120), part(230, 0), part(150, 20)};
}

// The bounds of pixels whose middles are evenly apart.
Range edges(const std::vector<double>& middles) {
  const double half = middles.size() < 2 ? 0.5 : 0.5 * (middles[1] - middles[0]);
  return {middles.front() - half, middles.back() + half};
}

}  // namespace

double log_share(double number, double most) {
  return most > 0 ? portable::log(1 + number) / portable::log(1 + most) : 0;
}

Plot::Bar bar_of(std::string label, double most, const std::function<Light(double)>& colour,
                 const std::function<double(double)>& part_of) {
  Plot::Bar bar{std::move(label), Image(1, kSteps, 3), {}};
  for (int i = 0; i < kSteps; ++i)
    set_pixel(bar.strip, 0, kSteps - 1 - i, colour(i / (kSteps - 1.0)));
  std::vector<double> numbers{0};
  const bool counts = part_of && most == std::floor(most);  // which have no parts
  for (const Tick& tick :
       part_of ? log_ticks(log10_of(most) - 3, log10_of(most), 9) : ticks(0, most, 6)) {
    const double number = part_of ? portable::pow(10, tick.at) : tick.at;
    if (!counts || number > 0.999) numbers.push_back(number);
  }
  numbers.push_back(most);
  // Both ends, and between them those that have room.
  constexpr double kRoom = 0.07;
  double last = -1;
  for (const double number : numbers) {
    const double part = number == most ? 1 : part_of ? part_of(number) : number / most;
    if (part < 1 && (part - last < kRoom || part > 1 - kRoom)) continue;
    bar.ticks.emplace_back(part, tick_words(number, 4));
    last = part;
  }
  return bar;
}

std::string map_csv(const Plot& plot, const std::function<std::string(std::size_t)>& cell) {
  const auto& [image, bounds] = *plot.map;
  const Vec2 step(bounds.size().x() / image.width, bounds.size().y() / image.height);
  std::string text = "y";
  for (int x = 0; x < image.width; ++x)
    text += "," + number_text(bounds.low.x() + (x + 0.5) * step.x());
  std::size_t i = 0;
  for (int y = 0; y < image.height; ++y) {
    text += "\n" + number_text(bounds.high.y() - (y + 0.5) * step.y());
    for (int x = 0; x < image.width; ++x) text += "," + cell(i++);
  }
  return text + "\n";
}

Plot plot_of(const HeatMap& map) {
  Plot plot{map.title, map.x_label, map.y_label, {}};
  const Range x = edges(map.x), y = edges(map.y);
  const auto width = static_cast<int>(map.x.size()), height = static_cast<int>(map.y.size());
  plot.map.emplace(Plot::Map{Image(width, height, 3), {{x.low, y.low}, {x.high, y.high}}});
  for (std::size_t i = 0; i < map.shares.size(); ++i) {
    const auto colour = share_colour(map.shares[i]);
    const auto at = static_cast<int>(i);
    std::copy(colour.begin(), colour.end(),
              plot.map->image.at(at % width, height - 1 - at / width));
  }
  plot.bar.emplace(Plot::Bar{"share", Image(1, kSteps, 3), {}});
  for (int i = 0; i < kSteps; ++i) {
    const double root = i / (kSteps - 1.0);
    const auto colour = share_colour(root * root * root * root);
    std::copy(colour.begin(), colour.end(), plot.bar->strip.at(0, kSteps - 1 - i));
  }
  for (const double share : {0.0, 0.0001, 0.01, 0.1, 0.5, 1.0})
    plot.bar->ticks.emplace_back(std::sqrt(std::sqrt(share)), tick_words(100 * share) + " %");
  return plot;
}

void add_plot(ExperimentResult& result, const std::string& name, const Plot& plot,
              unsigned threads) {
  const Drawing drawing = drawing_of(plot);
  double scale = kPixels / drawing.size.maxCoeff();
  for (const auto& mark : drawing.marks)
    if (const auto* picture = std::get_if<Drawing::Picture>(&mark); plot.map && picture) {
      scale = std::max(scale, plot.map->image.width / picture->size.x());
      break;
    }
  result.files.push_back({name + ".svg", svg(drawing)});
  result.files.push_back(png_file(name + ".png", pixels(drawing, scale, threads), threads));
}

}  // namespace flatray
