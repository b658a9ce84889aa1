// The kernel itself, written once. Each tier's file includes this with FLATRAY_TIER and
// FLATRAY_LANES set. Meaning of what goes in and out: sweep.h.
//
// Lanes are edges: first the eight of a against all corners of b, then the eight of b against all
// corners of a. Of an edge with normal n, gap(t) = g + d t is how far the other shape is beyond it.
// A gap that is positive at both ends of a stretch of time is so all along, and proves a miss: any n
// gives a gap that is true for that n. An overlap is proven by the gaps of all true normals; their
// rounding, 2^-24 of the sizes, is part of the gap's allowance of 2^-19.
#include "collide/kernels/sweep.h"

namespace flatray::sweep {
namespace FLATRAY_TIER {
namespace {

typedef float Lanes __attribute__((vector_size(FLATRAY_LANES * 4)));
typedef float Four __attribute__((vector_size(16)));
typedef int Ints __attribute__((vector_size(FLATRAY_LANES * 4)));
constexpr int kParts = 2 * kCorners / FLATRAY_LANES;

constexpr float kFar = 0x1p126F;
#if FLATRAY_LANES == 8
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
  fill(lanes, kPart * FLATRAY_LANES < kCorners ? of_a : of_b);
}
template <int kPart>
FLATRAY_INLINE void load(Lanes& lanes, const float* of_a, const float* of_b) {
  constexpr int kFrom = kPart * FLATRAY_LANES;
  __builtin_memcpy(&lanes, kFrom < kCorners ? of_a + kFrom : of_b + (kFrom - kCorners),
                   sizeof lanes);
}

// The largest lane of each of four.
FLATRAY_INLINE void fold(const Lanes& lanes, Four& four) {
  float all[FLATRAY_LANES];
  __builtin_memcpy(all, &lanes, sizeof all);
  __builtin_memcpy(&four, all, sizeof four);
  for (int part = 1; part < FLATRAY_LANES / 4; ++part) {
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

// What has been found so far, by lane, as in Guess.
struct Found {
  Lanes enter, leave, first_gap, last_gap;
};

template <int kPart>
FLATRAY_INLINE void guess_part(const Pair& pair, float length, Found& found) {
  const Shape &a = *pair.a, &b = *pair.b;
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
  const Ints edge = (kFirstLanes + kPart * FLATRAY_LANES) |
                    ((Ints)least & (kCorners - 1)) * static_cast<int>(kCornerUnit);
  constexpr int kBits = static_cast<int>(kGuessBits);
  keep_larger(found.enter, change < 0.0F ? (Lanes)(((Ints)time & ~kBits) | edge) : -far);
  keep_larger(found.leave, change > 0.0F ? (Lanes)(((Ints)-time & ~kBits) | edge) : -far);
  keep_larger(found.first_gap, gap + pair.gap_error);
  keep_larger(found.last_gap, gap + pair.gap_error + length * (change + pair.way_error));
  found.enter = ((now > 0.0F) & (later > 0.0F)) ? 2 * far : found.enter;
}

FLATRAY_INLINE void guess_pair(const Pair& pair, float length, Guess& guess) {
  Found found;
  fill(found.enter, -kFar);
  found.leave = found.first_gap = found.last_gap = found.enter;
  guess_part<0>(pair, length, found);
  guess_part<1>(pair, length, found);
  if constexpr (kParts > 2) {
    guess_part<2>(pair, length, found);
    guess_part<3>(pair, length, found);
  }
  Four enter, leave, first, last, times, gaps;
  fold(found.enter, enter);
  fold(found.leave, leave);
  fold(found.first_gap, first);
  fold(found.last_gap, last);
  transpose_fold(enter, leave, times);
  transpose_fold(first, last, gaps);
  const Four low = __builtin_shufflevector(times, gaps, 0, 1, 4, 5);
  const Four high = __builtin_shufflevector(times, gaps, 2, 3, 6, 7);
  const Four all = low > high ? low : high;
  __builtin_memcpy(&guess, &all, sizeof guess);
}

void guess_all(const Pair* pairs, int count, float length, Guess* guesses) {
  for (int i = 0; i < count; ++i) guess_pair(pairs[i], length, guesses[i]);
}

}  // namespace

}  // namespace FLATRAY_TIER
}  // namespace flatray::sweep
