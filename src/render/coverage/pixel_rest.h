#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "render/coverage/row_pieces.h"

namespace flatray {

/// What of a pixel is seen below items that were cut off it: convex polygons.
///
/// Error   of areas some 2^-50.
class PixelRest {
 public:
  static constexpr std::size_t kMostPieces = 8;  ///< of all items
  static constexpr std::size_t kMostOfItem = 2;

  PixelRest() { begin(); }
  /// All of the pixel.
  void begin();
  /// Whether within its pixel all of an item lies on the one side of each of its pieces: on their
  /// right, where `sign` times their direction is 1. False where that is not told at a glance.
  /// Needs   an item of which each side of a piece is inside or outside.
  static bool can_cut(std::span<const Piece> pieces, int sign);
  /// Cuts the item off. Gives its area; nullopt where rounding has made more corners than there is room for.
  std::optional<double> cut(std::span<const Piece> pieces, int sign);
  double area() const;

 private:
  struct Polygon {
    std::size_t count = 0;
    std::array<double, 4 + kMostPieces> x, y;

    void add(double px, double py) { x[count] = px, y[count++] = py; }
    double area() const;
  };
  static bool part(const Polygon& of, const Piece& piece, int sign, Polygon& in, Polygon& out);

  std::vector<Polygon> polygons_, next_;
};

}  // namespace flatray
