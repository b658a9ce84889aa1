#include "trace/wall_cells.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/counted.h"
#include "geom/decide.h"
#include "trace/curve_filter.h"

namespace flatray {
namespace {

// So many are looked at without cells; of curves more, as their discs rule out most.
constexpr std::size_t kFew = 8, kFewCurves = 32;
constexpr double kCellsAWall = 2, kCellsACurve = 1, kMostCells = 0x1p22;
// Width and height of a wall in cells, on average: those that lie on one another, all as large as the grid, would pass
// the root of all cells each.
constexpr double kCellsAcross = 10;
constexpr double kMargin = 0x1p-10;  // of a cell's side, by which lists reach beyond it
constexpr double kFar = 0x1p30;      // cells away, where places are off by 2^-20
constexpr double kSlack = 0x1p-12;   // cells, by which a walk may be off
constexpr double kLeastSize = 0x1p-400, kMostSize = 0x1p400;

// A vector in the form in which the curve is a circle, and the largest it may be in a box about it.
struct Form {
  double length, most;
};
Form form_of(const Ellipse& curve, const Vec2& w, const Vec2& half) {
  const Pair<double> form = curve_form(kPlain, curve, Pair<double>{w.x(), w.y()});
  const double length = std::sqrt(dot(form, form));
  if (curve.is_circle()) return {length, half.norm()};
  const Vec2 u = curve.u.cwiseAbs(), v = curve.v.cwiseAbs(), far = w.cwiseAbs();
  const Vec2 spread(half.x() * v.y() + half.y() * v.x(), u.x() * half.y() + u.y() * half.x());
  const double terms = far.x() * v.y() + far.y() * v.x() + u.x() * far.y() + u.y() * far.x();
  return {length, spread.norm() + 0x1p-48 * terms};
}

// Sizes of forms, which are products of two coordinates and squared.
bool is_sound_form(double size) { return size > 0x1p-200 && size < 0x1p200; }

// Whether its ends surely are about as near to the curve as rounding leaves them: else it may reach beyond. Of flat
// curves the form loses digits.
bool ends_on_curve(const Arc& arc) {
  if (arc.extent != Arc::Extent::between) return true;
  const auto [least, most] = half_axes(arc.curve);
  if (!(std::fabs(least) > 0x1p-10 * most &&
        is_sound_form(std::fabs(form_size(kPlain, arc.curve)))))
    return false;
  const auto near = [&](const Vec2& end) {
    const double length = form_of(arc.curve, end - arc.curve.centre, {0, 0}).length;
    const double r = std::fabs(form_size(kPlain, arc.curve));
    return std::fabs(length - r) < 0x1p-40 * r;
  };
  return near(arc.from) && near(arc.to);
}

}  // namespace

WallCells::WallCells(const Surfaces& walls, bool of_curves)
    : walls_(walls),
      of_curves_(of_curves),
      count_(of_curves ? walls.curve_numbers.size() : walls.size()) {
  if (count_ > (of_curves ? kFewCurves : kFew)) divide();
  if (!of_curves) return;
  for (const std::uint32_t curve : walls.curve_numbers) {
    Disc disc = walls.visit(curve, [](const auto& wall) { return disc_about(wall); });
    disc.radius *= 1 + 0x1p-48;
    discs_.push_back(disc);
    magnitude_ = std::max(magnitude_, disc.centre.cwiseAbs().maxCoeff() + disc.radius);
  }
}

// But for some roundings of its radius, for which the constructor widens it. In the form in which its curve is a circle
// the part of a half turn and less lies in the disc whose diameter is its chord.
WallCells::Disc WallCells::disc_about(const Arc& wall) {
  const double axis = half_axes(wall.curve).most;
  const Vec2& centre = wall.curve.centre;
  if (wall.extent != Arc::Extent::between) return {centre, axis};
  if (ends_on_curve(wall) && orientation(centre, wall.from, wall.to) == Sign::positive) {
    const double half = 0.5 * form_of(wall.curve, wall.to - wall.from, {0, 0}).length;
    return {0.5 * wall.from + 0.5 * wall.to,
            axis * (half / std::fabs(form_size(kPlain, wall.curve)) + 0x1p-38)};
  }
  return {centre, std::max({axis, (wall.from - centre).norm(), (wall.to - centre).norm()})};
}
template <class Wall>
WallCells::Disc WallCells::disc_about(const Wall& wall) {
  const Bounds box = bounds_of(wall);
  return {box.centre(), (0.5 * box.size()).norm()};
}

// Cells of one size, as many as the walls need, and one more all round.
void WallCells::divide() {
  Bounds box;
  double extents = 0;
  visit_all([&](std::uint32_t i) {
    const Bounds own = walls_.visit(surface(i), [](const auto& wall) { return bounds_of(wall); });
    box.add(own);
    extents += own.size().sum() / static_cast<double>(count_);
  });
  const Vec2 size = box.size();
  const double larger = size.maxCoeff(),
               magnitude = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  if (!(larger > kLeastSize && magnitude < kMostSize)) return;
  const double wanted =
      std::min((of_curves_ ? kCellsACurve : kCellsAWall) * static_cast<double>(count_), kMostCells);
  const double narrow = std::max(size.minCoeff(), larger / wanted);
  side_ = std::max(std::sqrt(narrow / wanted * larger), larger * 0x1p-20);
  side_ = std::max(side_, extents / kCellsAcross);
  low_ = box.low - Vec2::Constant(side_);
  // Where doubles are as far apart as cells, places in them mean nothing.
  if (!(magnitude * 0x1p-30 < side_ * 0x1p10)) return;
  columns_ = static_cast<int>(size.x() / side_) + 3;
  rows_ = static_cast<int>(size.y() / side_) + 3;
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  begin_.assign(cells + 1, 0);
  const auto visit_passed = [&](const auto& visit) {
    visit_all([&](std::uint32_t i) {
      walls_.visit(surface(i), [&](const auto& wall) {
        visit_cells(wall, cells_of(bounds_of(wall)), [&](std::size_t cell) { visit(i, cell); });
      });
    });
  };
  visit_passed([&](std::uint32_t, std::size_t cell) { ++begin_[cell + 1]; });
  for (std::size_t i = 0; i < cells; ++i) begin_[i + 1] += begin_[i];
  listed_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  visit_passed([&](std::uint32_t i, std::size_t cell) { listed_[next[cell]++] = i; });
}

// Whether a part of a wall may lie in the box of half sides `half` about a point, which is seen from low_.
template <class Wall>
bool WallCells::may_pass(const Wall& wall, const Vec2& middle, const Vec2& half) const {
  return passes_near(wall, low_ + middle, half);
}
bool WallCells::may_pass(const Arc& arc, const Vec2& middle, const Vec2& half) const {
  const Bounds box = bounds_of(arc);
  const Vec2 below = box.low - low_ - middle, above = box.high - low_ - middle;
  if (below.x() > half.x() || below.y() > half.y() || above.x() < -half.x() ||
      above.y() < -half.y())
    return false;
  if (!ends_on_curve(arc)) return true;
  const Form form = form_of(arc.curve, low_ - arc.curve.centre + middle, half);
  const double r = std::fabs(form_size(kPlain, arc.curve));
  if (!(is_sound_form(r) && is_sound_form(form.length + form.most))) return true;
  return form.length - form.most <= r * (1 + 0x1p-40) &&
         form.length + form.most >= r * (1 - 0x1p-40);
}

template <class Wall, class Visit>
void WallCells::visit_cells(const Wall& wall, const Rect& rect, const Visit& visit) const {
  const auto [left, bottom, width, height] = rect;
  // They reach kMargin beyond the cells.
  const Vec2 half = side_ * Vec2(0.5 * width + kMargin, 0.5 * height + kMargin);
  if (!may_pass(wall, side_ * Vec2(left + 0.5 * width, bottom + 0.5 * height), half)) return;
  if (width == 1 && height == 1)
    return visit(static_cast<std::size_t>(bottom) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(left));
  const int w = width >= height ? width / 2 : width, h = width >= height ? height : height / 2;
  visit_cells(wall, {left, bottom, w, h}, visit);
  visit_cells(wall,
              width >= height ? Rect{left + w, bottom, width - w, height}
                              : Rect{left, bottom + h, width, height - h},
              visit);
}

// A ray along one axis of a grid, in cells, without branches as it goes.
struct WallCells::Axis {
  double origin, way, all;
  double inverse = way == 0 ? 1 : 1 / way;
  int step = way < 0 ? -1 : 1;
  int cell = 0, left = 0;        // the cell it is in, and how many are still to come
  double border = 0, by = step;  // of the cell, where the ray leaves it; from border to border

