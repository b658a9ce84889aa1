#pragma once

// What the kernels of the grid tracer take and give: plain data only, as in lanes.h.
//
// Rays walk through a grid of square cells, one ray in each single-precision lane, and test the
// walls of each cell they cross. Coordinates are in cells, the middle of the grid being 0, so that
// none is above M (`reach`) in size: X = (x - centre) * scale, rounded to float. Directions are
// made unit length in these coordinates before they are rounded, so t counts cells.
//
// Bounds, with u = 2^-24, the walk being right where a wall is in the list of every cell it comes
// within kMargin u M of:
//   input       A, B, o are off by u M a coordinate, B_y by 2 u M for its last bit, d by a factor
//               1 + u; the double arithmetic before that by less than u M / 100.
// Tiers with fused products round some sums once where twice is allowed for.
//   side        s_A = d x (A - o), and length t_A = d . (A - o): differences are off by 4 u M, in
//               B_y by 5, which gives 6.41 u M; d gives 2.83 u M, the products 2.83 u M, their sum
//               2.83 u M, together below e = 15 u M. kSide = 16.
//   hit         with s_A, s_B of opposite sign beyond that, t = t_A + s_A r, r = (t_B - t_A) /
//               (s_A - s_B), is off by e (1 + |r|), as its weights s_A / (s_A - s_B) are off by
//               e / |s_A - s_B|; by 14.2 u M for its own roundings, and t +- error by 2.9 u M more.
//               kTime = 33, and kSide for the slope.
//   no hit      a wall that is not surely crossed meets the ray, if at all, between t_A and t_B.
//   end         t of the end of a ray that ends is off by less than u M / 10 and 2^-50 of itself in
//               doubles, and by u of itself once it is a float; 2 u M and 2^-22 of itself are
//               allowed for.
//   place       the ray leaves a box of cells at the least t of its two exit planes as computed; up
//               to there it is within 12 u M of the box, and the next cell is rounded from a place
//               as near: 24 u M in all. Cells of divided cells are found from the same place, but
//               for one rounding of its distance from the cell's corner, by u / 2 at most.
// A hit later than the exit less kNear u M is left to the cells that follow, whose lists have it:
// kNear + 24 <= kMargin. So a wall listed in two cells rarely competes with itself.
//
// Curves lie in cells of their own. In the form in which a curve is the circle |p| = r (Curve), whose
// map has no entry above 1 and lengthens nothing, p is the form of centre - o and g that of d:
//   form        p is off by 5.7 u M for the difference, 4.3 u M for the map's entries and 6.9 u M for
//               its products; g by 5.5 u. So k = g x p and b = p . g are off by 39 u M, a = g . g by
//               13 u. kCurve = 56, kForm = 2^-19 = 32 u.
//   chord       q = r^2 a - k^2 by 2 |k| e + e^2, e = kCurve u M, and kForm (r^2 + k^2); its root h by
//               that over h, as q is surely positive.
//   hit         t = (b -+ h) / a by (e + that + kForm |t|) / a.
//   part        the point p - t g, of length r, is in the part where its product with the unit
//               vector `middle` is below -r cut: off by what t is and kPart u M, kPart = 96.
namespace flatray::lanes {

// A direction component no smaller than this has an inverse; over the way through any grid that
// moves a ray by less than 2^-30 cells. Beyond these squares of its length a direction is not
// walked. Lanes and single rays must agree.
inline constexpr double kLeastStep = 0x1p-60;
inline constexpr double kLeastSquare = 0x1p-900, kLargestSquare = 0x1p900;

inline constexpr int kSide = 16, kTime = 33, kNear = 64, kMargin = 128;
inline constexpr int kCurve = 56, kPart = 96;
inline constexpr float kForm = 0x1p-19F;

/// A curve in cells, in a form in which it is a circle. Its records are the centre and radius of a disc
/// that holds it, and four times its slot, with two more where the curve is that disc's whole circle.
struct Curve {
  float centre_x, centre_y, radius;  ///< radius: of the form
  /// 0, or infinite of a curve that has no such form, which the lanes are never sure of.
  float doubt;
  float form_xx, form_xy, form_yx, form_yy;  ///< the map of vectors to their forms
  float middle_x, middle_y, cut, spare;      ///< of a part; cut = -4 of a whole curve

