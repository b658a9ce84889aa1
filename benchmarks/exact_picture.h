#pragma once
#include <algorithm>

#include "filler.h"

namespace bench {

/// Area of a convex polygon inside [0, 1] x [0, 1] moved to (x, y), by cutting it at the four lines.
class PixelClip {
 public:
  double area(const std::vector<flatray::Vec2>& corners, double x, double y) {
    from_.clear();
    for (const auto& corner : corners) from_.push_back({corner.x() - x, corner.y() - y});
    cut([](const Point& p) { return p.x; });
    cut([](const Point& p) { return 1 - p.x; });
    cut([](const Point& p) { return p.y; });
    cut([](const Point& p) { return 1 - p.y; });
    double twice = 0;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const Point &a = from_[i], &b = from_[(i + 1) % from_.size()];
      twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
  }

 private:
  struct Point {
    double x, y;
  };

  template <class Distance>
  void cut(const Distance& inside) {
    to_.clear();
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const Point &a = from_[i], &b = from_[(i + 1) % from_.size()];
      const double da = inside(a), db = inside(b);
      if (da >= 0) to_.push_back(a);
      if ((da < 0) == (db < 0)) continue;
      const double t = da / (da - db);
      to_.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    from_.swap(to_);
  }

  std::vector<Point> from_, to_;
};

/// The polygons over white with the exact share of every pixel, in doubles: what all are compared
/// with. Blends sRGB values, as the peers do, or light.
class ExactPicture {
 public:
  using Value = double (*)(double);

  ExactPicture(const std::vector<Polygon>& polygons, Value value_of_srgb)
      : pixels_(3ULL * kWidth * kHeight, value_of_srgb(255)) {
    for (const Polygon& polygon : polygons) add(polygon, value_of_srgb);
  }

  /// Mean over all channels of the distance of sRGB values.
  template <class Pixel>
  double mean_difference(const Pixel& pixel, Value srgb_of_value) const {
    double sum = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const std::array<double, 3> shown = pixel(x, y);
        for (std::size_t c = 0; c < 3; ++c)
          sum += std::abs(shown[c] - srgb_of_value(pixels_[place(x, y) + c]));
      }
    return sum / static_cast<double>(pixels_.size());
  }

 private:
  static std::size_t place(int x, int y) {
    return 3 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x));
  }

  void add(const Polygon& polygon, Value value_of_srgb) {
    double low_y = kHeight, high_y = 0;
    for (const auto& v : polygon.corners)
      low_y = std::min(low_y, v.y()), high_y = std::max(high_y, v.y());
    const int end = std::min(kHeight, static_cast<int>(std::ceil(high_y)));
    for (int y = std::max(0, static_cast<int>(low_y)); y < end; ++y)
      add_row(polygon, y, value_of_srgb);
  }

  // The polygon's reach in the row: of its corners there, and of its edges on the row's borders.
  void add_row(const Polygon& polygon, int y, Value value_of_srgb) {
    double low = kWidth, high = 0;
    const auto reach = [&](double x) { low = std::min(low, x), high = std::max(high, x); };
    const auto& corners = polygon.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (a.y() >= y && a.y() <= y + 1) reach(a.x());
      for (const double border : {1.0 * y, y + 1.0})
        if ((a.y() < border) != (b.y() < border))
          reach(a.x() + (border - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    const int end = std::min(kWidth, static_cast<int>(std::ceil(high)));
    for (int x = std::max(0, static_cast<int>(low)); x < end; ++x) {
      const double share = std::min(inside(corners, x, y) ? 1 : clip_.area(corners, x, y), 1.0);
      for (std::size_t c = 0; c < 3; ++c) {
        double& value = pixels_[place(x, y) + c];
        value += share * (value_of_srgb(polygon.colour[c]) - value);
      }
    }
  }

  static bool inside(const std::vector<flatray::Vec2>& corners, double x, double y) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
      for (const auto& [px, py] : {std::pair(x, y), {x + 1, y}, {x, y + 1}, {x + 1, y + 1}})
        if ((b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x()) < 0) return false;
    }
    return true;
  }

  std::vector<double> pixels_;
  PixelClip clip_;
};

}  // namespace bench