  // t at which the grid is entered and left; never entered where a ray that goes beside it misses it.
  double enter() const {
    if (way == 0) return origin < 0 || origin > all ? kInfinity : -kInfinity;
    return ((way > 0 ? 0 : all) - origin) * inverse;
  }
  double leave() const { return way == 0 ? kInfinity : ((way > 0 ? all : 0) - origin) * inverse; }
  void start(double t) {
    cell = static_cast<int>(std::clamp(std::floor(origin + t * way), 0.0, all - 1));
    left = step < 0 ? cell : static_cast<int>(all) - 1 - cell;
    border = way == 0 ? kInfinity : cell + (step > 0 ? 1 : 0);
  }
  double next() const { return (border - origin) * inverse; }
  void go(bool goes) {
    border += goes ? by : 0;
    left -= goes ? 1 : 0;
  }
};

// A ray beside discs, in doubles: what it meets of one lies within `radius` of the foot of its centre, and no farther
// beside it. Of a centre c of size M, as seen from the origin o, d x (c - o) and d . (c - o) are off by less than 5 u
// |d| (M + |o|), u = 2^-53; the centre itself by u M, a product for t by 8 u of the same: 16 u are allowed for.
class WallCells::DiscFilter {
 public:
  DiscFilter(const Ray& ray, double magnitude)
      : origin_(ray.origin),
        direction_(ray.direction),
        speed_((1 + 0x1p-50) * direction_.norm()),
        slack_(slack(magnitude + origin_.cwiseAbs().sum())),
        per_square_(1 / direction_.squaredNorm()) {}

