#include "trace/whole_lanes.h"

#include <algorithm>
#include <utility>

namespace flatray {
namespace {

constexpr std::size_t kTurn = 64, kWide = lanes::kWidest;
static_assert(kTurn % kWide == 0);

// Up to kTurn rays of a batch, in whole vectors.
struct Turn {
  alignas(64) double ox[kTurn], oy[kTurn], dx[kTurn], dy[kTurn], left[kTurn];
  std::size_t number[kTurn];
  std::size_t count = 0;

  void add(const RayBatch& rays, std::size_t ray) {
    ox[count] = rays.ox[ray];
    oy[count] = rays.oy[ray];
    dx[count] = rays.dx[ray];
    dy[count] = rays.dy[ray];
    const std::uint32_t surface = rays.left[ray].surface;
    left[count] = surface == kNoSurface ? -1 : static_cast<double>(surface);
    number[count++] = ray;
  }
  // Keeps those that are held, and tells the numbers of the others.
  void keep(const double* held, std::vector<std::size_t>& others) {
    const std::size_t asked = std::exchange(count, 0);
    for (std::size_t i = 0; i < asked; ++i) {
      if (held[i] == 0) {
        others.push_back(number[i]);
        continue;
      }
      if (count < i) {
        for (double* column : {ox, oy, dx, dy, left}) column[count] = column[i];
        number[count] = number[i];
      }
      ++count;
    }
  }
  // The last again, up to a whole vector.
  lanes::Rays padded() {
    const std::size_t whole = (count + kWide - 1) / kWide * kWide;
    for (double* column : {ox, oy, dx, dy, left})
      std::fill(column + count, column + whole, column[count - 1]);
    return {ox, oy, dx, dy, static_cast<int>(whole)};
  }
};

}  // namespace

bool WholeLanes::begin_whole(const RayBatch& rays) const {
  if (rays.size() < kWide) return false;
  double held[kWide];
  kernels_.hold(whole_.box(),
                {rays.ox.data(), rays.oy.data(), rays.dx.data(), rays.dy.data(), lanes::kWidest},
                held);
  return 2 * std::count(held, held + kWide, 1.0) >= lanes::kWidest;
}

bool WholeLanes::nearest(const RayBatch& rays, std::span<NearestHit> hits,
                         std::vector<std::size_t>& others) const {
  if (!begin_whole(rays)) return false;
  const lanes::WholeWallList list = {walls_.segments.front().a.data(),
                                     static_cast<int>(walls_.segments.size())};
  alignas(64) double held[kTurn], t[kTurn], wall[kTurn], sides[kTurn];
  for (std::size_t begin = 0; begin < rays.size(); begin += kTurn) {
    Turn turn;
    for (std::size_t i = begin; i < std::min(rays.size(), begin + kTurn); ++i) turn.add(rays, i);
    kernels_.hold(whole_.box(), turn.padded(), held);
    turn.keep(held, others);
    if (turn.count == 0) continue;
    kernels_.scan(list, turn.padded(), turn.left, {t, wall, sides});
    for (std::size_t i = 0; i < turn.count; ++i)
      hits[turn.number[i]] = hit(rays.ray(turn.number[i]), wall[i], t[i], sides[i]);
  }
  return true;
}

NearestHit WholeLanes::hit(const Ray& ray, double wall, double t, double sides) const {
  if (wall < 0) return {};
  const auto surface = static_cast<std::uint32_t>(wall);
  if (sides < 0) return {surface, HitClass::touch, Root::none, false, t};
  WholeNearest alone(walls_, ray);  // at an end, or along it
  alone.offer(surface);
  return alone.hit();
}

}  // namespace flatray
