// One ray per lane in single precision: twice FLATRAY_LANES floats in a Float, whole numbers in an
// Int, a yes or no for each in a Mask, of which only the sign bit counts where lanes are chosen.
// Included by the kernel of one tier only, in a namespace of its own.
#if FLATRAY_LANES == 1
constexpr int kLanes = 1;
using Float = float;
using Int = int;
using Unsigned = unsigned;
#else
constexpr int kLanes = 2 * FLATRAY_LANES;
typedef float Float __attribute__((vector_size(8 * FLATRAY_LANES)));
typedef int Int __attribute__((vector_size(8 * FLATRAY_LANES)));
typedef unsigned Unsigned __attribute__((vector_size(8 * FLATRAY_LANES)));
#endif
inline Float as_float(Int bits) { return __builtin_bit_cast(Float, bits); }
inline Int as_int(Float a) { return __builtin_bit_cast(Int, a); }
inline Float load(const float* from) {
  Float loaded;
  __builtin_memcpy(&loaded, from, sizeof loaded);
  return loaded;
}
inline Int load(const unsigned* from) {
  Int loaded;
  __builtin_memcpy(&loaded, from, sizeof loaded);
  return loaded;
}
inline void store(float* to, Float value) { __builtin_memcpy(to, &value, sizeof value); }
inline void store(unsigned* to, Int value) { __builtin_memcpy(to, &value, sizeof value); }
inline Float all(float value) { return value - Float{}; }  // + 0 would lose -0
inline Int all(int value) { return value - Int{}; }
inline Int sum(Int a, Int b) { return a + b; }
inline Int shifted(Int a, Int by) {
  return __builtin_bit_cast(Int,
                            __builtin_bit_cast(Unsigned, a) >> __builtin_bit_cast(Unsigned, by));
}
inline Int sixteenfold(Int a) { return (a & 0x7fffff) << 4; }

