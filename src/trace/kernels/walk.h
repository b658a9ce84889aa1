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
//               to there it is within 10 u M of the box, and the next cell is rounded from a place
//               as near: 20 u M in all. Cells of divided cells are found from the same place, but
//               for one rounding of its distance from the cell's corner, by u / 2 at most.
// A hit later than the exit less kNear u M is left to the cells that follow, whose lists have it:
// kNear + 20 <= kMargin. So a wall listed in two cells rarely competes with itself.
namespace flatray::lanes {

// A direction component no smaller than this has an inverse; over the way through any grid that
// moves a ray by less than 2^-30 cells. Beyond these squares of its length a direction is not
// walked. Lanes and single rays must agree.
inline constexpr double kLeastStep = 0x1p-60;
inline constexpr double kLeastSquare = 0x1p-900, kLargestSquare = 0x1p900;

inline constexpr int kSide = 16, kTime = 33, kNear = 64, kMargin = 128;

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
  const unsigned* slots;  ///< of the segments of records
  const double* ends;     ///< ax, ay, bx, by of each segment, as given
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
  const unsigned* departed;  ///< slot of the segment just left, or kNone; null: of no ray
  float *departed_ax, *departed_ay, *departed_bx;  ///< of its records, NaN where there is none
  /// Where rays end, in lengths of their directions, whole vectors; null: nowhere.
  const double* up_to;
  float *end_low, *end_high;  ///< t between which that is, where rays end
  int count;
};

/// By ray: the slot of the wall that surely is the first met, at t > 0 and between its ends, or
/// kNoRecord (surely none), or kDoubt. Of rays that end: of any wall that surely is met before.
inline constexpr int kNoRecord = -1, kDoubt = -2;

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
  /// All of it for one ray, `departed` the slot of the segment just left or kNone; of every record where there
  /// are no cells. Numbers come in registers: to read together from memory what was just written one by one
  /// would wait for the ray before.
  SingleHit (*single_ray)(const Grid&, double ox, double oy, double dx, double dy,
                          unsigned departed);
};

}  // namespace flatray::lanes
