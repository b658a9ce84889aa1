#include "transport/periodic_walls.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geom/error_free.h"
#include "geom/predicates.h"
#include "transport/near_doubles.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

// x + to - from, rounded once.
double moved(double x, double from, double to) {
  return from == to ? x : plus(two_sum(x, to), -from).hi;
}

// The place on a segment that is nearest to another, rounded once: there may be far more doubles than where
// it comes from.
Vec2 on_line(const Segment& wall, const Vec2& place) {
  const Vec2 edge = wall.b - wall.a;
  const double share = edge.dot(place - wall.a) / edge.dot(edge);
  const auto at = [&](int axis) {
    const DoubleDouble whole = two_sum(wall.b[axis], -wall.a[axis]);
    DoubleDouble sum{wall.a[axis], 0};
    if (is_exact_product(share, whole.hi)) {
      const DoubleDouble way = two_product(share, whole.hi);
      sum = plus(plus(plus(sum, way.hi), way.lo), share * whole.lo);
    }
    return sum.hi;
  };
  return {at(0), at(1)};
}

// Whether walls are the edges of a ring of four or six, in order.
bool is_ring(std::span<const PeriodicWalls::Side> sides) {
  const std::size_t count = sides.size();
  for (std::size_t i = 0; i < count; ++i)
    if (sides[i].wall.b != sides[(i + 1) % count].wall.a) return false;
  return count == 4 || count == 6;
}

// How far a place lies inside an edge, negative beyond it.
double depth(const Segment& wall, const Vec2& place) {
  const Vec2 edge = wall.b - wall.a;
  return cross(edge, place - wall.a) / std::sqrt(edge.dot(edge));
}

// The whole circles that reach over the walls of a cell and come in copies, by radius: a single one is no part
// of what the cell repeats.
std::vector<PeriodicWalls::Disc> discs_across(const Surfaces& walls,
                                              std::span<const PeriodicWalls::Side> sides) {
  std::vector<PeriodicWalls::Disc> across, copied;
  for (const std::uint32_t surface : walls.curve_numbers) {
    const auto disc = walls.visit(surface, [](const auto& wall) { return whole_circle(wall); });
    const auto reaches = [&](const PeriodicWalls::Side& side) {
      return depth(side.wall, disc->centre) < disc->radius;
    };
    if (disc && std::ranges::any_of(sides, reaches))
      across.push_back({surface, *disc, bounds_of(walls.arc(surface))});
  }
  const auto radius = [&](std::size_t i) { return across[i].circle.radius; };
  std::ranges::stable_sort(across, {},
                           [](const PeriodicWalls::Disc& disc) { return disc.circle.radius; });
  for (std::size_t i = 0; i < across.size(); ++i)
    if ((i > 0 && radius(i - 1) == radius(i)) ||
        (i + 1 < across.size() && radius(i + 1) == radius(i)))
      copied.push_back(across[i]);
  return copied;
}

// Discs by their radius, and then along a line askew to the walls, so that those along a wall are told apart.
class DiscsAskew {
 public:
  explicit DiscsAskew(std::span<const PeriodicWalls::Disc> discs) : keys_(discs.size()) {
    for (std::uint32_t i = 0; i < discs.size(); ++i)
      keys_[i] = {discs[i].circle.radius, along(discs[i].circle.centre), i};
    std::ranges::sort(keys_);
  }
  /// Tells see(disc) of all of a radius with centres no farther than `reach` from a place, and some beside.
  template <class See>
  void near(double radius, const Vec2& place, double reach, const See& see) const {
    const double low = along(place) - 2 * reach, high = along(place) + 2 * reach;
    for (auto key = std::ranges::lower_bound(keys_, Key{radius, low, 0});
         key != keys_.end() && std::get<0>(*key) == radius && std::get<1>(*key) <= high; ++key)
      see(std::get<2>(*key));
  }

