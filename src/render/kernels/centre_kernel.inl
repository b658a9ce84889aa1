// The kernel for pixel centres of one tier, included inside its namespace.

#include "render/kernels/row_lanes.inl"

typedef int32_t RowInts __attribute__((vector_size(sizeof(Rows) / 2)));
typedef int64_t RowMask __attribute__((vector_size(sizeof(Rows))));

// First row whose centre is at or below y: half down, exactly.
static inline double first_centre(double y) {
  const double nearest = (y + kRounder) - kRounder;
  return nearest - 0.5 >= y ? nearest - 1.0 : nearest;
}

// One edge at rows of centres, and where a column is in doubt.
struct CentreEdge {
  double x, y, slope, left, right, error;

  // The columns' first centres, clamped to the box: the nearest integer is right wherever x keeps
  // off the middle between two.
  RowInts columns(Rows row, Rows inside, RowMask& doubt) const {
    const Rows none = row * 0.0, low = none + left, high = none + right;
    const Rows at = x + (row + 0.5 - y) * slope;
    const Rows above = at > low ? at : low;
    const Rows v = above < high ? above : high;
    const Rows nearest = (v + kRounder) - kRounder;
    const Rows off = v - nearest, far = off < 0.0 ? -off : off;
    doubt |= (far + error >= 0.5) & (inside > 0.0);
    return __builtin_convertvector(nearest, RowInts);
  }
};

// Edges of the way down are written downwards, those of the way up upwards: the slack of one is
// written over by the next.
static size_t centre_runs(const Corner* ring, size_t count, const RowBox& box, int32_t* room,
                          Run* runs) {
  const double top = box.y, bottom = (double)box.y + box.height;
  int32_t* const down = room + kSlack;
  int32_t* const up = down + box.height + 2 * kSlack;
  double low = ring[0].x, high = low, lowest = ring[0].y;
  for (size_t i = 1; i < count; ++i) {
    low = ring[i].x < low ? ring[i].x : low;
    high = ring[i].x > high ? ring[i].x : high;
    lowest = ring[i].y > lowest ? ring[i].y : lowest;
  }
  const auto row_of = [&](double y) {
    return first_centre(y < top ? top : y > bottom ? bottom : y) - top;
  };
  const double far = -low > high ? -low : high;
  CentreEdge edge{0, 0, 0, (double)box.x, (double)box.x + box.width,
                  0x1p-53 * (6 * (high - low) + 2 * far + 8)};
  const Rows index = load<Rows>(kIndex);
  RowMask doubt = {};
  const double first = row_of(ring[0].y), last = row_of(lowest);
  double from = first;
  for (size_t i = 0; i < count; ++i) {
    const Corner &a = ring[i], &b = ring[i + 1 < count ? i + 1 : 0];
    const double to = row_of(b.y);
    if (from == to) continue;
    edge.x = a.x, edge.y = a.y, edge.slope = (b.x - a.x) / (b.y - a.y);
    if (from < to) {
      for (double row = from; row < to; row += kRows) {
        const Rows rows = index + row;
        store(down + (int32_t)row, edge.columns(rows + top, to - rows, doubt));
      }
    } else {
      for (double row = from; row > to; row -= kRows) {
        const Rows rows = index + (row - kRows);
        store(up + (int32_t)row - kRows, edge.columns(rows + top, rows - to + 0.5, doubt));
      }
    }
    from = to;
  }
  for (size_t i = 0; i < kRows; ++i)
    if (doubt[i] != 0) return kUndecided;
  Run* run = runs;
  for (int32_t row = (int32_t)first; row < (int32_t)last; ++row) {
    const int32_t begin = down[row] < up[row] ? down[row] : up[row];
    const int32_t end = down[row] < up[row] ? up[row] : down[row];
    *run = {box.y + row, begin, end, kFullSteps};
    run += begin < end ? 1 : 0;
  }
  return (size_t)(run - runs);
}
