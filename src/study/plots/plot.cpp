#include "study/plots/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/clip.h"
#include "study/plots/plot_axes.h"
#include "study/plots/plot_labels.h"

namespace flatray {
namespace {

// Units of the drawing.
constexpr double kWidth = 500, kNarrowest = 300, kUsualHeight = 280, kHighestMap = 420, kLine = 17,
                 kLabelRoom = 30, kRight = 20, kBarWidth = 14, kBarGap = 14, kMark = 2;
constexpr double kApart = 8;      // of places along an interval that labels keep off
constexpr double kBeyond = 50;    // of upright labels, over the height of the axes
constexpr double kMostRows = 10;  // of the legend
constexpr int kMostTicks[] = {7, 8};

// Sides of a mark round its middle, in radii: what tells the points of series apart, beside colour.
// The first is a disc.
const std::vector<Vec2>& mark_outline(std::size_t number) {
  static const std::array<std::vector<Vec2>, 4> kOutlines = {
      {{},
       {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}},
       {{0, -1.3}, {1.2, 0.8}, {-1.2, 0.8}},
       {{0, -1.4}, {1.4, 0}, {0, 1.4}, {-1.4, 0}}}};
  return kOutlines[number % kOutlines.size()];
}

std::vector<Vec2> box_of(const Vec2& low, const Vec2& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

class PlotDrawing {
 public:
  explicit PlotDrawing(const Plot& plot) : plot_(plot) {
    see();
    lay_out();
  }

  Drawing drawing() && {
    axes();
    if (plot_.map) out_.marks.push_back(Drawing::Picture{low_, high_ - low_, plot_.map->image});
    PointLabels labels(low_, high_);
    std::size_t number = 0;
    for (const Plot::Series& series : plot_.series) {
      const std::size_t look = series.ink.empty() ? number++ : 0;
      const std::string ink = series.ink.empty() ? series_ink(look) : series.ink;
      for (const Plot::Point& point : series.points)
        if (shown(point)) interval(point, ink, labels);
      is_marked(series) ? marks(series, ink, look, labels) : line(series, ink, look);
      if (count_shown(series) > 0 && !series.name.empty()) name(series, ink, look);
    }
    const std::size_t unlabelled = labels.draw(out_);
    if (plot_.bar) bar(*plot_.bar);
    for (const auto& [colour, words] : plot_.kinds) {
      if (is_legend_full()) continue;
      const Vec2 at = next_name(words);
      out_.marks.push_back(
          Drawing::Path{box_of(at - Vec2(20, 6), at + Vec2(-6, 6)), {"axis", colour}, true});
    }
    if (unlabelled > 0) next_name(fmt::format("{} points without words", unlabelled));
    below();
    return std::move(out_);
  }

 private:
  // A line of one point would not be seen.
  bool is_marked(const Plot::Series& series) const {
    return series.marks || count_shown(series) == 1;
  }
  std::ptrdiff_t count_shown(const Plot::Series& series) const {
    return std::ranges::count_if(series.points, [&](const auto& point) { return shown(point); });
  }
  // Counts what it then leaves out.
  bool is_legend_full() {
    const bool full = name_at_.y() > legend_end_;
    if (full) ++unnamed_;
    return full;
  }
  bool shown(const Plot::Point& point) const {
    return std::isfinite(point.x) && std::isfinite(point.y) && (!plot_.log_y || point.y > 0) &&
           (!plot_.log_x || point.x > 0);
  }
  Vec2 scaled(double x, double y) const {
    return {plot_.log_x ? log10_of(x) : x, plot_.log_y ? log10_of(y) : y};
  }
  Vec2 place(double x, double y) const {
    const Vec2 part = (scaled(x, y) - box_.low).cwiseQuotient(box_.size());
    return {low_.x() + part.x() * (high_.x() - low_.x()),
            high_.y() - part.y() * (high_.y() - low_.y())};
  }

  // What the axes show: of intervals on a logarithm the part above 0.
  void see() {
    whole_[0] = whole_[1] = !plot_.map && !plot_.window && !plot_.equal;
    if (plot_.map || plot_.window) {
      box_ = plot_.window.value_or(plot_.map ? plot_.map->bounds : Bounds{});
      return;
    }
    for (const Plot::Series& series : plot_.series)
      for (const Plot::Point& point : series.points)
        for (const auto& [x, y] : {std::pair(0, 0), {-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
          const Plot::Point end{point.x + x * point.half_x, point.y + y * point.half};
          if (!shown(point) || !shown(end)) continue;
          box_.add(scaled(end.x, end.y));
          whole_[0] = whole_[0] && point.x == std::floor(point.x);
          whole_[1] = whole_[1] && point.y == std::floor(point.y);
        }
    if (box_.empty()) box_.add(Vec2(0, 0));
    for (int axis = 0; axis < 2; ++axis) {
      const double span = box_.high[axis] - box_.low[axis];
      const double margin = span > 0 ? 0.04 * span : std::max(std::fabs(box_.low[axis]), 1.0) / 2;
      box_.low[axis] -= margin;
      box_.high[axis] += margin;
    }
  }

  // At most so many; where all there is are whole numbers, as counts are, at these alone.
  std::vector<Tick> ticks_of(int axis, double most) const {
    if (axis == 0 ? plot_.log_x : plot_.log_y)
      return log_ticks(box_.low[axis], box_.high[axis], most);
    const double asked = axis == 1 ? plot_.y_step : 0, span = box_.size()[axis];
    const double step = span <= most * asked                       ? asked
                        : whole_[axis] && 1 < span && span <= most ? 1
                                                                   : 0;
    return ticks(box_.low[axis], box_.high[axis], most, step);
  }

  // The upright labels and the ticks beside the axes, and the size that leaves for these.
  Vec2 lay_beside(double height) {
    double widest = 0, bar = 0;
    ticks_[1] = ticks_of(1, std::clamp(static_cast<int>(height / kLine), 1, kMostTicks[1]));
    for (const Tick& tick : ticks_[1]) widest = std::max(widest, words_width(tick.words));
    y_label_ = lines_of(plot_.y_label, height + kBeyond);
    left_ = 10 * std::ceil((room_of(y_label_) + widest + 8) / 10);
    right_ = kRight;
    if (plot_.bar) {
      for (const auto& [at, words] : plot_.bar->ticks) bar = std::max(bar, words_width(words));
      bar_label_ = lines_of(plot_.bar->label, height + kBeyond);
      right_ = 10 * std::ceil((kBarGap + kBarWidth + 6 + bar + room_of(bar_label_)) / 10);
    }
    Vec2 area(kWidth - left_ - right_, kUsualHeight);
    if (plot_.map || plot_.equal) {
      const double upright = plot_.equal ? box_.size().y() / box_.size().x()
                                         : 1.0 * plot_.map->image.height / plot_.map->image.width;
      area.y() = std::max(40.0, std::round(area.x() * upright));
      if (area.y() > kHighestMap)
        area = {std::max(40.0, std::round(kHighestMap / upright)), kHighestMap};
    }
    return area;
  }
  static double room_of(const std::vector<std::string>& label) {
    return kLabelRoom - kLine + kLine * static_cast<double>(label.size());
  }

  // As many of x as have room, without those whose words would end beyond the plot.
  void lay_below(const Vec2& area) {
    const double unit = area.x() / box_.size().x();
    for (int most = kMostTicks[0]; most >= 1; --most) {
      ticks_[0] = ticks_of(0, most);
      bool fits = true;
      for (std::size_t i = 1; i < ticks_[0].size(); ++i) {
        const Tick &a = ticks_[0][i - 1], &b = ticks_[0][i];
        fits = fits && (b.at - a.at) * unit > 4 + (words_width(a.words) + words_width(b.words)) / 2;
      }
      if (fits) break;
    }
    std::erase_if(ticks_[0], [&](const Tick& tick) {
      const double half = words_width(tick.words) / 2;
      return (tick.at - box_.low.x()) * unit + left_ < half ||
             (box_.high.x() - tick.at) * unit + right_ < half;
    });
  }

  void lay_out() {
    const Vec2 area = lay_beside(lay_beside(kUsualHeight).y());
    lay_below(area);
    out_.size.x() = std::max(kNarrowest, left_ + area.x() + right_);
    const double middle = left_ + area.x() / 2;
    x_label_ = lines_of(plot_.x_label, 2 * std::min(middle, out_.size.x() - middle) - 8);
    out_.title = plot_.title;
    const Vec2 below = write({{out_.size.x() / 2, 8 + kLine / 2}, "", 0.5, "text", false, true},
                             lines_of(plot_.title, out_.size.x() - 2 * kRight));
    low_ = {left_, std::round(below.y() - kLine / 2 + 8)};
    high_ = low_ + area;
    name_at_ = {kRight, high_.y() + (2.4 + static_cast<double>(x_label_.size())) * kLine};
    legend_end_ = name_at_.y() + kMostRows * kLine;
  }

  void axes() {
    for (int axis = 0; axis < 2; ++axis)
      for (const Tick& tick : ticks_[axis]) {
        const double part = (tick.at - box_.low[axis]) / box_.size()[axis];
        const Vec2 along = axis == 0 ? Vec2(part * (high_.x() - low_.x()), 0)
                                     : Vec2(0, -part * (high_.y() - low_.y()));
        const Vec2 at = Vec2(low_.x(), high_.y()) + along;
        const Vec2 out = axis == 0 ? Vec2(0, 1) : Vec2(-1, 0);
        const Vec2 far = axis == 0 ? Vec2(at.x(), low_.y()) : Vec2(high_.x(), at.y());
        if (!plot_.map) stroke({at, far}, {"grid"});
        stroke({at, at + 5 * out}, {"axis"});
        out_.marks.push_back(
            Drawing::Words{at + (axis == 0 ? 14 : 8) * out, tick.words, axis == 0 ? 0.5 : 1});
      }
    out_.marks.push_back(
        Drawing::Path{box_of(low_ - Vec2(0.5, 0.5), high_ + Vec2(0.5, 0.5)), {"axis"}, true});
    const Vec2 middle = 0.5 * (low_ + high_);
    write({{middle.x(), high_.y() + 14 + kLine}, "", 0.5}, x_label_);
    write({{14, middle.y()}, "", 0.5, "text", true}, y_label_);
  }

  // Lines as the first stands, downwards or, upright, to the right. Gives where the next would
  // stand.
  Vec2 write(Drawing::Words line, const std::vector<std::string>& lines) {
    for (const std::string& words : lines) {
      line.words = words;
      out_.marks.push_back(line);
      line.at += line.upright ? Vec2(kLine, 0) : Vec2(0, kLine);
    }
    return line.at;
  }

  void stroke(std::vector<Vec2> points, const Pen& look, const std::string& title = {}) {
    out_.marks.push_back(Drawing::Path{std::move(points), look, false, false, title});
  }

  // Its parts inside the axes.
  void line(const Plot::Series& series, const std::string& ink, std::size_t number) {
    const Pen look{ink, "", series.width, number};
    const std::vector<Vec2> area = box_of(low_, high_);
    std::vector<Vec2> way;
    const auto end = [&] {
      if (way.size() > 1) stroke(std::move(way), look, series.name);
      way.clear();
    };
    std::optional<Vec2> last;
    for (const Plot::Point& point : series.points) {
      const bool part_of_line = shown(point);
      if (!part_of_line && (std::isnan(point.x) || std::isnan(point.y))) last.reset();
      if (!part_of_line) continue;
      const Vec2 at = place(point.x, point.y);
      const Vec2 from = last.value_or(at);
      const HitInterval inside = clip_convex({from, at - from}, area, kSegment);
      if (!last || !inside || inside.t_enter > 0) end();
      if (inside && last) {
        if (way.empty()) way.push_back(from + inside.t_enter * (at - from));
        way.push_back(from + inside.t_exit * (at - from));
        if (inside.t_exit < 1) end();
      }
      last = at;
    }
    end();
  }

  void marks(const Plot::Series& series, const std::string& ink, std::size_t number,
             PointLabels& labels) {
    for (const Plot::Point& point : series.points) {
      if (!shown(point)) continue;
      const Vec2 at = place(point.x, point.y);
      if (!is_inside(at)) continue;
      mark(at, ink, number, series.width);
      if (point.ringed) out_.marks.push_back(Drawing::Disc{at, 6, {"text"}});
      labels.keep_free(at);
      if (!point.label.empty()) labels.add(at, point.label);
    }
  }
  bool is_inside(const Vec2& at) const {
    return Bounds{low_ - Vec2(1, 1), high_ + Vec2(1, 1)}.contains(at);
  }
  // The intervals of a point, which no label covers.
  void interval(const Plot::Point& point, const std::string& ink, PointLabels& labels) {
    if (!is_inside(place(point.x, point.y))) return;
    for (const Vec2& half : {Vec2(0, point.half), Vec2(point.half_x, 0)}) {
      if (half == Vec2(0, 0)) continue;
      Vec2 ends[] = {end_of(point, -half), end_of(point, half)};
      for (Vec2& end : ends) end = end.cwiseMax(low_).cwiseMin(high_);
      const int steps = 1 + static_cast<int>((ends[1] - ends[0]).lpNorm<1>() / kApart);
      for (int i = 0; i <= steps; ++i) labels.keep_free(ends[0] + i * (ends[1] - ends[0]) / steps);
      stroke({ends[0], ends[1]}, {ink});
    }
  }
  // An end of an interval; at the border of the plot where a logarithm has none.
  Vec2 end_of(const Plot::Point& point, const Vec2& away) const {
    const Plot::Point end{point.x + away.x(), point.y + away.y()};
    if (shown(end)) return place(end.x, end.y);
    const Vec2 at = place(point.x, point.y);
    return away.x() != 0 ? Vec2(low_.x(), at.y()) : Vec2(at.x(), high_.y());
  }

  void mark(const Vec2& at, const std::string& ink, std::size_t number, double width) {
    std::vector<Vec2> sides = mark_outline(number);
    if (sides.empty()) {
      out_.marks.push_back(Drawing::Disc{at, kMark * width, {"", ink}});
      return;
    }
    for (Vec2& side : sides) side = at + kMark * width * side;
    out_.marks.push_back(Drawing::Path{std::move(sides), {"", ink}, true});
  }

  // Where the words of the next entry of the legend stand, words included.
  Vec2 next_name(const std::string& words) {
    const double width = words_width(words) + 28 + 12;
    if (name_at_.x() + width > out_.size.x() && name_at_.x() > kRight) {
      name_at_ = {kRight, name_at_.y() + kLine};
    }
    Vec2 at = name_at_ + Vec2(28, 0);
    out_.marks.push_back(Drawing::Words{at, words});
    name_at_.x() += width;
    return at;
  }
  void name(const Plot::Series& series, const std::string& ink, std::size_t number) {
    if (is_legend_full()) return;
    const Vec2 at = next_name(series.name) - Vec2(6, 0);
    if (is_marked(series)) return mark(at - Vec2(9, 0), ink, number, series.width);
    stroke({at - Vec2(22, 0), at}, {ink, "", series.width, number});
  }

  // Beside the axes, from its lower end upwards.
  void bar(const Plot::Bar& bar) {
    const double left = high_.x() + kBarGap, height = high_.y() - low_.y();
    const auto y = [&](double part) { return high_.y() - part * height; };
    out_.marks.push_back(Drawing::Picture{{left, y(1)}, {kBarWidth, height}, bar.strip});
    out_.marks.push_back(Drawing::Path{
        box_of({left - 0.5, y(1) - 0.5}, {left + kBarWidth + 0.5, y(0) + 0.5}), {"axis"}, true});
    // Both ends, and between them those that have room.
    double last = -height;
    for (const auto& [part, words] : bar.ticks) {
      const bool is_end = &words == &bar.ticks.back().second;
      if (!is_end && (y(last) - y(part) < kLine || y(part) - y(1) < kLine)) continue;
      last = part;
      stroke({{left + kBarWidth, y(part)}, {left + kBarWidth + 4, y(part)}}, {"axis"});
      out_.marks.push_back(Drawing::Words{{left + kBarWidth + 7, y(part)}, words});
    }
    write({{out_.size.x() + 18 - room_of(bar_label_), y(0.5)}, "", 0.5, "text", true}, bar_label_);
  }

  void below() {
    if (unnamed_ > 0) next_name(fmt::format("and {} more", unnamed_));
    const bool has_names = name_at_.x() > kRight;
    const double y = has_names ? name_at_.y() + 1.2 * kLine : name_at_.y();
    const Vec2 end = write({{kRight, y}, ""}, lines_of(plot_.caption, out_.size.x() - 2 * kRight));
    out_.size.y() = std::round(end.y());
  }

  const Plot& plot_;
  Bounds box_;  // of what is shown, logarithms where it is by these
  std::vector<Tick> ticks_[2];
  bool whole_[2] = {false, false};  // whether all coordinates there are whole numbers
  std::vector<std::string> x_label_, y_label_, bar_label_;
  double left_ = 0, right_ = 0;  // of what is beside the axes
  Vec2 low_{0, 0}, high_{0, 0};  // upper left and lower right corner of the axes
  Vec2 name_at_{0, 0};           // of the next entry of the legend
  double legend_end_ = 0;
  std::size_t unnamed_ = 0;  // that it has no room for
  Drawing out_;
};

}  // namespace

Drawing drawing_of(const Plot& plot) { return PlotDrawing(plot).drawing(); }

std::string svg(const Plot& plot) { return svg(drawing_of(plot)); }

}  // namespace flatray