  /// Whether the disc is surely not met, or later than what is settled.
  template <class Offers>
  bool rules_out(const Vec2& centre, double radius, const Offers& offers) const {
    const Vec2 w = centre - origin_;
    const double beside = direction_.x() * w.y() - direction_.y() * w.x();
    const double reach = radius * speed_ + slack_, ahead = direction_.dot(w);
    return std::fabs(beside) > reach || ahead + reach < 0 ||
           offers.settled((ahead - reach) * per_square_);
  }

 private:
  static bool is_sound(double size) { return size > kLeastSize && size < kMostSize; }
  double slack(double size) const {
    return is_sound(size) && is_sound(speed_) ? 0x1p-49 * speed_ * size : kInfinity;
  }

  const Vec2 origin_, direction_;
  const double speed_, slack_, per_square_;
};

template <class Offers>
void WallCells::walk(const Ray& ray, Offers& offers) const {
  FLATRAY_DCHECK(of_curves_);
  const DiscFilter filter(ray, magnitude_);
  const auto offer = [&](std::uint32_t curve) {
    const Disc& disc = discs_[curve];
    if (!filter.rules_out(disc.centre, disc.radius, offers))
      offers.offer_curve(walls_.curve_numbers[curve]);
  };
  const Vec2 origin = (ray.origin - low_) / side_, way = ray.direction / side_;
  const double speed = way.norm();
  const Vec2 all(columns_, rows_);
  if (begin_.empty() || !(speed > kLeastSize && speed < kMostSize) ||
      !(origin.cwiseAbs().maxCoeff() < kFar))
    return visit_all(offer);
  Axis x{origin.x(), way.x(), all.x()}, y{origin.y(), way.y(), all.y()};
  const double enter = std::max({0.0, x.enter(), y.enter()});
  const double leave = std::min({kInfinity, x.leave(), y.leave()});
  if (!(enter <= leave)) return;
  x.start(enter);
  y.start(enter);
  const double slack = kSlack / speed;
  const std::ptrdiff_t right = x.step, up = y.step * columns_;
  for (std::ptrdiff_t here = std::ptrdiff_t{y.cell} * columns_ + x.cell;;) {
    const auto at = begin_.begin() + here;
    for (std::uint32_t i = at[0]; i < at[1]; ++i) offer(listed_[i]);
    const double t_x = x.next(), t_y = y.next();
    if (offers.settled(std::min(t_x, t_y) - slack)) break;
    const bool across = t_x < t_y;
    here += across ? right : up;
    x.go(across);
    y.go(!across);
    if ((x.left | y.left) < 0) break;
  }
}

void WallCells::offer_to(Candidates& found, const Ray& ray) const {
  if (count_ > 0) walk(ray, found);
}

std::vector<std::uint32_t> WallCells::near(const Ray& ray) const {
  struct All {
    std::vector<std::uint32_t> surfaces{};
    void offer_curve(std::uint32_t surface) { surfaces.push_back(surface); }
    bool settled(double) const { return false; }
  } all;
  walk(ray, all);
  std::sort(all.surfaces.begin(), all.surfaces.end());
  all.surfaces.erase(std::unique(all.surfaces.begin(), all.surfaces.end()), all.surfaces.end());
  std::erase_if(all.surfaces, [&](std::uint32_t surface) {
    const auto filter = [&](const auto& wall) {
      return filter_curve(ray, wall, Root::none).verdict;
    };
    return walls_.visit(surface, filter) == FilteredHit::Verdict::missed;
  });
  return all.surfaces;
}

std::string WallCells::structure() const {
  if (of_curves_ && count_ == 0) return {};
  return counted(count_, of_curves_ ? "curve" : "wall") + " in " +
         (begin_.empty() ? "one list"
                         : std::to_string(columns_) + " x " + std::to_string(rows_) + " cells");
}

}  // namespace flatray