  bool operator==(const Curve&) const = default;
};

/// Cells row by row, with a ring of empty ones around.
///
/// A cell of walls is the number of its first record; they go on to the one with an odd last word.
/// An empty cell has the sign bit and four times seven bits: the side of the square of empty cells
/// that grows from it towards +x +y, -x +y, +x -y, -x -y. In the ring the sides are 0.
/// A crowded cell is divided: its word is the float n = 2, 4, ... with a sixteenth of the index of
/// its n x n cells, row by row, in place of the fraction. Of its bits 31 and 30 only the second is
/// set; of a cell of walls neither. Squares of empty cells end where the divided cell does.
struct Grid {
  const unsigned* cells;
  const float* records;   ///< ax, ay, bx, by of a wall in a cell; three more may be read
  const unsigned* slots;  ///< of the walls of records
  /// ax, ay, bx, by of each segment, as given; of a curve the centre and radius of its circle and 0, or all 0.
  const double* ends;
  const Curve* curves;  ///< by slot, where the walls are curves; else null
  double centre_x, centre_y, scale_x, scale_y;
  double half_x, half_y;  ///< rays from farther out start where they enter this box
  double ring_x, ring_y;  ///< a place in the ring
  double far;             ///< of origins whose place is not certain enough
  float stride, first;    ///< cell of corner (x, y): first + stride * y + x
  float unit;             ///< u M
  bool is_large;          ///< for the second cache: records are fetched ahead
};

/// Rays as they walk, in columns with room for a whole vector beyond the last.
struct Walking {
  const float* number;                               ///< 0, 1, 2, ...
  float *ox, *oy, *dx, *dy, *inverse_x, *inverse_y;  ///< the inverses without their signs
  const unsigned* departed;  ///< slot of the wall just left, or kNone; null: of no ray
  const unsigned* roots;  ///< of a curve just left: 1 for the first, 2 for the second, 3 for both
  /// Of the record of that segment, NaN where there is none; of a curve its slot, as bits, and its roots.
  float *departed_ax, *departed_ay, *departed_bx;
  /// Where rays end, in lengths of their directions, whole vectors; null: nowhere.
  const double* up_to;
  bool is_first;              ///< of rays that end: whether the first wall is asked
  float *end_low, *end_high;  ///< t between which that is, where rays end
  int count;
};

/// By ray: the slot of the wall that surely is the first met, at t > 0 and between its ends, or
/// kNoRecord (surely none), or kDoubt. Of rays that end: of one that surely is met before; the first or any.
/// Of curves met in their second root kSecond is added.
inline constexpr int kNoRecord = -1, kDoubt = -2, kSecond = 1 << 30;

inline constexpr unsigned kNone = 0xffffffffU;  ///< no slot

/// Rays as given.
struct Rays {
  const double *ox, *oy, *dx, *dy;
  int count;  ///< whole vectors are read: a multiple of kWidest
};

/// What the rays have found, and where their answers go: 16 bytes each, a word and t. Of a ray that
/// meets a wall the word is `met` and the slot of its segment, of others `missed`, and t infinite.
struct Finish {
  const int* found;
  int count;
  void* answers;
  unsigned long met, missed;
  int* open;  ///< gets the numbers of rays whose answer, or its t, is not certain
};

/// What a ray alone meets: `found` as of rays that walk in lanes, the slot of the segment, its t, which is NaN
/// where it is not certain.
struct SingleHit {
  int found;
  unsigned slot;
  double t;
};

/// Rays that have found curves, and where their t go.
struct CurvesMet {
  const int* rays;   ///< their numbers among the rays as given
  const int* found;  ///< by ray as given
  int count;
  double* t;  ///< by place among these; whole vectors are written. NaN where t is not certain
};

/// Who asks for the lists of the cells a ray comes through: what is told the first record of each, and whether what is
/// met later than t, in lengths of the direction, does not matter.
struct ListVisitor {
  void* who;
  void (*list)(void* who, unsigned record);
  bool (*is_settled)(void* who, double t);
};

struct WalkKernels {
  /// Fills `walking` but for `departed` and `up_to`. Of rays that cannot walk `fate` becomes kDoubt; whether
  /// there are any. Rays that miss the grid start in the ring.
  bool (*prepare)(const Grid&, const Rays&, const Walking&, int* fate);
  void (*walk)(const Grid&, const Walking&, int* found);
  /// The same without cells: every record against every ray. `found` may be written up to the next
  /// whole vector.
  void (*scan)(const Grid&, const Walking&, int* found);
  /// Gives how many rays are open.
  int (*finish)(const Grid&, const Rays&, const Finish&);
  /// t of circles, of which `ends` hold centre_x, centre_y, radius, which is 0 of what is none.
  void (*finish_curves)(const Grid&, const Rays&, const CurvesMet&);
  /// All of it for one ray, `departed` the slot of the segment just left or kNone; of every record where there
  /// are no cells. Numbers come in registers: to read together from memory what was just written one by one
  /// would wait for the ray before.
  SingleHit (*single_ray)(const Grid&, double ox, double oy, double dx, double dy,
                          unsigned departed);
  /// The same of curves, `found` with kSecond: the first that surely is met before `up_to`.
  SingleHit (*single_curve)(const Grid&, double ox, double oy, double dx, double dy,
                            unsigned departed, unsigned roots, double up_to);
  /// Shows the lists of the cells a ray comes through, in order, of segments or curves; false where it is not certain
  /// which these are.
  bool (*visit_lists)(const Grid&, double ox, double oy, double dx, double dy, const ListVisitor&);
};

}  // namespace flatray::lanes