 private:
  using Key = std::tuple<double, double, std::uint32_t>;
  static double along(const Vec2& point) { return point.x() + 0.6180339887498949 * point.y(); }
  std::vector<Key> keys_;
};

// Which of them are copies of others, told by where these stand in the cells around: the nearest, where rounding may
// have left it. Of two the earlier surface is no copy.
std::vector<PeriodicWalls::Copy> copies_among(std::span<const PeriodicWalls::Disc> discs,
                                              const Lattice& lattice) {
  constexpr int kCells = 2;
  constexpr double kRounding =
      0x1p-51;  // of a centre's size, where a moving camera has rounded copies again
  const DiscsAskew askew(discs);
  std::vector<PeriodicWalls::Copy> copies;
  std::vector<bool> known(discs.size(), false);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (known[i]) continue;
    const Circle& disc = discs[i].circle;
    for (int n = -kCells; n <= kCells; ++n)
      for (int m = -kCells; m <= kCells; ++m) {
        const Vec2 place = lattice.moved(disc.centre, n, m);
        const double reach = kRounding * (place.cwiseAbs() + disc.centre.cwiseAbs()).sum();
        double least = reach;
        std::size_t nearest = i;
        askew.near(disc.radius, place, reach, [&](std::size_t k) {
          const double off = (discs[k].circle.centre - place).cwiseAbs().sum();
          if (k <= i || known[k] || !(off < least || (off == least && k > nearest))) return;
          least = off;
          nearest = k;
        });
        if (nearest == i || (n == 0 && m == 0)) continue;
        known[nearest] = true;
        copies.push_back({discs[nearest].surface, discs[i].surface, {n, m}});
      }
  }
  std::ranges::sort(copies, {}, &PeriodicWalls::Copy::surface);
  return copies;
}

}  // namespace

PeriodicWalls::PeriodicWalls(const Surfaces& walls, std::span<const Material> materials) {
  if (materials.empty()) return;
  for (std::uint32_t i = 0; i < walls.size(); ++i)
    if (materials[i] == Material::periodic && walls.segment_slot(i) != kNoSurface)
      sides_.push_back({i, i, walls.segment(i), {}, {}, -1});
  // So small and so far away that the doubles do not tell its corners apart: nothing leads out.
  if (!is_ring(sides_)) sides_.clear();
  if (sides_.empty()) return;
  const std::size_t count = sides_.size(), half = count / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const Side& other = sides_[(i + half) % count];
    Side& side = sides_[i];
    side.opposite = other.surface;
    side.far = other.wall;
    for (const int axis : {0, 1})
      if (side.wall.a[axis] == side.wall.b[axis]) side.axis = axis;
  }
  // Beyond edge 1 lies cell (1, 0), beyond edge 2 cell (0, 1); in a ring of six the three neighbours in
  // turn are a - b, a, b.
  const CellIndex first = count == 4 ? CellIndex{0, -1} : CellIndex{1, -1};
  const std::array<CellIndex, 3> steps{first, {1, 0}, {0, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    sides_[i].step = steps[i];
    sides_[i + half < count ? i + half : 0].step = {-steps[i].a, -steps[i].b};
  }
  lattice_ = {{sides_[1].to(), sides_[1].from()}, {sides_[2].to(), sides_[2].from()}};
  rounded_ = {lattice_.a.b - lattice_.a.a, lattice_.b.b - lattice_.b.a};
  discs_ = discs_across(walls, sides_);
  copies_ = copies_among(discs_, lattice_);
}

const PeriodicWalls::Copy* PeriodicWalls::find_copy(std::uint32_t surface) const {
  const auto copy = std::ranges::lower_bound(copies_, surface, {}, &Copy::surface);
  return copy == copies_.end() || copy->surface != surface ? nullptr : &*copy;
}

