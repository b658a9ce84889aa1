#include "study/plots/svg_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.h"
#include "geom/bounds.h"
#include "study/plots/svg_text.h"

namespace flatray {
namespace {

constexpr double kWidth = 640, kHeight = 420, kLeft = 80, kRight = 20, kTop = 40, kBottom = 56,
                 kLegend = 100;
constexpr std::array kColours = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#555"};
constexpr double kTicks = 6;
constexpr double kLn10 = 0x1.26bb1bbb55516p+1;

double log10_of(double x) { return portable::log(x) / kLn10; }

// 1, 2 or 5 times a power of ten, near `span` / kTicks.
double tick_step(double span) {
  const double power = portable::pow(10, std::floor(log10_of(span / kTicks)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (span / (factor * power) <= kTicks) return factor * power;
  return 10 * power;
}

class Drawing {
 public:
  explicit Drawing(const Plot& plot) : plot_(plot) {
    for (const Plot::Series& series : plot.series)
      for (const Plot::Point& point : series.points) {
        if (!shown(point)) continue;
        box_.add(Vec2(along(point.x), scaled(point.y)));
        if (!plot.log_y) {
          box_.add(Vec2(along(point.x), point.y - point.half));
          box_.add(Vec2(along(point.x), point.y + point.half));
        }
      }
    if (box_.empty()) box_.add(Vec2(0, 0));
    for (int axis = 0; axis < 2; ++axis) {
      const double span = box_.high[axis] - box_.low[axis];
      const double margin = span > 0 ? 0.04 * span : std::max(std::fabs(box_.low[axis]), 1.0) / 2;
      box_.low[axis] -= margin;
      box_.high[axis] += margin;
    }
  }

  std::string text() {
    open();
    axis(0);
    axis(1);
    std::size_t named = 0;
    const bool left = points_near(kLeft) <= points_near(kWidth - kRight);
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      const Plot::Series& series = plot_.series[i];
      if (series.points.empty()) continue;
      const char* colour = kColours[i % kColours.size()];
      series.marks ? marks(series, colour) : line(series, colour);
      label(
          {left ? kLeft + 12 : kWidth - kRight - 12, kTop + 16 + 16 * static_cast<double>(named++)},
          series.name, left ? "start" : "end", colour);
    }
    for (const Plot::Note& note : plot_.notes) ring(note);
    return text_ + "</svg>\n";
  }

 private:
  bool shown(const Plot::Point& point) const {
    return std::isfinite(point.x) && std::isfinite(point.y) && (!plot_.log_y || point.y > 0) &&
           (!plot_.log_x || point.x > 0);
  }
  double along(double x) const { return plot_.log_x ? log10_of(x) : x; }
  double scaled(double y) const { return plot_.log_y ? log10_of(y) : y; }
  Vec2 place(double x, double y) const {
    const Vec2 size = box_.size();
    return {kLeft + (x - box_.low.x()) / size.x() * (kWidth - kLeft - kRight),
            kHeight - kBottom - (y - box_.low.y()) / size.y() * (kHeight - kTop - kBottom)};
  }

  // Points where a legend at this side would be.
  std::size_t points_near(double side) const {
    std::size_t count = 0;
    for (const Plot::Series& series : plot_.series)
      for (const Plot::Point& point : series.points)
        if (shown(point)) {
          const Vec2 at = place(along(point.x), scaled(point.y));
          if (std::fabs(at.x() - side) < kLegend && at.y() < kTop + kLegend) ++count;
        }
    return count;
  }

  void open() {
    text_ = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        "<rect x=\"{2}\" y=\"{3}\" width=\"{4}\" height=\"{5}\" fill=\"none\" stroke=\"#444\"/>\n",
        kWidth, kHeight, kLeft, kTop, kWidth - kLeft - kRight, kHeight - kTop - kBottom);
    label({kWidth / 2, kTop / 2}, plot_.title, "middle", "#000");
    label({(kLeft + kWidth - kRight) / 2, kHeight - 12}, plot_.x_label, "middle", "#000");
    text_ += fmt::format(
        "<text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        svg_number((kTop + kHeight - kBottom) / 2), svg_text(plot_.y_label));
  }

  void label(const Vec2& at, const std::string& words, const char* anchor, const char* colour) {
    text_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" dy=\"0.35em\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
        svg_number(at.x()), svg_number(at.y()), anchor, colour, svg_text(words));
  }
  void stroke(const Vec2& a, const Vec2& b, const char* colour) {
    text_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\"/>\n",
                         svg_number(a.x()), svg_number(a.y()), svg_number(b.x()), svg_number(b.y()),
                         colour);
  }

  void axis(int which) {
    const double low = box_.low[which], high = box_.high[which];
    if (which == 1 ? plot_.log_y : plot_.log_x) return log_axis(which, low, high);
    const double step = tick_step(high - low);
    for (double k = std::ceil(low / step); k * step <= high; ++k)
      tick(which, k * step + 0.0, fmt::format("{:.6g}", k * step + 0.0));
  }

  // Powers of ten; with their 2 and 5 times where there are few.
  void log_axis(int which, double low, double high) {
    const double step = std::max(1.0, std::ceil((high - low) / kTicks));
    for (double k = std::floor(low / step) * step; k <= high; k += step)
      for (const int factor : {1, 2, 5}) {
        const double at = k + log10_of(factor);
        if (at < low || at > high || (factor > 1 && high - low > kTicks / 2)) continue;
        tick(which, at, fmt::format("{}e{:.0f}", factor, k));
      }
  }

  void tick(int which, double value, const std::string& words) {
    if (which == 0) {
      const Vec2 at = place(value, box_.low.y());
      stroke(at, at + Vec2(0, 5), "#444");
      label(at + Vec2(0, 16), words, "middle", "#000");
    } else {
      const Vec2 at = place(box_.low.x(), value);
      stroke(at, at - Vec2(5, 0), "#444");
      label(at - Vec2(9, 0), words, "end", "#000");
    }
  }

  void marks(const Plot::Series& series, const char* colour) {
    for (const Plot::Point& point : series.points) {
      if (!shown(point)) continue;
      const Vec2 at = place(along(point.x), scaled(point.y));
      if (point.half > 0 && !plot_.log_y)
        stroke(place(along(point.x), point.y - point.half),
               place(along(point.x), point.y + point.half), colour);
      text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"2.5\" fill=\"{}\"/>\n",
                           svg_number(at.x()), svg_number(at.y()), colour);
    }
  }

  // The words are on the side that has more room.
  void ring(const Plot::Note& note) {
    if (!shown({note.x, note.y})) return;
    const Vec2 at = place(along(note.x), scaled(note.y));
    text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"6\" fill=\"none\" stroke=\"#000\"/>\n",
                         svg_number(at.x()), svg_number(at.y()));
    const bool left = at.x() > (kLeft + kWidth - kRight) / 2;
    label(at + Vec2(left ? -10 : 10, 0), note.words, left ? "end" : "start", "#000");
  }

  void line(const Plot::Series& series, const char* colour) {
    std::string way;
    for (const Plot::Point& point : series.points) {
      if (!shown(point)) continue;
      const Vec2 at = place(along(point.x), scaled(point.y));
      way +=
          fmt::format("{}{} {}", way.empty() ? "M" : "L", svg_number(at.x()), svg_number(at.y()));
    }
    if (!way.empty())
      text_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\"/>\n", way, colour);
  }

  const Plot& plot_;
  Bounds box_;
  std::string text_;
};

}  // namespace

std::string svg(const Plot& plot) { return Drawing(plot).text(); }

}  // namespace flatray
