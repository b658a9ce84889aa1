// One ray per lane: FLATRAY_LANES doubles in a Real, a yes or no for each in a Mask. Included by
// the kernel of one tier only, in its own namespace. ends_at: four doubles for each lane, from its
// address at(lane); fetch_ends: those of a slot, or `by` after a pointer. store_pairs: a and b in turn.
#if FLATRAY_LANES == 1
using Real = double;
#else
typedef double Real __attribute__((vector_size(8 * FLATRAY_LANES)));
typedef float Singles __attribute__((vector_size(4 * FLATRAY_LANES)));
typedef int Places __attribute__((vector_size(4 * FLATRAY_LANES)));
#endif
struct Ends {
  Real ax, ay, bx, by;
};
inline Real load(const double* from) {
  Real loaded;
  __builtin_memcpy(&loaded, from, sizeof loaded);
  return loaded;
}
inline void store(double* to, Real value) { __builtin_memcpy(to, &value, sizeof value); }
inline Real all(double value) { return value - Real{}; }  // + 0 would lose -0

#if FLATRAY_LANES == 1
using Mask = bool;
inline Real gather(const double* from, const int* at) { return from[*at]; }
inline Mask less(Real a, Real b) { return a < b; }
inline Mask equal(Real a, Real b) { return a == b; }
inline Mask both(Mask a, Mask b) { return a && b; }
inline Mask either(Mask a, Mask b) { return a || b; }
inline Mask but_not(Mask a, Mask b) { return a && !b; }
inline unsigned bits(Mask m) { return m ? 1 : 0; }
inline Real choose(Mask m, Real yes, Real no) { return m ? yes : no; }
inline Real size(Real a) { return __builtin_fabs(a); }
inline Real with_sign_of(Real size, Real sign) { return __builtin_copysign(size, sign); }
inline Real root(Real a) { return __builtin_sqrt(a); }
#ifdef __FMA__
inline Real fused(Real a, Real b, Real c) { return __builtin_fma(a, b, c); }
inline Real fused_difference(Real a, Real b, Real c) { return __builtin_fma(a, b, -c); }
#endif
inline Real real(const int* from) { return *from; }
inline void store_pairs(void* to, Real a, Real b) {
  const Real pair[] = {a, b};
  __builtin_memcpy(to, pair, sizeof pair);
}
inline void store_single(float* to, Real value) { *to = static_cast<float>(value); }
template <class At>
inline Ends ends_at(const At& at) {
  const double* e = at(0);
  return {e[0], e[1], e[2], e[3]};
}
#else
inline Real real(const int* from) {
  Places loaded;
  __builtin_memcpy(&loaded, from, sizeof loaded);
  return __builtin_convertvector(loaded, Real);
}
inline void store_single(float* to, Real value) {
  const Singles rounded = __builtin_convertvector(value, Singles);
  __builtin_memcpy(to, &rounded, sizeof rounded);
}
#endif
#if FLATRAY_LANES == 2
using Mask = Real;
inline Real gather(const double* from, const int* at) { return Real{from[at[0]], from[at[1]]}; }
inline Mask both(Mask a, Mask b) { return _mm_and_pd(a, b); }
inline Mask either(Mask a, Mask b) { return _mm_or_pd(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm_andnot_pd(b, a); }
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm_movemask_pd(m)); }
inline Real choose(Mask m, Real yes, Real no) { return either(both(m, yes), but_not(no, m)); }
inline Real smaller(Real a, Real b) { return _mm_min_pd(a, b); }
inline Real larger(Real a, Real b) { return _mm_max_pd(a, b); }
inline Real root(Real a) { return _mm_sqrt_pd(a); }
inline void store_pairs(void* to, Real a, Real b) {
  store(static_cast<double*>(to), _mm_unpacklo_pd(a, b));
  store(static_cast<double*>(to) + 2, _mm_unpackhi_pd(a, b));
}
template <class At>
inline Ends ends_at(const At& at) {
  const Real a0 = load(at(0)), a1 = load(at(1)), b0 = load(at(0) + 2), b1 = load(at(1) + 2);
  return {_mm_unpacklo_pd(a0, a1), _mm_unpackhi_pd(a0, a1), _mm_unpacklo_pd(b0, b1),
          _mm_unpackhi_pd(b0, b1)};
}
#elif FLATRAY_LANES == 4
using Mask = Real;
inline Real gather(const double* from, const int* at) {
  return Real{from[at[0]], from[at[1]], from[at[2]], from[at[3]]};
}
inline Mask both(Mask a, Mask b) { return _mm256_and_pd(a, b); }
inline Mask either(Mask a, Mask b) { return _mm256_or_pd(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm256_andnot_pd(b, a); }
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm256_movemask_pd(m)); }
inline Real choose(Mask m, Real yes, Real no) { return _mm256_blendv_pd(no, yes, m); }
inline Real root(Real a) { return _mm256_sqrt_pd(a); }
inline Real fused(Real a, Real b, Real c) { return _mm256_fmadd_pd(a, b, c); }
inline Real fused_difference(Real a, Real b, Real c) { return _mm256_fmsub_pd(a, b, c); }
inline void store_pairs(void* to, Real a, Real b) {
  const Real even = _mm256_unpacklo_pd(a, b), odd = _mm256_unpackhi_pd(a, b);
  store(static_cast<double*>(to), _mm256_permute2f128_pd(even, odd, 0x20));
  store(static_cast<double*>(to) + 4, _mm256_permute2f128_pd(even, odd, 0x31));
}
template <class At>
inline Ends ends_at(const At& at) {
  const Real r0 = load(at(0)), r1 = load(at(1)), r2 = load(at(2)), r3 = load(at(3));
  const Real x01 = _mm256_unpacklo_pd(r0, r1), y01 = _mm256_unpackhi_pd(r0, r1);
  const Real x23 = _mm256_unpacklo_pd(r2, r3), y23 = _mm256_unpackhi_pd(r2, r3);
  return {_mm256_permute2f128_pd(x01, x23, 0x20), _mm256_permute2f128_pd(y01, y23, 0x20),
          _mm256_permute2f128_pd(x01, x23, 0x31), _mm256_permute2f128_pd(y01, y23, 0x31)};
}
#elif FLATRAY_LANES == 8
using Mask = __mmask8;
inline Real gather(const double* from, const int* at) {
  return Real{from[at[0]], from[at[1]], from[at[2]], from[at[3]],
              from[at[4]], from[at[5]], from[at[6]], from[at[7]]};
}
inline Mask less(Real a, Real b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
inline Mask equal(Real a, Real b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
inline Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
inline Mask either(Mask a, Mask b) { return static_cast<Mask>(a | b); }
inline Mask but_not(Mask a, Mask b) { return static_cast<Mask>(a & ~b); }
inline unsigned bits(Mask m) { return m; }
inline Real choose(Mask m, Real yes, Real no) { return _mm512_mask_blend_pd(m, no, yes); }
inline Real size(Real a) { return _mm512_abs_pd(a); }
inline Real with_sign_of(Real size, Real sign) {
  return _mm512_or_pd(size, _mm512_and_pd(all(-0.0), sign));
}
inline Real root(Real a) { return _mm512_maskz_sqrt_pd(255, a); }
inline Real fused(Real a, Real b, Real c) { return _mm512_fmadd_pd(a, b, c); }
inline Real fused_difference(Real a, Real b, Real c) { return _mm512_fmsub_pd(a, b, c); }
inline void store_pairs(void* to, Real a, Real b) {
  const __m512i low = _mm512_setr_epi64(0, 8, 1, 9, 2, 10, 3, 11);
  const __m512i high = _mm512_setr_epi64(4, 12, 5, 13, 6, 14, 7, 15);
  store(static_cast<double*>(to), _mm512_permutex2var_pd(a, low, b));
  store(static_cast<double*>(to) + 8, _mm512_permutex2var_pd(a, high, b));
}
template <class At>
inline Ends ends_at(const At& at) {
  const auto rows = [&](int lane) {
    const Real low = _mm512_maskz_broadcast_f64x4(15, _mm256_loadu_pd(at(lane)));
    return _mm512_mask_broadcast_f64x4(low, 240, _mm256_loadu_pd(at(lane + 4)));
  };
  const Real r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
  const Real x01 = _mm512_maskz_unpacklo_pd(255, r0, r1);
  const Real y01 = _mm512_maskz_unpackhi_pd(255, r0, r1);
  const Real x23 = _mm512_maskz_unpacklo_pd(255, r2, r3);
  const Real y23 = _mm512_maskz_unpackhi_pd(255, r2, r3);
  const __m512i a = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i b = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  return {_mm512_permutex2var_pd(x01, a, x23), _mm512_permutex2var_pd(y01, a, y23),
          _mm512_permutex2var_pd(x01, b, x23), _mm512_permutex2var_pd(y01, b, y23)};
}
#endif
#if FLATRAY_LANES == 2 || FLATRAY_LANES == 4
inline Mask less(Real a, Real b) { return __builtin_bit_cast(Mask, a < b); }
inline Mask equal(Real a, Real b) { return __builtin_bit_cast(Mask, a == b); }
inline Real size(Real a) { return but_not(a, all(-0.0)); }
inline Real with_sign_of(Real size, Real sign) { return either(size, both(all(-0.0), sign)); }
#endif
#if FLATRAY_LANES != 2  // of which g++ makes four instructions in place of one
inline Real smaller(Real a, Real b) { return a < b ? a : b; }
inline Real larger(Real a, Real b) { return a > b ? a : b; }
#endif
#ifndef __FMA__
inline Real fused(Real a, Real b, Real c) { return a * b + c; }
#endif
inline bool full(Mask m) { return bits(m) == (1U << FLATRAY_LANES) - 1; }
inline Ends fetch_ends(const double* ends, const unsigned* slot) {
  return ends_at([&](int lane) { return ends + 4 * static_cast<long>(slot[lane]); });
}
inline Ends fetch_ends(const double* const* from, int by) {
  return ends_at([&](int lane) { return from[lane] + by; });
}
