// The lanes of src/trace/kernels/single_vector.h in double precision, four of them, by AVX2: for the walk
// of the kernels in plain doubles. Memory holds floats, so that what doubles cost is arithmetic alone.
constexpr int kLanes = 4;
using Float = __m256d;
using Int = __m256i;  // of 64 bits, as wide as a lane
using Mask = __m256d;
inline Float load(const float* from) { return _mm256_cvtps_pd(_mm_loadu_ps(from)); }
inline __m128i low_words(Int a) {
  const Int even = _mm256_permutevar8x32_epi32(a, _mm256_setr_epi32(0, 2, 4, 6, 0, 2, 4, 6));
  return _mm256_castsi256_si128(even);
}
inline void store(unsigned* to, Int a) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), low_words(a));
}
inline Float all(float value) { return _mm256_set1_pd(static_cast<double>(value)); }
inline Int all(int value) { return _mm256_set1_epi64x(value); }
inline Mask none() { return _mm256_setzero_pd(); }
inline Mask less(Float a, Float b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
inline Mask equal(Float a, Float b) { return _mm256_cmp_pd(a, b, _CMP_EQ_OQ); }
inline Mask both(Mask a, Mask b) { return _mm256_and_pd(a, b); }
inline Mask either(Mask a, Mask b) { return _mm256_or_pd(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm256_andnot_pd(b, a); }
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm256_movemask_pd(m)); }
inline Float choose(Mask m, Float yes, Float no) { return _mm256_blendv_pd(no, yes, m); }
inline Int choose(Mask m, Int yes, Int no) {
  return _mm256_castpd_si256(choose(m, _mm256_castsi256_pd(yes), _mm256_castsi256_pd(no)));
}
inline Float smaller(Float a, Float b) { return _mm256_min_pd(a, b); }
inline Float larger(Float a, Float b) { return _mm256_max_pd(a, b); }
inline Float size(Float a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
inline Float turned_by(Float sign, Float a) {
  return _mm256_xor_pd(a, _mm256_and_pd(_mm256_set1_pd(-0.0), sign));
}
inline Float with_sign_of(Float magnitude, Float sign) { return turned_by(sign, magnitude); }
inline Float fused(Float a, Float b, Float c) { return _mm256_fmadd_pd(a, b, c); }
inline Float fused_difference(Float a, Float b, Float c) { return _mm256_fmsub_pd(a, b, c); }
inline Float floor(Float a) { return _mm256_floor_pd(a); }
inline Int whole(Float a) { return _mm256_cvtepi32_epi64(_mm256_cvttpd_epi32(a)); }
inline Float real(Int a) { return _mm256_cvtepi32_pd(low_words(a)); }
inline Int word_bits(Float a) { return _mm256_castpd_si256(a); }
inline Mask negative(Int a) { return _mm256_castsi256_pd(a); }
inline Mask negative(Float a) { return a; }
// Of what was a float: its last bit is the 30th of a double.
inline Mask odd(Float a) { return _mm256_castsi256_pd(_mm256_slli_epi64(word_bits(a), 34)); }
inline Int next(Int a) { return _mm256_add_epi64(a, all(1)); }
inline Int low_seven(Int a) { return _mm256_and_si256(a, all(127)); }
inline Mask second_bit(Int a) { return _mm256_castsi256_pd(_mm256_slli_epi64(a, 33)); }
inline Float exponent_of(Int a) {
  return _mm256_cvtps_pd(_mm_castsi128_ps(_mm_and_si128(low_words(a), _mm_set1_epi32(0x7f800000))));
}
inline Int sixteenfold(Int a) { return _mm256_slli_epi64(_mm256_and_si256(a, all(0x7fffff)), 4); }
inline Int sum(Int a, Int b) { return _mm256_add_epi64(a, b); }
inline Int shifted(Int a, Int by) {
  return _mm256_srlv_epi64(_mm256_and_si256(a, _mm256_set1_epi64x(0xffffffff)), by);
}
inline Int gather(const unsigned* from, Int at) {
  alignas(16) unsigned i[kLanes];
  store(i, at);
  const auto word = [&](int lane) { return static_cast<int>(from[i[lane]]); };
  return _mm256_cvtepi32_epi64(_mm_setr_epi32(word(0), word(1), word(2), word(3)));
}
inline Mask lanes_of(unsigned chosen) {
  const auto up = _mm256_setr_epi64x(63, 62, 61, 60);
  return _mm256_castsi256_pd(_mm256_sllv_epi64(all(static_cast<int>(chosen)), up));
}

struct Record {
  Float ax, ay, bx, by;
};
template <class At>
inline Record fetch(const At& at) {
  const auto row = [&](int lane) { return _mm_loadu_ps(at(lane)); };
  __m128 r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
  _MM_TRANSPOSE4_PS(r0, r1, r2, r3);
  return {_mm256_cvtps_pd(r0), _mm256_cvtps_pd(r1), _mm256_cvtps_pd(r2), _mm256_cvtps_pd(r3)};
}
// The place in line of each lane that a set of lanes chooses.
struct Ranks {
  int of[16][kLanes] = {};
  constexpr Ranks() {
    for (unsigned chosen = 0; chosen < 16; ++chosen)
      for (int lane = 0, rank = 0; lane < kLanes; ++lane)
        if ((chosen >> lane & 1U) != 0) of[chosen][lane] = rank++;
  }
};
constexpr Ranks kRanks;
inline Float spread(unsigned chosen, const float* from, Float others) {
  const auto ranks = _mm_loadu_si128(reinterpret_cast<const __m128i*>(kRanks.of[chosen]));
  const __m128 values = _mm_permutevar_ps(_mm_loadu_ps(from), ranks);
  return choose(lanes_of(chosen), _mm256_cvtps_pd(values), others);
}