const PeriodicWalls::Side* PeriodicWalls::find(std::uint32_t surface) const {
  const auto side = std::ranges::find(sides_, surface, &Side::surface);
  return side == sides_.end() ? nullptr : &*side;
}

bool PeriodicWalls::leads_out(std::uint32_t surface, const Vec2& direction) const {
  const Side* side = find(surface);
  return side != nullptr && turn_from_edge(side->wall.a, side->wall.b, direction) == Sign::negative;
}

std::optional<PeriodicWalls::Entry> PeriodicWalls::cross(
    const Vec2& point, const Vec2& direction, std::span<const std::uint32_t> surfaces) const {
  const auto crossed = crossed_by(surfaces, [&](const Side& side) {
    return std::optional(leads_out(side.surface, direction));
  });
  if (crossed->empty()) return std::nullopt;
  Entry entry{point, kNoSurface, {}};
  for (const Side* side : *crossed) {
    for (const int axis : {0, 1})
      entry.point[axis] = moved(entry.point[axis], side->from()[axis], side->to()[axis]);
    if (side->axis < 0) entry.point = on_line(side->far, entry.point);
    entry.surface = side->opposite;
    entry.step += side->step;
  }
  for (const Side* side : *crossed)
    if (side->axis >= 0) entry.point[side->axis] = side->to()[side->axis];
  const auto inner = inside(entry.point, crossed->back()->far, discs_around(point, entry.step));
  if (!inner) return std::nullopt;
  entry.point = *inner;
  return entry;
}

// For each disc of the cell entered, whether the point lies inside the same disc in the cell it leaves.
std::vector<bool> PeriodicWalls::discs_around(const Vec2& point, const CellIndex& step) const {
  const auto place_of = [&](const Disc& disc) {
    const Copy* copy = find_copy(disc.surface);
    return copy ? *copy : Copy{disc.surface, disc.surface, {0, 0}};
  };
  std::vector<bool> around(discs_.size(), false);
  for (const Disc& left : discs_) {
    if (left.side_of(point) != Sign::negative) continue;
    const Copy before = place_of(left);
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      Copy after = place_of(discs_[i]);
      after.step += step;
      if (after.of == before.of && after.step == before.step) around[i] = true;
    }
  }
  return around;
}

bool PeriodicWalls::may_stand(const Vec2& point, const std::vector<bool>& around) const {
  const auto is_inside = [&](const Segment& wall) {
    return orientation(wall.a, wall.b, point) != Sign::negative;
  };
  for (std::size_t i = 0; i < discs_.size(); ++i)
    if (discs_[i].side_of(point) != (around[i] ? Sign::negative : Sign::positive)) return false;
  return std::ranges::all_of(sides_, is_inside, &Side::wall);
}

bool PeriodicWalls::in_disc_across(const Vec2& point) const {
  return std::ranges::any_of(
      discs_, [&](const Disc& disc) { return disc.side_of(point) != Sign::positive; });
}

// Copies of a disc are rounded, too: what goes round one may come in under another by as much, and is moved
// along the wall then.
std::optional<Vec2> PeriodicWalls::inside(const Vec2& place, const Segment& wall,
                                          const std::vector<bool>& around) const {
  const auto accepted = [&](const Vec2& point) { return may_stand(point, around); };
  if (auto near = nearest_double(place, accepted)) return near;
  if (discs_.empty()) return std::nullopt;
  constexpr double kUlp = 0x1p-52;
  constexpr int kMost = 16;  // ulps of the wall's corners
  const double size = std::max(wall.a.cwiseAbs().maxCoeff(), wall.b.cwiseAbs().maxCoeff());
  const Vec2 edge = wall.b - wall.a;
  const Vec2 step = size * kUlp / std::sqrt(edge.dot(edge)) * edge;
  for (int i = 1; i <= kMost; ++i)
    for (const int way : {i, -i})
      if (auto near = nearest_double(place + way * step, accepted)) return near;
  return std::nullopt;
}

}  // namespace flatray
