#include "trace/wall_cells.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/counted.h"
#include "geom/decide.h"
#include "trace/curve_filter.h"

namespace flatray {
namespace {

constexpr std::size_t kFew = 8;  // so many are looked at without cells
constexpr double kCellsAWall = 2, kMostCells = 0x1p22;
// Width and height of a wall in cells, on average: those that lie on one another, all as large as the grid, would pass
// the root of all cells each.
constexpr double kCellsAcross = 10;
constexpr double kMargin = 0x1p-10;  // of a cell's side, by which lists reach beyond it
constexpr double kFar = 0x1p30;      // cells away, where places are off by 2^-22
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

// Whether its ends are about as near to the curve as rounding leaves them: else it reaches beyond.
bool ends_on_curve(const Arc& arc) {
  if (arc.extent != Arc::Extent::between) return true;
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
  if (count_ > kFew) divide();
}

// Cells of one size, as many as the walls need, and one more all round.
void WallCells::divide() {
  Bounds box;
  double extents = 0;
  visit_all([&](std::uint32_t i) {
    const Bounds own = walls_.visit(i, [](const auto& wall) { return bounds_of(wall); });
    box.add(own);
    extents += own.size().sum() / static_cast<double>(count_);
  });
  const Vec2 size = box.size();
  const double larger = size.maxCoeff(),
               magnitude = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  if (!(larger > kLeastSize && magnitude < kMostSize)) return;
  const double wanted = std::min(kCellsAWall * static_cast<double>(count_), kMostCells);
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
      walls_.visit(i, [&](const auto& wall) {
        visit_cells(wall, cells_of(bounds_of(wall)), [&](std::size_t cell) { visit(i, cell); });
      });
    });
  };
  visit_passed([&](std::uint32_t, std::size_t cell) { ++begin_[cell + 1]; });
  for (std::size_t i = 0; i < cells; ++i) begin_[i + 1] += begin_[i];
  surfaces_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  visit_passed([&](std::uint32_t i, std::size_t cell) { surfaces_[next[cell]++] = i; });
}

// Whether a part of a wall may lie in the cells, or within kMargin of them.
template <class Wall>
bool WallCells::may_pass(const Wall& wall, const Rect& rect) const {
  const Vec2 half = side_ * Vec2(0.5 * rect.width + kMargin, 0.5 * rect.height + kMargin);
  const Vec2 middle = side_ * Vec2(rect.left + 0.5 * rect.width, rect.bottom + 0.5 * rect.height);
  return passes_near(wall, low_ + middle, half);
}

bool WallCells::may_pass(const Arc& arc, const Rect& rect) const {
  const Vec2 half = side_ * Vec2(0.5 * rect.width + kMargin, 0.5 * rect.height + kMargin);
  const Vec2 middle = side_ * Vec2(rect.left + 0.5 * rect.width, rect.bottom + 0.5 * rect.height);
  const Bounds box = bounds_of(arc);
  const Vec2 below = box.low - low_ - middle, above = box.high - low_ - middle;
  if (below.x() > half.x() || below.y() > half.y() || above.x() < -half.x() ||
      above.y() < -half.y())
    return false;
  if (!ends_on_curve(arc)) return true;
  const Form form = form_of(arc.curve, low_ - arc.curve.centre + middle, half);
  const double r = std::fabs(form_size(kPlain, arc.curve));
  return form.length - form.most <= r * (1 + 0x1p-40) &&
         form.length + form.most >= r * (1 - 0x1p-40);
}

template <class Wall, class Visit>
void WallCells::visit_cells(const Wall& wall, const Rect& rect, const Visit& visit) const {
  if (!may_pass(wall, rect)) return;
  const auto [left, bottom, width, height] = rect;
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

template <class Offers>
void WallCells::walk(const Ray& ray, Offers& offers) const {
  FLATRAY_DCHECK(of_curves_);
  const Vec2 origin = (ray.origin - low_) / side_, way = ray.direction / side_;
  const double speed = way.norm();
  const Vec2 all(columns_, rows_);
  if (begin_.empty() || !(speed > kLeastSize && speed < kMostSize) ||
      !(origin.cwiseAbs().maxCoeff() < kFar)) {
    return visit_all([&](std::uint32_t surface) { offers.offer_curve(surface); });
  }
  // t of what is to come on each axis: the side of the grid, then of each cell.
  double enter = 0, leave = kInfinity;
  for (int axis = 0; axis < 2; ++axis) {
    const double o = origin[axis], d = way[axis];
    if (d == 0) {
      if (o < 0 || o > all[axis]) return;
      continue;
    }
    enter = std::max(enter, ((d > 0 ? 0 : all[axis]) - o) / d);
    leave = std::min(leave, ((d > 0 ? all[axis] : 0) - o) / d);
  }
  const double slack = kSlack / speed;
  if (!(enter <= leave)) return;
  int cell[2];
  for (int axis = 0; axis < 2; ++axis)
    cell[axis] = static_cast<int>(
        std::clamp(std::floor(origin[axis] + enter * way[axis]), 0.0, all[axis] - 1));
  const auto next = [&](int axis) {
    if (way[axis] == 0) return kInfinity;
    return (cell[axis] + (way[axis] > 0 ? 1 : 0) - origin[axis]) / way[axis];
  };
  for (;;) {
    const std::size_t here =
        static_cast<std::size_t>(cell[1]) * static_cast<std::size_t>(columns_) +
        static_cast<std::size_t>(cell[0]);
    for (std::uint32_t i = begin_[here]; i < begin_[here + 1]; ++i)
      offers.offer_curve(surfaces_[i]);
    const double x = next(0), y = next(1);
    if (offers.settled(std::min(x, y) - slack)) break;
    const int axis = x < y ? 0 : 1;
    cell[axis] += way[axis] > 0 ? 1 : -1;
    if (cell[axis] < 0 || cell[axis] >= (axis == 0 ? columns_ : rows_)) break;
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
    return walls_.visit(surface, filter) == FilteredCurve::Verdict::missed;
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