#if FLATRAY_LANES == 1
using Mask = bool;
inline Mask less(Float a, Float b) { return a < b; }
inline Mask equal(Float a, Float b) { return a == b; }
inline Mask equal(Int a, Int b) { return a == b; }
inline Mask both(Mask a, Mask b) { return a && b; }
inline Mask either(Mask a, Mask b) { return a || b; }
inline Mask but_not(Mask a, Mask b) { return a && !b; }
inline unsigned bits(Mask m) { return m ? 1 : 0; }
inline Float choose(Mask m, Float yes, Float no) { return m ? yes : no; }
inline Int choose(Mask m, Int yes, Int no) { return m ? yes : no; }
inline Float size(Float a) { return __builtin_fabsf(a); }
inline Float with_sign_of(Float size, Float sign) { return __builtin_copysignf(size, sign); }
inline Float turned_by(Float sign, Float a) { return __builtin_signbitf(sign) ? -a : a; }
inline Float floor(Float a) { return __builtin_floorf(a); }
inline Float root(Float a) { return __builtin_sqrtf(a); }
inline Int whole(Float a) { return static_cast<Int>(a); }
inline Float real(Int a) { return static_cast<Float>(a); }
inline Mask negative(Int a) { return a < 0; }
inline Mask odd(Float a) { return (as_int(a) & 1) != 0; }
inline Mask second_bit(Int a) { return (a >> 30 & 1) != 0; }
inline Int gather(const unsigned* from, Int at) { return static_cast<Int>(from[at]); }
inline float least(Float a) { return a; }
inline Mask lanes_of(unsigned chosen) { return chosen != 0; }
#elif FLATRAY_LANES < 8
using Mask = Float;
inline Mask less(Float a, Float b) { return as_float(a < b); }
inline Mask equal(Float a, Float b) { return as_float(a == b); }
inline Mask equal(Int a, Int b) { return as_float(a == b); }
inline Int whole(Float a) { return __builtin_convertvector(a, Int); }
inline Float real(Int a) { return __builtin_convertvector(a, Float); }
#if FLATRAY_LANES == 2
inline Mask both(Mask a, Mask b) { return _mm_and_ps(a, b); }
inline Mask either(Mask a, Mask b) { return _mm_or_ps(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm_andnot_ps(b, a); }
inline Mask differ(Mask a, Mask b) { return _mm_xor_ps(a, b); }
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm_movemask_ps(m)); }
inline Float choose(Mask m, Float yes, Float no) { return either(both(m, yes), but_not(no, m)); }
inline Float smaller(Float a, Float b) { return _mm_min_ps(a, b); }
inline Float larger(Float a, Float b) { return _mm_max_ps(a, b); }
inline Float root(Float a) { return _mm_sqrt_ps(a); }
inline Float floor(Float a) {  // of what an Int can hold
  const Float down = real(whole(a));
  return down - both(less(a, down), all(1.0F));
}
inline Mask negative(Int a) { return as_float(a >> 31); }
inline Int gather(const unsigned* from, Int at) {
  alignas(16) unsigned i[4];
  store(i, at);
  const auto word = [&](int lane) { return static_cast<int>(from[i[lane]]); };
  return Int{word(0), word(1), word(2), word(3)};
}
inline float least(Float a) {
  const Float b = smaller(a, _mm_movehl_ps(a, a));
  return _mm_cvtss_f32(_mm_min_ss(b, _mm_shuffle_ps(b, b, 1)));
}
inline Mask lanes_of(unsigned chosen) {
  return negative(all(static_cast<int>(chosen)) << Int{31, 30, 29, 28});
}
#else
inline Mask both(Mask a, Mask b) { return _mm256_and_ps(a, b); }
inline Mask either(Mask a, Mask b) { return _mm256_or_ps(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm256_andnot_ps(b, a); }
inline Mask differ(Mask a, Mask b) { return _mm256_xor_ps(a, b); }
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm256_movemask_ps(m)); }
inline Float choose(Mask m, Float yes, Float no) { return _mm256_blendv_ps(no, yes, m); }
inline Float root(Float a) { return _mm256_sqrt_ps(a); }
inline Float floor(Float a) { return _mm256_floor_ps(a); }
inline Mask negative(Int a) { return as_float(a); }
inline Int gather(const unsigned* from, Int at) {
  alignas(32) unsigned i[8];
  store(i, at);
  const auto word = [&](int lane) { return static_cast<int>(from[i[lane]]); };
  return Int{word(0), word(1), word(2), word(3), word(4), word(5), word(6), word(7)};
}
inline float least(Float a) {
  const __m128 b = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
  const __m128 c = _mm_min_ps(b, _mm_movehl_ps(b, b));
  return _mm_cvtss_f32(_mm_min_ss(c, _mm_shuffle_ps(c, c, 1)));
}
inline Mask lanes_of(unsigned chosen) {
  return negative(all(static_cast<int>(chosen)) << Int{31, 30, 29, 28, 27, 26, 25, 24});
}
#endif
inline Int choose(Mask m, Int yes, Int no) {
  return as_int(choose(m, as_float(yes), as_float(no)));
}
inline Float size(Float a) { return but_not(a, all(-0.0F)); }
inline Float with_sign_of(Float size, Float sign) { return either(size, both(all(-0.0F), sign)); }
inline Float turned_by(Float sign, Float a) { return differ(a, both(all(-0.0F), sign)); }
inline Mask odd(Float a) { return negative(as_int(a) << 31); }
inline Mask second_bit(Int a) { return negative(a << 1); }
#else
using Mask = __mmask16;
inline __m512i ints(Int a) { return __builtin_bit_cast(__m512i, a); }
inline Mask less(Float a, Float b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
inline Mask equal(Float a, Float b) { return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ); }
inline Mask equal(Int a, Int b) { return _mm512_cmpeq_epi32_mask(ints(a), ints(b)); }
inline Mask both(Mask a, Mask b) { return _kand_mask16(a, b); }
inline Mask either(Mask a, Mask b) { return _kor_mask16(a, b); }
inline Mask but_not(Mask a, Mask b) { return _kandn_mask16(b, a); }
inline unsigned bits(Mask m) { return m; }
inline Float choose(Mask m, Float yes, Float no) { return _mm512_mask_blend_ps(m, no, yes); }
inline Int choose(Mask m, Int yes, Int no) {
  return __builtin_bit_cast(Int, _mm512_mask_blend_epi32(m, ints(no), ints(yes)));
}
inline Float size(Float a) { return _mm512_abs_ps(a); }
inline Float with_sign_of(Float size, Float sign) {
  return _mm512_or_ps(size, _mm512_and_ps(all(-0.0F), sign));
}
inline Float turned_by(Float sign, Float a) {
  return _mm512_xor_ps(a, _mm512_and_ps(all(-0.0F), sign));
}
inline Float floor(Float a) {
  return _mm512_maskz_roundscale_ps(0xffff, a, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
inline Float root(Float a) { return _mm512_maskz_sqrt_ps(0xffff, a); }
inline Int whole(Float a) { return __builtin_convertvector(a, Int); }
inline Float real(Int a) { return __builtin_convertvector(a, Float); }
inline Mask negative(Int a) { return _mm512_movepi32_mask(ints(a)); }
inline Mask odd(Float a) { return _mm512_test_epi32_mask(_mm512_castps_si512(a), ints(all(1))); }
inline Mask second_bit(Int a) { return _mm512_test_epi32_mask(ints(a), ints(all(0x40000000))); }
inline Int gather(const unsigned* from, Int at) {
  return __builtin_bit_cast(Int,
                            _mm512_mask_i32gather_epi32(ints(all(0)), 0xffff, ints(at), from, 4));
}
inline float least(Float a) { return _mm512_reduce_min_ps(a); }
inline Mask lanes_of(unsigned chosen) { return static_cast<Mask>(chosen); }
#endif
#if FLATRAY_LANES != 2  // of which g++ makes four instructions in place of one
inline Float smaller(Float a, Float b) { return a < b ? a : b; }
inline Float larger(Float a, Float b) { return a > b ? a : b; }
#endif
#if FLATRAY_LANES < 4
inline Float fused(Float a, Float b, Float c) { return a * b + c; }
inline Float fused_difference(Float a, Float b, Float c) { return a * b - c; }
#elif FLATRAY_LANES == 4
inline Float fused(Float a, Float b, Float c) { return _mm256_fmadd_ps(a, b, c); }
inline Float fused_difference(Float a, Float b, Float c) { return _mm256_fmsub_ps(a, b, c); }
#else
inline Float fused(Float a, Float b, Float c) { return _mm512_fmadd_ps(a, b, c); }
inline Float fused_difference(Float a, Float b, Float c) { return _mm512_fmsub_ps(a, b, c); }
#endif
inline float most(Float a) { return -least(all(0.0F) - a); }
inline Mask none() { return Mask{}; }
inline Mask negative(Float a) { return negative(as_int(a)); }
inline Int next(Int a) { return sum(a, all(1)); }
inline Int low_seven(Int a) { return a & 127; }
inline Float exponent_of(Int a) { return as_float(a & 0x7f800000); }
