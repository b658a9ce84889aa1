#pragma once
#include <span>
#include <vector>

#include "render/coverage/composer.h"
#include "render/coverage/row_pieces.h"

namespace flatray {

/// A piece in a pixel, of the item at `seen`; or several that lie on one another.
struct PieceOf {
  const Piece* piece;
  std::uint32_t seen;
  int direction;       ///< of all
  double left, right;  ///< the least and the largest x
  double slope = 0;    ///< x by y
  /// At least how far it is beside its chord: the triangle of both is no larger than what lies
  /// between.
  double bend = 0;

  PieceOf(const Piece& of, std::uint32_t item);
};

/// The mean of the light that a pixel shows, over its area: it is cut into slabs between the ends and
/// crossings of all pieces, and each slab from piece to piece. So items are right that share the
/// pixel, whether they lie on, beside or across one another.
///
/// More than c pieces, if as many pairs of them pass by one another as among c, are a crowd, as
/// their crossings would cost the square: it is cut into 2 c^2 / n strips, no fewer than c.
///
/// Error   of the areas some 2^-49, as pieces are in doubles, and where two curves cross more than
///         twice within the pixel what lies between the further crossings. In a crowd light is
///         looked at along the middle of each strip, from piece to piece, or at 2 c places of it
///         where pieces and items are many, their product above the square of that: at most L / (2 s)
///         of the pixel in s strips, L the horizontal length of the pieces inside it.
/// Cost    for n pieces O(n^2) for their crossings, O(n log n) a slab; in a crowd its strips.
class PixelArea {
 public:
  explicit PixelArea(std::size_t crowd) : crowd_(crowd) {}

  /// Needs   the pieces, whose order may change; `seen` with the winding numbers just inside the
  ///         pixel's upper left corner.
  Light mean(std::vector<PieceOf>& pieces, SeenItems& seen, int row);

 private:
  struct Strand {
    double x;
    const PieceOf* of;
  };
  /// A strand and the light right of it.
  struct Lit {
    Light light;
    std::uint32_t seen;
    int direction;
  };
  struct Stretch {
    std::size_t begin, end;
  };
  struct LeftChange {
    double y;
    std::uint32_t seen;
    int direction;
  };
  void find_lefts(std::span<const PieceOf> pieces);
  void find_cuts(std::span<const PieceOf> pieces, int row);
  void find_strands(std::span<const PieceOf> pieces, double top, double bottom, int row);
  Stretch strands_to_light() const;
  void light_strands(SeenItems& seen, const Stretch& stretch);
  void add_slab(double height);

  std::vector<double> cuts_;
  std::vector<LeftChange> lefts_;
  std::vector<Strand> strands_;
  std::size_t next_ = 0;  ///< of the pieces, the first that lies below
  std::vector<Lit> lit_;  ///< the strands of the slab before
  Light left_{};          ///< of them all
  SummedLight sum_;
  std::size_t crowd_;  ///< c
  bool crowded_ = false;
};

/// What a piece adds to the integral of the winding number over its pixel. It raises the winding on
/// its right; where the edge crosses the left border, the winding along that border changes from
/// there down.
inline double area_right_of(const Piece& p) {
  double area = (p.y_bottom - p.y_top) * (1 - 0.5 * (p.x_top + p.x_bottom));
  if (p.curve != nullptr) area += p.curve->bow(p.x_bottom - p.x_top, p.y_bottom - p.y_top);
  if (p.left_top) area -= 1 - p.y_top;
  if (p.left_bottom) area += 1 - p.y_bottom;
  return p.direction * area;
}

}  // namespace flatray
