// Moves between memory and the lanes of single_vector.h: records of four floats, one a lane, turned
// into columns; and the next values of a column spread over chosen lanes.
#include "trace/kernels/single_vector.h"

struct Record {
  Float ax, ay, bx, by;
};
// fetch: the records of all lanes, each from its address at(lane).

#if FLATRAY_LANES == 1
template <class At>
inline Record fetch(const At& at) {
  const float* r = at(0);
  return {r[0], r[1], r[2], r[3]};
}
inline Float spread(unsigned, const float* from, Float) { return *from; }
#elif FLATRAY_LANES == 2
template <class At>
inline Record fetch(const At& at) {
  const auto row = [&](int lane) { return load(at(lane)); };
  const Float r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
  const Float x01 = _mm_unpacklo_ps(r0, r1), x23 = _mm_unpacklo_ps(r2, r3);
  const Float y01 = _mm_unpackhi_ps(r0, r1), y23 = _mm_unpackhi_ps(r2, r3);
  return {_mm_movelh_ps(x01, x23), _mm_movehl_ps(x23, x01), _mm_movelh_ps(y01, y23),
          _mm_movehl_ps(y23, y01)};
}
inline Float spread(unsigned chosen, const float* from, Float others) {
  alignas(16) float lane[4];
  store(lane, others);
  for (int i = 0; i < 4; ++i)
    if ((chosen >> i & 1U) != 0) lane[i] = *from++;
  return load(lane);
}
#elif FLATRAY_LANES == 4
template <class At>
inline Record fetch(const At& at) {
  const auto row = [&](int lane) { return _mm_loadu_ps(at(lane)); };
  const auto rows = [&](int lane) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(row(lane)), row(lane + 4), 1);
  };
  const Float r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
  const Float x01 = _mm256_unpacklo_ps(r0, r1), x23 = _mm256_unpacklo_ps(r2, r3);
  const Float y01 = _mm256_unpackhi_ps(r0, r1), y23 = _mm256_unpackhi_ps(r2, r3);
  return {_mm256_shuffle_ps(x01, x23, 0x44), _mm256_shuffle_ps(x01, x23, 0xee),
          _mm256_shuffle_ps(y01, y23, 0x44), _mm256_shuffle_ps(y01, y23, 0xee)};
}
// The place in line of each lane that a set of lanes chooses.
struct Ranks {
  unsigned char of[256][8] = {};
  constexpr Ranks() {
    for (unsigned chosen = 0; chosen < 256; ++chosen) {
      unsigned char rank = 0;
      for (unsigned lane = 0; lane < 8; ++lane)
        if ((chosen >> lane & 1U) != 0) of[chosen][lane] = rank++;
    }
  }
};
constexpr Ranks kRanks;
inline Float spread(unsigned chosen, const float* from, Float others) {
  const auto* ranks = reinterpret_cast<const __m128i*>(kRanks.of[chosen]);
  const __m256i rank = _mm256_cvtepu8_epi32(_mm_loadl_epi64(ranks));
  return choose(lanes_of(chosen), _mm256_permutevar8x32_ps(load(from), rank), others);
}
#else
template <class At>
inline Record fetch(const At& at) {
  const auto row = [&](int lane) { return _mm_loadu_ps(at(lane)); };
  const auto rows = [&](int lane) {
    Float r = _mm512_setzero_ps();
    r = _mm512_maskz_insertf32x4(0xffff, r, row(lane), 0);
    r = _mm512_maskz_insertf32x4(0xffff, r, row(lane + 4), 1);
    r = _mm512_maskz_insertf32x4(0xffff, r, row(lane + 8), 2);
    return _mm512_maskz_insertf32x4(0xffff, r, row(lane + 12), 3);
  };
  const Float r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
  const Float x01 = _mm512_maskz_unpacklo_ps(0xffff, r0, r1);
  const Float x23 = _mm512_maskz_unpacklo_ps(0xffff, r2, r3);
  const Float y01 = _mm512_maskz_unpackhi_ps(0xffff, r0, r1);
  const Float y23 = _mm512_maskz_unpackhi_ps(0xffff, r2, r3);
  return {_mm512_maskz_shuffle_ps(0xffff, x01, x23, 0x44),
          _mm512_maskz_shuffle_ps(0xffff, x01, x23, 0xee),
          _mm512_maskz_shuffle_ps(0xffff, y01, y23, 0x44),
          _mm512_maskz_shuffle_ps(0xffff, y01, y23, 0xee)};
}
inline Float spread(unsigned chosen, const float* from, Float others) {
  return _mm512_mask_expandloadu_ps(others, static_cast<Mask>(chosen), from);
}
#endif
