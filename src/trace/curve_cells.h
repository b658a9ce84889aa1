#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "geom/bounds.h"
#include "trace/candidates.h"
#include "trace/rays.h"
#include "trace/surfaces.h"

namespace flatray {

/// The curved walls of a scene by the cells of a grid that they pass, walked by one ray at a time in
/// double precision.
///
/// Gives   lists that hold every curve within 2^-10 of a cell's side of it; some 2 cells a curve.
///         Few curves, and those whose coordinates leave no room for sound arithmetic, are in no
///         cells: all of them are looked at.
/// Cost    to build O(n): curves pass some dozen cells on average, of a wider grid where they overlap. A ray: 20 ns a
///         curve near it, and what the exact decision of those in question takes.
class CurveCells {
 public:
  /// Needs   `walls` to outlive it.
  explicit CurveCells(const Surfaces& walls);

  /// Offers all curves that may be the first wall of the ray they are candidates of.
  void offer_to(Candidates& found, const Ray& ray) const;
  /// All curves that a ray may meet, ascending.
  std::vector<std::uint32_t> near(const Ray& ray) const;
  /// Shows every curve that comes within 4 ulps of a point, and others near it; some twice.
  template <class Visit>
  void visit_near(const Vec2& point, const Visit& visit) const {
    if (begin_.empty()) {
      for (const std::uint32_t surface : curves()) visit(surface);
      return;
    }
    // Where there are cells, 4 ulps of a place in them and its own rounding are under 2^-9 each.
    const Vec2 at = (point - low_) / side_;
    const auto last = [](double place, int count) {
      return static_cast<int>(std::clamp(place, -1.0, static_cast<double>(count)));
    };
    constexpr double kAround = 0x1p-7;
    for (int y = std::max(0, last(at.y() - kAround, rows_));
         y <= std::min(rows_ - 1, last(at.y() + kAround, rows_)); ++y)
      for (int x = std::max(0, last(at.x() - kAround, columns_));
           x <= std::min(columns_ - 1, last(at.x() + kAround, columns_)); ++x) {
        const std::size_t cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                                 static_cast<std::size_t>(x);
        for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) visit(surfaces_[i]);
      }
  }
  /// As Accelerator::structure() and cells(); no words without curves.
  std::string structure() const;
  std::size_t cells() const { return begin_.empty() ? 0 : begin_.size() - 1; }
  std::size_t bytes() const { return 4 * (begin_.size() + surfaces_.size()); }

 private:
  const std::vector<std::uint32_t>& curves() const { return walls_.curve_numbers; }
  struct Rect {
    int left, bottom, width, height;  // in cells
  };
  void divide();
  // Offers the curves of every cell a ray comes through, some twice, until these are settled.
  template <class Offers>
  void walk(const Ray& ray, Offers& offers) const;
  template <class Wall, class Visit>
  void visit_cells(const Wall& wall, const Rect& rect, const Visit& visit) const;
  bool may_pass(const Arc& arc, const Rect& rect) const;
  template <class Wall>
  bool may_pass(const Wall& wall, const Rect& rect) const;

  const Surfaces& walls_;
  std::vector<std::uint32_t> begin_, surfaces_;  // of each cell, row by row
  int columns_ = 0, rows_ = 0;
  Vec2 low_{0, 0};
  double side_ = 1;  // of a cell
};

}  // namespace flatray
