// One ray per lane in single precision: twice FLATRAY_LANES floats in a Float, whole numbers in an
// Int, a yes or no for each in a Mask, of which only the sign bit counts where lanes are chosen.
// Included by the kernel of one tier only, in a namespace of its own.
#if FLATRAY_LANES == 1
constexpr int kLanes = 1;
using Float = float;
using Int = int;
using Mask = bool;
inline Float load(const float* from) { return *from; }
inline Int load(const unsigned* from) { return static_cast<Int>(*from); }
inline void store(float* to, Float value) { *to = value; }
inline void store(unsigned* to, Int value) { *to = static_cast<unsigned>(value); }
inline Float all(float value) { return value; }
inline Int all(int value) { return value; }
inline Mask less(Float a, Float b) { return a < b; }
inline Mask equal(Float a, Float b) { return a == b; }
inline Mask equal(Int a, Int b) { return a == b; }
inline Mask both(Mask a, Mask b) { return a && b; }
inline Mask either(Mask a, Mask b) { return a || b; }
inline Mask but_not(Mask a, Mask b) { return a && !b; }
inline unsigned bits(Mask m) { return m ? 1 : 0; }
inline Float choose(Mask m, Float yes, Float no) { return m ? yes : no; }
inline Int choose(Mask m, Int yes, Int no) { return m ? yes : no; }
inline Float smaller(Float a, Float b) { return a < b ? a : b; }
inline Float larger(Float a, Float b) { return a > b ? a : b; }
inline Float size(Float a) { return __builtin_fabsf(a); }
inline Float with_sign_of(Float size, Float sign) { return __builtin_copysignf(size, sign); }
inline Float turned_by(Float sign, Float a) { return __builtin_signbitf(sign) ? -a : a; }
inline Float floor(Float a) { return __builtin_floorf(a); }
inline Float root(Float a) { return __builtin_sqrtf(a); }
inline Float fused(Float a, Float b, Float c) { return a * b + c; }
inline Float fused_difference(Float a, Float b, Float c) { return a * b - c; }
inline Int whole(Float a) { return static_cast<Int>(a); }
inline Float real(Int a) { return static_cast<Float>(a); }
inline Mask negative(Int a) { return a < 0; }
inline Mask odd(Float a) { return (__builtin_bit_cast(Int, a) & 1) != 0; }
inline Mask second_bit(Int a) { return (a >> 30 & 1) != 0; }
inline Int sixteenfold(Int a) { return (a & 0x7fffff) << 4; }
inline Int sum(Int a, Int b) { return a + b; }
inline Int shifted(Int a, Int by) { return static_cast<Int>(static_cast<unsigned>(a) >> by); }
inline Int gather(const unsigned* from, Int at) { return static_cast<Int>(from[at]); }
inline float least(Float a) { return a; }
inline Mask lanes_of(unsigned chosen) { return chosen != 0; }
#elif FLATRAY_LANES == 2
constexpr int kLanes = 4;
using Float = __m128;
using Int = __m128i;
using Mask = __m128;
inline Float load(const float* from) { return _mm_loadu_ps(from); }
inline Int load(const unsigned* from) {
  return _mm_loadu_si128(reinterpret_cast<const Int*>(from));
}
inline void store(float* to, Float value) { _mm_storeu_ps(to, value); }
inline void store(unsigned* to, Int value) { _mm_storeu_si128(reinterpret_cast<Int*>(to), value); }
inline Float all(float value) { return _mm_set1_ps(value); }
inline Int all(int value) { return _mm_set1_epi32(value); }
inline Mask less(Float a, Float b) { return _mm_cmplt_ps(a, b); }
inline Mask equal(Float a, Float b) { return _mm_cmpeq_ps(a, b); }
inline Mask equal(Int a, Int b) { return _mm_castsi128_ps(_mm_cmpeq_epi32(a, b)); }
inline Mask both(Mask a, Mask b) { return _mm_and_ps(a, b); }
inline Mask either(Mask a, Mask b) { return _mm_or_ps(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm_andnot_ps(b, a); }
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm_movemask_ps(m)); }
inline Float choose(Mask m, Float yes, Float no) {
  return _mm_or_ps(_mm_and_ps(m, yes), _mm_andnot_ps(m, no));
}
inline Int choose(Mask m, Int yes, Int no) {
  return _mm_castps_si128(choose(m, _mm_castsi128_ps(yes), _mm_castsi128_ps(no)));
}
inline Float smaller(Float a, Float b) { return _mm_min_ps(a, b); }
inline Float larger(Float a, Float b) { return _mm_max_ps(a, b); }
inline Float size(Float a) { return _mm_andnot_ps(_mm_set1_ps(-0.0F), a); }
inline Float with_sign_of(Float size, Float sign) {
  return _mm_or_ps(size, _mm_and_ps(_mm_set1_ps(-0.0F), sign));
}
inline Float turned_by(Float sign, Float a) {
  return _mm_xor_ps(a, _mm_and_ps(_mm_set1_ps(-0.0F), sign));
}
inline Float fused(Float a, Float b, Float c) { return a * b + c; }
inline Float fused_difference(Float a, Float b, Float c) { return a * b - c; }
inline Float root(Float a) { return _mm_sqrt_ps(a); }
inline Int whole(Float a) { return _mm_cvttps_epi32(a); }
inline Float real(Int a) { return _mm_cvtepi32_ps(a); }
inline Float floor(Float a) {  // of what an Int can hold
  const Float down = real(whole(a));
  return down - _mm_and_ps(_mm_cmplt_ps(a, down), _mm_set1_ps(1));
}
inline Mask negative(Int a) { return _mm_castsi128_ps(_mm_srai_epi32(a, 31)); }
inline Mask odd(Float a) { return negative(_mm_slli_epi32(_mm_castps_si128(a), 31)); }
inline Mask second_bit(Int a) { return negative(_mm_slli_epi32(a, 1)); }
inline Int sixteenfold(Int a) { return _mm_slli_epi32(_mm_and_si128(a, all(0x7fffff)), 4); }
inline Int sum(Int a, Int b) { return _mm_add_epi32(a, b); }
inline Int shifted(Int a, Int by) {
  alignas(16) unsigned word[4], count[4];
  store(word, a);
  store(count, by);
  for (int i = 0; i < 4; ++i) word[i] = word[i] >> count[i];
  return _mm_load_si128(reinterpret_cast<const Int*>(word));
}
inline Int gather(const unsigned* from, Int at) {
  alignas(16) unsigned i[4];
  store(i, at);
  const auto word = [&](int lane) { return static_cast<int>(from[i[lane]]); };
  return _mm_setr_epi32(word(0), word(1), word(2), word(3));
}
inline float least(Float a) {
  const Float b = _mm_min_ps(a, _mm_movehl_ps(a, a));
  return _mm_cvtss_f32(_mm_min_ss(b, _mm_shuffle_ps(b, b, 1)));
}
inline Mask lanes_of(unsigned chosen) {
  const int c = static_cast<int>(chosen);
  return negative(_mm_setr_epi32(c << 31, c << 30, c << 29, c << 28));
}
#elif FLATRAY_LANES == 4
constexpr int kLanes = 8;
using Float = __m256;
using Int = __m256i;
using Mask = __m256;
inline Float load(const float* from) { return _mm256_loadu_ps(from); }
inline Int load(const unsigned* from) {
  return _mm256_loadu_si256(reinterpret_cast<const Int*>(from));
}
inline void store(float* to, Float value) { _mm256_storeu_ps(to, value); }
inline void store(unsigned* to, Int value) {
  _mm256_storeu_si256(reinterpret_cast<Int*>(to), value);
}
inline Float all(float value) { return _mm256_set1_ps(value); }
inline Int all(int value) { return _mm256_set1_epi32(value); }
inline Mask less(Float a, Float b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
inline Mask equal(Float a, Float b) { return _mm256_cmp_ps(a, b, _CMP_EQ_OQ); }
inline Mask equal(Int a, Int b) { return _mm256_castsi256_ps(_mm256_cmpeq_epi32(a, b)); }
inline Mask both(Mask a, Mask b) { return _mm256_and_ps(a, b); }
inline Mask either(Mask a, Mask b) { return _mm256_or_ps(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm256_andnot_ps(b, a); }
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm256_movemask_ps(m)); }
inline Float choose(Mask m, Float yes, Float no) { return _mm256_blendv_ps(no, yes, m); }
inline Int choose(Mask m, Int yes, Int no) {
  return _mm256_castps_si256(choose(m, _mm256_castsi256_ps(yes), _mm256_castsi256_ps(no)));
}
inline Float smaller(Float a, Float b) { return _mm256_min_ps(a, b); }
inline Float larger(Float a, Float b) { return _mm256_max_ps(a, b); }
inline Float size(Float a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), a); }
inline Float with_sign_of(Float size, Float sign) {
  return _mm256_or_ps(size, _mm256_and_ps(_mm256_set1_ps(-0.0F), sign));
}
inline Float turned_by(Float sign, Float a) {
  return _mm256_xor_ps(a, _mm256_and_ps(_mm256_set1_ps(-0.0F), sign));
}
inline Float floor(Float a) { return _mm256_floor_ps(a); }
inline Float root(Float a) { return _mm256_sqrt_ps(a); }
inline Float fused(Float a, Float b, Float c) { return _mm256_fmadd_ps(a, b, c); }
inline Float fused_difference(Float a, Float b, Float c) { return _mm256_fmsub_ps(a, b, c); }
inline Int whole(Float a) { return _mm256_cvttps_epi32(a); }
inline Float real(Int a) { return _mm256_cvtepi32_ps(a); }
inline Mask negative(Int a) { return _mm256_castsi256_ps(a); }
inline Mask odd(Float a) {
  return _mm256_castsi256_ps(_mm256_slli_epi32(_mm256_castps_si256(a), 31));
}
inline Mask second_bit(Int a) { return _mm256_castsi256_ps(_mm256_slli_epi32(a, 1)); }
inline Int sixteenfold(Int a) { return _mm256_slli_epi32(_mm256_and_si256(a, all(0x7fffff)), 4); }
inline Int sum(Int a, Int b) { return _mm256_add_epi32(a, b); }
inline Int shifted(Int a, Int by) { return _mm256_srlv_epi32(a, by); }
inline Int gather(const unsigned* from, Int at) {
  alignas(32) unsigned i[8];
  store(i, at);
  const auto word = [&](int lane) { return static_cast<int>(from[i[lane]]); };
  return _mm256_setr_epi32(word(0), word(1), word(2), word(3), word(4), word(5), word(6), word(7));
}
inline float least(Float a) {
  const __m128 b = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
  const __m128 c = _mm_min_ps(b, _mm_movehl_ps(b, b));
  return _mm_cvtss_f32(_mm_min_ss(c, _mm_shuffle_ps(c, c, 1)));
}
inline Mask lanes_of(unsigned chosen) {
  const Int up = _mm256_setr_epi32(31, 30, 29, 28, 27, 26, 25, 24);
  return _mm256_castsi256_ps(_mm256_sllv_epi32(all(static_cast<int>(chosen)), up));
}
#else
constexpr int kLanes = 16;
using Float = __m512;
using Int = __m512i;
using Mask = __mmask16;
inline Float load(const float* from) { return _mm512_loadu_ps(from); }
inline Int load(const unsigned* from) { return _mm512_loadu_si512(from); }
inline void store(float* to, Float value) { _mm512_storeu_ps(to, value); }
inline void store(unsigned* to, Int value) { _mm512_storeu_si512(to, value); }
inline Float all(float value) { return _mm512_set1_ps(value); }
inline Int all(int value) { return _mm512_set1_epi32(value); }
inline Mask less(Float a, Float b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
inline Mask equal(Float a, Float b) { return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ); }
inline Mask equal(Int a, Int b) { return _mm512_cmpeq_epi32_mask(a, b); }
inline Mask both(Mask a, Mask b) { return _kand_mask16(a, b); }
inline Mask either(Mask a, Mask b) { return _kor_mask16(a, b); }
inline Mask but_not(Mask a, Mask b) { return _kandn_mask16(b, a); }
inline unsigned bits(Mask m) { return m; }
inline Float choose(Mask m, Float yes, Float no) { return _mm512_mask_blend_ps(m, no, yes); }
inline Int choose(Mask m, Int yes, Int no) { return _mm512_mask_blend_epi32(m, no, yes); }
inline Float smaller(Float a, Float b) { return _mm512_maskz_min_ps(0xffff, a, b); }
inline Float larger(Float a, Float b) { return _mm512_maskz_max_ps(0xffff, a, b); }
inline Float size(Float a) { return _mm512_abs_ps(a); }
inline Float with_sign_of(Float size, Float sign) {
  return _mm512_or_ps(size, _mm512_and_ps(_mm512_set1_ps(-0.0F), sign));
}
inline Float turned_by(Float sign, Float a) {
  return _mm512_xor_ps(a, _mm512_and_ps(_mm512_set1_ps(-0.0F), sign));
}
inline Float floor(Float a) {
  return _mm512_maskz_roundscale_ps(0xffff, a, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
inline Float fused(Float a, Float b, Float c) { return _mm512_fmadd_ps(a, b, c); }
inline Float fused_difference(Float a, Float b, Float c) { return _mm512_fmsub_ps(a, b, c); }
inline Float root(Float a) { return _mm512_maskz_sqrt_ps(0xffff, a); }
inline Int whole(Float a) { return _mm512_maskz_cvttps_epi32(0xffff, a); }
inline Float real(Int a) { return _mm512_maskz_cvtepi32_ps(0xffff, a); }
inline Mask negative(Int a) { return _mm512_movepi32_mask(a); }
inline Mask odd(Float a) { return _mm512_test_epi32_mask(_mm512_castps_si512(a), all(1)); }
inline Mask second_bit(Int a) { return _mm512_test_epi32_mask(a, all(0x40000000)); }
inline Int sixteenfold(Int a) {
  return _mm512_maskz_slli_epi32(0xffff, _mm512_and_si512(a, all(0x7fffff)), 4);
}
inline Int sum(Int a, Int b) { return _mm512_add_epi32(a, b); }
inline Int shifted(Int a, Int by) { return _mm512_maskz_srlv_epi32(0xffff, a, by); }
inline Int gather(const unsigned* from, Int at) {
  return _mm512_mask_i32gather_epi32(all(0), 0xffff, at, from, 4);
}
inline float least(Float a) { return _mm512_reduce_min_ps(a); }
inline Mask lanes_of(unsigned chosen) { return static_cast<Mask>(chosen); }
#endif
inline float most(Float a) { return -least(all(0.0F) - a); }
inline Mask none() { return Mask{}; }
inline Mask negative(Float a) { return negative(__builtin_bit_cast(Int, a)); }
inline Int next(Int a) { return sum(a, all(1)); }
inline Int low_seven(Int a) { return a & all(127); }
inline Float exponent_of(Int a) { return __builtin_bit_cast(Float, a & all(0x7f800000)); }
