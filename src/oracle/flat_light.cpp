#include "oracle/flat_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/portable_math.h"
#include "geom/pair.h"

namespace flatray::oracle {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kMostWalls = 1000;

class FlatTracer {
 public:
  FlatTracer(const FlatScene& scene, int width, int height, std::uint64_t seed)
      : scene_(scene), width_(width), height_(height), state_((seed + 1) * 0x9e3779b97f4a7c15) {
    light_.rgb.assign(
        std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0);
    for (const FlatScene::Lamp& lamp : scene.lamps) power_ += lamp.power;
  }

  FlatLight trace(std::uint64_t rays) && {
    for (std::uint64_t i = 0; i < rays; ++i) follow_one();
    // One ray carries power_ / rays; lengths are in pixels of the window, and so is the area.
    const double unit = power_ / static_cast<double>(rays) *
                        std::min(width_ / scene_.width, height_ / scene_.height);
    for (double& value : light_.rgb) value *= unit;
    return std::move(light_);
  }

 private:
  using Point = Pair<double>;

  // Marsaglia 2003, "Xorshift RNGs", times a constant as by Vigna 2016.
  double unit() {
    state_ ^= state_ >> 12, state_ ^= state_ << 25, state_ ^= state_ >> 27;
    return static_cast<double>((state_ * 0x2545f4914f6cdd1d) >> 11) * 0x1p-53;
  }
  double draw(const EvenRange& range) {
    return range.low == range.high ? range.low : range.low + unit() * (range.high - range.low);
  }
  static Point toward(double degrees) {
    return {portable::cos(degrees * kDegree), portable::sin(degrees * kDegree)};
  }

  const FlatScene::Lamp& any_lamp() {
    double left = unit() * power_;
    for (const FlatScene::Lamp& lamp : scene_.lamps)
      if ((left -= lamp.power) < 0) return lamp;
    return scene_.lamps.back();
  }

  void follow_one() {
    const FlatScene::Lamp& lamp = any_lamp();
    const Point place = toward(draw(lamp.polar_angle));
    const double distance = draw(lamp.polar_distance);
    Point at = Point{draw(lamp.x), draw(lamp.y)} + distance * place;
    Point way = toward(draw(lamp.ray_angle));
    const FlatScene::Wall* left = nullptr;
    for (int walls = 0; walls <= kMostWalls; ++walls) {
      ++light_.ways;
      const Hit hit = next_wall(at, way, left);
      const double far = std::isinf(hit.t) ? beyond(at) : hit.t;
      const Point to = at + far * way;
      deposit(at, to, lamp.rgb);
      if (hit.wall == nullptr || !goes_on(hit, way)) return;
      at = to, left = hit.wall;
    }
  }

  struct Hit {
    const FlatScene::Wall* wall = nullptr;
    double t = std::numeric_limits<double>::infinity(), share = 0;
    Point along{0, 0};
  };

  Hit next_wall(const Point& at, const Point& way, const FlatScene::Wall* left) {
    Hit nearest;
    for (const FlatScene::Wall& wall : scene_.walls) {
      if (&wall == left) continue;
      const Point from = Point{draw(wall.x), draw(wall.y)} - at;
      const Point along{draw(wall.dx), draw(wall.dy)};
      const double det = cross(way, along);
      const double t = cross(from, along) / det, share = cross(from, way) / det;
      if (t >= 0 && t < nearest.t && share >= 0 && share <= 1) nearest = {&wall, t, share, along};
    }
    return nearest;
  }

  bool goes_on(const Hit& hit, Point& way) {
    const FlatScene::Wall& wall = *hit.wall;
    double u = unit();
    if (u < wall.scattered) return way = toward(360 * unit()), true;
    if ((u -= wall.scattered) < wall.through) return true;
    if (u - wall.through >= wall.mirrored) return false;
    Point normal{-hit.along.y, hit.along.x};
    if (wall.has_normal) normal = toward(draw(wall.normal) + hit.share * draw(wall.turn));
    way = way - 2 * dot(way, normal) / dot(normal, normal) * normal;
    return true;
  }

  double beyond(const Point& at) const {
    return std::abs(at.x - scene_.left) + std::abs(at.y - scene_.top) + scene_.width +
           scene_.height;
  }

  // Adds the length of a line in each pixel: between two borders that it crosses it lies in one.
  void deposit(const Point& from, const Point& to, const std::array<double, 3>& rgb) {
    const double scale = std::min(width_ / scene_.width, height_ / scene_.height);
    const double start[2] = {(from.x - scene_.left) * scale, (from.y - scene_.top) * scale};
    const double way[2] = {(to.x - from.x) * scale, (to.y - from.y) * scale};
    const double size[2] = {static_cast<double>(width_), static_cast<double>(height_)};
    std::vector<double> cuts = {0, 1};
    for (int axis = 0; axis < 2; ++axis) {
      const auto [low, high] = std::minmax({start[axis], start[axis] + way[axis]});
      const double last = std::min(high, size[axis]);
      for (double border = std::max(std::ceil(low), 0.0); border <= last && low < high; ++border)
        cuts.push_back(std::clamp((border - start[axis]) / way[axis], 0.0, 1.0));
    }
    std::sort(cuts.begin(), cuts.end());
    const double length = std::sqrt(way[0] * way[0] + way[1] * way[1]);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
      const double x = start[0] + middle * way[0], y = start[1] + middle * way[1];
      if (!(x >= 0 && x < size[0] && y >= 0 && y < size[1])) continue;
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                         static_cast<std::size_t>(x);
      for (std::size_t c = 0; c < 3; ++c)
        light_.rgb[3 * pixel + c] += (cuts[i] - cuts[i - 1]) * length * rgb[c];
    }
  }

  const FlatScene& scene_;
  const int width_, height_;
  std::uint64_t state_;
  double power_ = 0;
  FlatLight light_;
};

}  // namespace

std::array<double, 3> FlatLight::mean() const {
  std::array<double, 3> sum{0, 0, 0};
  for (std::size_t i = 0; i < rgb.size(); ++i) sum[i % 3] += rgb[i];
  for (double& channel : sum) channel *= 3 / static_cast<double>(rgb.size());
  return sum;
}

FlatLight trace_flat(const FlatScene& scene, int width_px, int height_px, std::uint64_t rays,
                     std::uint64_t seed) {
  return FlatTracer(scene, width_px, height_px, seed).trace(rays);
}

}  // namespace flatray::oracle
