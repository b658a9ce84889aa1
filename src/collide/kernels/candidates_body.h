// Culls pairs by the edges of both, and finds the candidates of the others. Lanes are edges: first the
// eight of a against all corners of b, then the eight of b against all corners of a. Of an edge with
// normal n, gap(t) = g + d t is how far the other outline is beyond it. A gap that is positive at both
// ends of a stretch of time is so all along, and proves a miss: any n gives a gap that is true for that
// n. An overlap is proven by the gaps of all true normals; their rounding, 2^-24 of the sizes, is part
// of the gap's allowance of 2^-19.

#if FLATRAY_LANES >= 4
#define FLATRAY_FLOATS 8
#else
#define FLATRAY_FLOATS 4
#endif
typedef float Lanes __attribute__((vector_size(FLATRAY_FLOATS * 4)));
typedef float Four __attribute__((vector_size(16)));
typedef int Ints __attribute__((vector_size(FLATRAY_FLOATS * 4)));
constexpr int kParts = 2 * kCorners / FLATRAY_FLOATS;

constexpr float kFar = 0x1p126F;
#if FLATRAY_FLOATS == 8
constexpr Ints kFirstLanes = {0, 1, 2, 3, 4, 5, 6, 7};
#else
constexpr Ints kFirstLanes = {0, 1, 2, 3};
#endif

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
#ifdef __AVX512VL__
  lanes = (Lanes)_mm256_ternarylogic_epi32((__m256i)lanes, (__m256i)mask, (__m256i)bits, 0xEA);
#else
  lanes = (Lanes)(((Ints)lanes & mask) | bits);
#endif
}

FLATRAY_INLINE void fill(Lanes& lanes, float value) { lanes = value - Lanes{}; }

// A part of the lanes of a and b: `of_a` where they are edges of a, else `of_b`.
template <int kPart>
FLATRAY_INLINE void fill(Lanes& lanes, float of_a, float of_b) {
  fill(lanes, kPart * FLATRAY_FLOATS < kCorners ? of_a : of_b);
}
template <int kPart>
FLATRAY_INLINE void load(Lanes& lanes, const float* of_a, const float* of_b) {
  constexpr int kFrom = kPart * FLATRAY_FLOATS;
  __builtin_memcpy(&lanes, kFrom < kCorners ? of_a + kFrom : of_b + (kFrom - kCorners),
                   sizeof lanes);
}

// The largest lane of each of four.
FLATRAY_INLINE void fold(const Lanes& lanes, Four& four) {
  float all[FLATRAY_FLOATS];
  __builtin_memcpy(all, &lanes, sizeof all);
  __builtin_memcpy(&four, all, sizeof four);
  for (int part = 1; part < FLATRAY_FLOATS / 4; ++part) {
    Four next;
    __builtin_memcpy(&next, all + 4 * part, sizeof next);
    four = next > four ? next : four;
  }
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

template <int kPart>
FLATRAY_INLINE void look_at_part(const Approach& pair, float length, Best& best) {
  const Outline &a = *pair.a, &b = *pair.b;
  Lanes far, nx, ny, reach, cx, cy, wx, wy;
  fill(far, kFar);
  load<kPart>(nx, a.normal_x, b.normal_x);
  load<kPart>(ny, a.normal_y, b.normal_y);
  load<kPart>(reach, a.reach, b.reach);
  Lanes least = far;
  FLATRAY_UNROLL
  for (int k = 0; k < kCorners; ++k) {
    Lanes x, y;
    fill<kPart>(x, b.x[k], a.x[k]);
    fill<kPart>(y, b.y[k], a.y[k]);
    // The number of the corner in the last bits, which the allowance for rounding covers.
    Lanes along;
    dot(along, nx, ny, x, y);
    set_bits(along, Ints{} - kCorners, Ints{} + k);
    keep_smaller(least, along);
  }
  fill<kPart>(cx, pair.centre_x, -pair.centre_x);
  fill<kPart>(cy, pair.centre_y, -pair.centre_y);
  fill<kPart>(wx, pair.way_x, -pair.way_x);
  fill<kPart>(wy, pair.way_y, -pair.way_y);
  const Lanes gap = least + (nx * cx + ny * cy) - reach, change = nx * wx + ny * wy;
  const Lanes now = gap - pair.gap_error, later = now + length * (change - pair.way_error);
  Lanes time = -gap / change;
  keep_smaller(time, far);
  keep_larger(time, -far);
  const Ints edge = (kFirstLanes + kPart * FLATRAY_FLOATS) |
                    ((Ints)least & (kCorners - 1)) * static_cast<int>(kCornerUnit);
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
  look_at_part<0>(pair, length, best);
  look_at_part<1>(pair, length, best);
  if constexpr (kParts > 2) {
    look_at_part<2>(pair, length, best);
    look_at_part<3>(pair, length, best);
  }
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
