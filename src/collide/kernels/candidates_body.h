// Culls pairs by the edges of both, and finds the candidates of the others. Lanes are edges: first the
// eight of a against all corners of b, then the eight of b against all corners of a. Of an edge with
// normal n, gap(t) = g + d t is how far the other outline is beyond it. A gap that is positive at both
// ends of a stretch of time is so all along, and proves a miss: any n gives a gap that is true for that
// n. An overlap is proven by the gaps of all true normals; their rounding, 2^-24 of the sizes, is part
// of the gap's allowance of 2^-19.

typedef float Lanes __attribute__((vector_size(kCorners * 4)));
typedef float Four __attribute__((vector_size(16)));
typedef int Ints __attribute__((vector_size(kCorners * 4)));

constexpr float kFar = 0x1p126F;
constexpr Ints kEdges = {0, 1, 2, 3, 4, 5, 6, 7};

#define FLATRAY_INLINE inline __attribute__((always_inline))
#ifdef __clang__
#define FLATRAY_UNROLL _Pragma("unroll")
#else
#define FLATRAY_UNROLL _Pragma("GCC unroll 8")
#endif

#ifdef __AVX2__  // compilers make comparisons and choices of what is below
FLATRAY_INLINE void keep_smaller(Lanes& a, const Lanes& b) { a = _mm256_min_ps(b, a); }
FLATRAY_INLINE void keep_larger(Lanes& a, const Lanes& b) { a = _mm256_max_ps(b, a); }
FLATRAY_INLINE void dot(Lanes& to, const Lanes& ax, const Lanes& ay, const Lanes& bx,
                        const Lanes& by) {
  to = _mm256_fmadd_ps(ax, bx, ay * by);
}
#else
FLATRAY_INLINE void keep_smaller(Lanes& a, const Lanes& b) { a = b < a ? b : a; }
FLATRAY_INLINE void keep_larger(Lanes& a, const Lanes& b) { a = b > a ? b : a; }
FLATRAY_INLINE void dot(Lanes& to, const Lanes& ax, const Lanes& ay, const Lanes& bx,
                        const Lanes& by) {
  to = ax * bx + ay * by;
}
#endif
// Other last bits: those of `bits` where `mask` has none.
FLATRAY_INLINE void set_bits(Lanes& lanes, const Ints& mask, const Ints& bits) {
  lanes = (Lanes)(((Ints)lanes & mask) | bits);
}

FLATRAY_INLINE void fill(Lanes& lanes, float value) { lanes = value - Lanes{}; }

FLATRAY_INLINE void load(Lanes& lanes, const float* from) {
  __builtin_memcpy(&lanes, from, sizeof lanes);
}

// The largest lane of each of four.
FLATRAY_INLINE void fold(const Lanes& lanes, Four& four) {
  const Four low = __builtin_shufflevector(lanes, lanes, 0, 1, 2, 3);
  const Four high = __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7);
  four = high > low ? high : low;
}
FLATRAY_INLINE void transpose_fold(const Four& a, const Four& b, Four& both) {
  const Four low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Four high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  both = low > high ? low : high;
}

// What has been found so far, by lane, as in Candidates.
struct Best {
  Lanes enter, leave, first_gap, last_gap;
};

// The edges of one outline against the corners of the other, whose centre is at `sign` times that of b.
FLATRAY_INLINE void look_at_edges(const Approach& pair, const Outline& edges,
                                  const Outline& corners, float sign, int number, float length,
                                  Best& best) {
  Lanes far, nx, ny, reach;
  fill(far, kFar);
  load(nx, edges.normal_x);
  load(ny, edges.normal_y);
  load(reach, edges.reach);
  Lanes least = far;
  FLATRAY_UNROLL
  for (int k = 0; k < kCorners; ++k) {
    Lanes x, y;
    fill(x, corners.x[k]);
    fill(y, corners.y[k]);
    // The number of the corner in the last bits, which the allowance for rounding covers.
    Lanes along;
    dot(along, nx, ny, x, y);
    set_bits(along, Ints{} - kCorners, Ints{} + k);
    keep_smaller(least, along);
  }
  const Lanes gap = least + (nx * (sign * pair.centre_x) + ny * (sign * pair.centre_y)) - reach;
  const Lanes change = nx * (sign * pair.way_x) + ny * (sign * pair.way_y);
  const Lanes now = gap - pair.gap_error, later = now + length * (change - pair.way_error);
  Lanes time = -gap / change;
  keep_smaller(time, far);
  keep_larger(time, -far);
  const Ints edge =
      (kEdges + number) | ((Ints)least & (kCorners - 1)) * static_cast<int>(kCornerUnit);
  constexpr int kBits = static_cast<int>(kCandidateBits);
  keep_larger(best.enter, change < 0.0F ? (Lanes)(((Ints)time & ~kBits) | edge) : -far);
  keep_larger(best.leave, change > 0.0F ? (Lanes)(((Ints)-time & ~kBits) | edge) : -far);
  keep_larger(best.first_gap, gap + pair.gap_error);
  keep_larger(best.last_gap, gap + pair.gap_error + length * (change + pair.way_error));
  best.enter = ((now > 0.0F) & (later > 0.0F)) ? 2 * far : best.enter;
}

FLATRAY_INLINE void look_at_pair(const Approach& pair, float length, Candidates& found) {
  Best best;
  fill(best.enter, -kFar);
  best.leave = best.first_gap = best.last_gap = best.enter;
  look_at_edges(pair, *pair.a, *pair.b, 1, 0, length, best);
  look_at_edges(pair, *pair.b, *pair.a, -1, kCorners, length, best);
  Four enter, leave, first, last, times, gaps;
  fold(best.enter, enter);
  fold(best.leave, leave);
  fold(best.first_gap, first);
  fold(best.last_gap, last);
  transpose_fold(enter, leave, times);
  transpose_fold(first, last, gaps);
  const Four low = __builtin_shufflevector(times, gaps, 0, 1, 4, 5);
  const Four high = __builtin_shufflevector(times, gaps, 2, 3, 6, 7);
  const Four all = low > high ? low : high;
  __builtin_memcpy(&found, &all, sizeof found);
}

void find_candidates(const Approach* pairs, int count, float length, Candidates* found) {
  for (int i = 0; i < count; ++i) look_at_pair(pairs[i], length, found[i]);
}
