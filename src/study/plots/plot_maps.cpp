#include <algorithm>
#include <cmath>

#include "base/light.h"
#include "base/number_text.h"
#include "base/portable_math.h"
#include "study/plots/plot.h"
#include "study/plots/plot_axes.h"

namespace flatray {
namespace {

constexpr double kPixels = 1000;  // of the longer side of a picture
constexpr int kSteps = 256;       // of a bar

// By the fourth root, so that small shares are not pale.
LinearRgb share_colour(double root) {
  return {light_of(255 - 135 * root), light_of(230 - 230 * root), light_of(150 - 130 * root)};
}
double fourth_root(double share) { return std::sqrt(std::sqrt(share)); }

// The bounds of pixels whose middles are evenly apart.
Range edges(const std::vector<double>& middles) {
  const double half = middles.size() < 2 ? 0.5 : 0.5 * (middles[1] - middles[0]);
  return {middles.front() - half, middles.back() + half};
}

}  // namespace

double log_share(double number, double most) {
  return most > 0 ? portable::log(1 + number) / portable::log(1 + most) : 0;
}

Plot::Bar bar_of(std::string label, double most, const std::function<LinearRgb(double)>& colour,
                 const std::function<double(double)>& part_of) {
  const auto light = [&](std::size_t i) {
    return colour(1 - static_cast<double>(i) / (kSteps - 1));
  };
  Plot::Bar bar{std::move(label), image_of(1, kSteps, light), {}};
  if (!(most > 0)) {  // all there is is 0
    bar.ticks.emplace_back(0, "0");
    return bar;
  }
  std::vector<double> numbers{0};
  const bool counts = part_of && most == std::floor(most);  // which have no parts
  for (const Tick& tick :
       part_of ? log_ticks(log10_of(most) - 3, log10_of(most), 9) : ticks(0, most, 6)) {
    const double number = part_of ? portable::pow(10, tick.at) : tick.at;
    if (number > (counts ? 0.999 : 0)) numbers.push_back(number);
  }
  if (numbers.back() != most) numbers.push_back(most);
  for (const double number : numbers)
    bar.ticks.emplace_back(number == most ? 1
                           : part_of      ? part_of(number)
                                          : number / most,
                           tick_words(number, 4));
  return bar;
}

Plot plot_of(const HeatMap& map) {
  Plot plot{map.title, map.x_label, map.y_label};
  const Range x = edges(map.x), y = edges(map.y);
  const auto light = [&](std::size_t i) {  // rows from the upper one on
    const std::size_t columns = map.x.size(), row = map.y.size() - 1 - i / columns;
    return share_colour(fourth_root(map.shares[row * columns + i % columns]));
  };
  plot.map.emplace(
      Plot::Map{image_of(static_cast<int>(map.x.size()), static_cast<int>(map.y.size()), light),
                {{x.low, y.low}, {x.high, y.high}}});
  plot.bar = bar_of("share, %", 100, &share_colour,
                    [](double percent) { return fourth_root(percent / 100); });
  return plot;
}

void add_plot(ExperimentResult& result, const std::string& name, const Plot& plot,
              unsigned threads) {
  const Drawing drawing = drawing_of(plot);
  double scale = kPixels / drawing.size.maxCoeff();
  for (const auto& mark : drawing.marks)
    if (const auto* picture = std::get_if<Drawing::Picture>(&mark); plot.map && picture) {
      scale = std::clamp(plot.map->image.width / picture->size.x(), scale, 4 * scale);
      break;
    }
  result.files.push_back({name + ".svg", svg(drawing)});
  result.files.push_back(png_file(name + ".png", pixels(drawing, scale, threads), threads));
}

void add_map(ExperimentResult& result, const std::string& name, const Plot& plot, unsigned threads,
             const std::function<std::string(std::size_t)>& cell) {
  add_plot(result, name, plot, threads);
  const auto& [image, bounds] = *plot.map;
  const Vec2 step(bounds.size().x() / image.width, bounds.size().y() / image.height);
  std::string text = "y";
  for (int x = 0; x < image.width; ++x)
    text += "," + number_text(bounds.low.x() + (x + 0.5) * step.x());
  for (std::size_t i = 0; 3 * i < image.pixels.size(); ++i) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t row = i / width;
    if (i % width == 0)
      text += "\n" + number_text(bounds.high.y() - (static_cast<double>(row) + 0.5) * step.y());
    text += "," + cell(i);
  }
  result.files.push_back({name + "_pixels.csv", text + "\n"});
}

}  // namespace flatray
