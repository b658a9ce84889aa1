#include "render/coverage/pixel_rest.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

// Twice the area of the triangle of a piece and a point: positive on the piece's right.
double right_of(const Piece& p, double x, double y) {
  return (x - p.x_top) * (p.y_bottom - p.y_top) - (y - p.y_top) * (p.x_bottom - p.x_top);
}

}  // namespace

double PixelRest::Polygon::area() const {
  double twice = 0;
  for (std::size_t i = 2; i < count; ++i)
    twice += (x[i - 1] - x[0]) * (y[i] - y[0]) - (x[i] - x[0]) * (y[i - 1] - y[0]);
  return 0.5 * twice;
}

void PixelRest::begin() { polygons_.assign(1, {4, {0, 1, 1, 0}, {0, 0, 1, 1}}); }

bool PixelRest::can_cut(std::span<const Piece> pieces, int sign) {
  const auto inside = [sign](const Piece& of, const Piece& other) {
    const int side = sign * of.direction;
    const double top = side * right_of(of, other.x_top, other.y_top);
    const double bottom = side * right_of(of, other.x_bottom, other.y_bottom);
    return std::min(top, bottom) >= 0 && std::max(top, bottom) > 0;
  };
  for (const Piece& piece : pieces)
    if (piece.curve != nullptr || (piece.x_top == piece.x_bottom && piece.y_top == piece.y_bottom))
      return false;
  return pieces.size() == 1 || (pieces.size() == kMostOfItem && inside(pieces[0], pieces[1]) &&
                                inside(pieces[1], pieces[0]));
}

// Corners nearer to the line than rounding can tell are on it.
bool PixelRest::part(const Polygon& of, const Piece& piece, int sign, Polygon& in, Polygon& out) {
  const double length =
      std::abs(piece.x_bottom - piece.x_top) + std::abs(piece.y_bottom - piece.y_top);
  const auto side_of = [&](std::size_t i) {
    const double right = sign * piece.direction * right_of(piece, of.x[i], of.y[i]);
    return std::abs(right) < 0x1p-50 * length ? 0 : right;
  };
  in.count = out.count = 0;
  const std::size_t last = of.count - 1;
  double before = side_of(last);
  for (std::size_t i = 0, k = last; i < of.count; k = i++) {
    if (std::max(in.count, out.count) + 2 > of.x.size()) return false;
    const double here = side_of(i);
    if ((before < 0 && here > 0) || (before > 0 && here < 0)) {
      const double t = before / (before - here);
      const double x = of.x[k] + t * (of.x[i] - of.x[k]), y = of.y[k] + t * (of.y[i] - of.y[k]);
      in.add(x, y), out.add(x, y);
    }
    if (here >= 0) in.add(of.x[i], of.y[i]);
    if (here <= 0) out.add(of.x[i], of.y[i]);
    before = here;
  }
  return true;
}

std::optional<double> PixelRest::cut(std::span<const Piece> pieces, int sign) {
  next_.clear();
  double area = 0;
  for (Polygon& polygon : polygons_) {
    Polygon in, out;
    for (const Piece& piece : pieces) {
      if (!part(polygon, piece, sign, in, out)) return std::nullopt;
      if (out.count > 2) next_.push_back(out);
      polygon = in;
      if (in.count < 3) break;
    }
    area += polygon.area();
  }
  std::swap(polygons_, next_);
  return area;
}

double PixelRest::area() const {
  double area = 0;
  for (const Polygon& polygon : polygons_) area += polygon.area();
  return area;
}

}  // namespace flatray
