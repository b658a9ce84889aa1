// One ray per lane: FLATRAY_LANES doubles in a Real, a yes or no for each in a Mask. Included by
// the kernel of one tier only, in its own namespace. fetch_ends: four doubles for each lane, those of
// a slot, or `by` after a pointer. store_pairs: a and b in turn.
#if FLATRAY_LANES == 1
using Real = double;
using Mask = bool;
struct Ends {
  Real ax, ay, bx, by;
};
inline Real load(const double* from) { return *from; }
inline Real gather(const double* from, const int* at) { return from[*at]; }
inline void store(double* to, Real value) { *to = value; }
inline Real all(double value) { return value; }
inline Mask less(Real a, Real b) { return a < b; }
inline Mask equal(Real a, Real b) { return a == b; }
inline Mask both(Mask a, Mask b) { return a && b; }
inline Mask either(Mask a, Mask b) { return a || b; }
inline Mask but_not(Mask a, Mask b) { return a && !b; }
inline bool full(Mask m) { return m; }
inline Real choose(Mask m, Real yes, Real no) { return m ? yes : no; }
inline Real smaller(Real a, Real b) { return a < b ? a : b; }
inline Real larger(Real a, Real b) { return a > b ? a : b; }
inline Real size(Real a) { return __builtin_fabs(a); }
inline Real with_sign_of(Real size, Real sign) { return __builtin_copysign(size, sign); }
inline Real root(Real a) { return __builtin_sqrt(a); }
#ifdef __FMA__
inline Real fused(Real a, Real b, Real c) { return __builtin_fma(a, b, c); }
inline Real fused_difference(Real a, Real b, Real c) { return __builtin_fma(a, b, -c); }
#else
inline Real fused(Real a, Real b, Real c) { return a * b + c; }
#endif
inline Real real(const int* from) { return *from; }
inline unsigned bits(Mask m) { return m ? 1 : 0; }
inline void store_pairs(void* to, Real a, Real b) {
  const Real pair[] = {a, b};
  __builtin_memcpy(to, pair, sizeof pair);
}
inline void store_single(float* to, Real value) { *to = static_cast<float>(value); }
inline Ends fetch_ends(const double* ends, const unsigned* slot) {
  const double* e = ends + 4 * static_cast<long>(*slot);
  return {e[0], e[1], e[2], e[3]};
}
inline Ends fetch_ends(const double* const* from, int by) {
  const double* e = *from + by;
  return {e[0], e[1], e[2], e[3]};
}
#elif FLATRAY_LANES == 2
using Real = __m128d;
using Mask = __m128d;
struct Ends {
  Real ax, ay, bx, by;
};
inline Real load(const double* from) { return _mm_loadu_pd(from); }
inline Real gather(const double* from, const int* at) {
  return _mm_setr_pd(from[at[0]], from[at[1]]);
}
inline void store(double* to, Real value) { _mm_storeu_pd(to, value); }
inline Real all(double value) { return _mm_set1_pd(value); }
inline Mask less(Real a, Real b) { return _mm_cmplt_pd(a, b); }
inline Mask equal(Real a, Real b) { return _mm_cmpeq_pd(a, b); }
inline Mask both(Mask a, Mask b) { return _mm_and_pd(a, b); }
inline Mask either(Mask a, Mask b) { return _mm_or_pd(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm_andnot_pd(b, a); }
inline bool full(Mask m) { return _mm_movemask_pd(m) == 3; }
inline Real choose(Mask m, Real yes, Real no) {
  return _mm_or_pd(_mm_and_pd(m, yes), _mm_andnot_pd(m, no));
}
inline Real smaller(Real a, Real b) { return _mm_min_pd(a, b); }
inline Real larger(Real a, Real b) { return _mm_max_pd(a, b); }
inline Real size(Real a) { return _mm_andnot_pd(_mm_set1_pd(-0.0), a); }
inline Real with_sign_of(Real size, Real sign) {
  return _mm_or_pd(size, _mm_and_pd(_mm_set1_pd(-0.0), sign));
}
inline Real root(Real a) { return _mm_sqrt_pd(a); }
inline Real fused(Real a, Real b, Real c) { return a * b + c; }
inline Real real(const int* from) {
  return _mm_cvtepi32_pd(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from)));
}
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm_movemask_pd(m)); }
inline void store_pairs(void* to, Real a, Real b) {
  _mm_storeu_pd(static_cast<double*>(to), _mm_unpacklo_pd(a, b));
  _mm_storeu_pd(static_cast<double*>(to) + 2, _mm_unpackhi_pd(a, b));
}
inline void store_single(float* to, Real value) {
  _mm_storel_pi(reinterpret_cast<__m64*>(to), _mm_cvtpd_ps(value));
}
inline Ends turned(const double* e0, const double* e1) {
  const Real a0 = load(e0), a1 = load(e1), b0 = load(e0 + 2), b1 = load(e1 + 2);
  return {_mm_unpacklo_pd(a0, a1), _mm_unpackhi_pd(a0, a1), _mm_unpacklo_pd(b0, b1),
          _mm_unpackhi_pd(b0, b1)};
}
inline Ends fetch_ends(const double* ends, const unsigned* slot) {
  return turned(ends + 4 * static_cast<long>(slot[0]), ends + 4 * static_cast<long>(slot[1]));
}
inline Ends fetch_ends(const double* const* from, int by) {
  return turned(from[0] + by, from[1] + by);
}
#elif FLATRAY_LANES == 4
using Real = __m256d;
using Mask = __m256d;
struct Ends {
  Real ax, ay, bx, by;
};
inline Real load(const double* from) { return _mm256_loadu_pd(from); }
inline Real gather(const double* from, const int* at) {
  return _mm256_setr_pd(from[at[0]], from[at[1]], from[at[2]], from[at[3]]);
}
inline void store(double* to, Real value) { _mm256_storeu_pd(to, value); }
inline Real all(double value) { return _mm256_set1_pd(value); }
inline Mask less(Real a, Real b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
inline Mask equal(Real a, Real b) { return _mm256_cmp_pd(a, b, _CMP_EQ_OQ); }
inline Mask both(Mask a, Mask b) { return _mm256_and_pd(a, b); }
inline Mask either(Mask a, Mask b) { return _mm256_or_pd(a, b); }
inline Mask but_not(Mask a, Mask b) { return _mm256_andnot_pd(b, a); }
inline bool full(Mask m) { return _mm256_movemask_pd(m) == 15; }
inline Real choose(Mask m, Real yes, Real no) { return _mm256_blendv_pd(no, yes, m); }
inline Real smaller(Real a, Real b) { return _mm256_min_pd(a, b); }
inline Real larger(Real a, Real b) { return _mm256_max_pd(a, b); }
inline Real size(Real a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
inline Real with_sign_of(Real size, Real sign) {
  return _mm256_or_pd(size, _mm256_and_pd(_mm256_set1_pd(-0.0), sign));
}
inline Real root(Real a) { return _mm256_sqrt_pd(a); }
inline Real fused(Real a, Real b, Real c) { return _mm256_fmadd_pd(a, b, c); }
inline Real fused_difference(Real a, Real b, Real c) { return _mm256_fmsub_pd(a, b, c); }
inline Real real(const int* from) {
  return _mm256_cvtepi32_pd(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)));
}
inline unsigned bits(Mask m) { return static_cast<unsigned>(_mm256_movemask_pd(m)); }
inline void store_pairs(void* to, Real a, Real b) {
  const Real even = _mm256_unpacklo_pd(a, b), odd = _mm256_unpackhi_pd(a, b);
  _mm256_storeu_pd(static_cast<double*>(to), _mm256_permute2f128_pd(even, odd, 0x20));
  _mm256_storeu_pd(static_cast<double*>(to) + 4, _mm256_permute2f128_pd(even, odd, 0x31));
}
inline void store_single(float* to, Real value) { _mm_storeu_ps(to, _mm256_cvtpd_ps(value)); }
inline Ends turned(Real r0, Real r1, Real r2, Real r3) {
  const Real x01 = _mm256_unpacklo_pd(r0, r1), y01 = _mm256_unpackhi_pd(r0, r1);
  const Real x23 = _mm256_unpacklo_pd(r2, r3), y23 = _mm256_unpackhi_pd(r2, r3);
  return {_mm256_permute2f128_pd(x01, x23, 0x20), _mm256_permute2f128_pd(y01, y23, 0x20),
          _mm256_permute2f128_pd(x01, x23, 0x31), _mm256_permute2f128_pd(y01, y23, 0x31)};
}
inline Ends fetch_ends(const double* ends, const unsigned* slot) {
  const auto row = [&](int lane) { return load(ends + 4 * static_cast<long>(slot[lane])); };
  return turned(row(0), row(1), row(2), row(3));
}
inline Ends fetch_ends(const double* const* from, int by) {
  return turned(load(from[0] + by), load(from[1] + by), load(from[2] + by), load(from[3] + by));
}
#else
using Real = __m512d;
using Mask = __mmask8;
struct Ends {
  Real ax, ay, bx, by;
};
inline Real load(const double* from) { return _mm512_loadu_pd(from); }
inline Real gather(const double* from, const int* at) {
  return _mm512_setr_pd(from[at[0]], from[at[1]], from[at[2]], from[at[3]], from[at[4]],
                        from[at[5]], from[at[6]], from[at[7]]);
}
inline void store(double* to, Real value) { _mm512_storeu_pd(to, value); }
inline Real all(double value) { return _mm512_set1_pd(value); }
inline Mask less(Real a, Real b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
inline Mask equal(Real a, Real b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
inline Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
inline Mask either(Mask a, Mask b) { return static_cast<Mask>(a | b); }
inline Mask but_not(Mask a, Mask b) { return static_cast<Mask>(a & ~b); }
inline bool full(Mask m) { return m == 255; }
inline Real choose(Mask m, Real yes, Real no) { return _mm512_mask_blend_pd(m, no, yes); }
inline Real smaller(Real a, Real b) { return _mm512_maskz_min_pd(255, a, b); }
inline Real larger(Real a, Real b) { return _mm512_maskz_max_pd(255, a, b); }
inline Real size(Real a) { return _mm512_abs_pd(a); }
inline Real with_sign_of(Real size, Real sign) {
  return _mm512_or_pd(size, _mm512_and_pd(_mm512_set1_pd(-0.0), sign));
}
inline Real root(Real a) { return _mm512_maskz_sqrt_pd(255, a); }
inline Real fused(Real a, Real b, Real c) { return _mm512_fmadd_pd(a, b, c); }
inline Real fused_difference(Real a, Real b, Real c) { return _mm512_fmsub_pd(a, b, c); }
inline Real real(const int* from) {
  return _mm512_maskz_cvtepi32_pd(255, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)));
}
inline unsigned bits(Mask m) { return m; }
inline void store_pairs(void* to, Real a, Real b) {
  const __m512i low = _mm512_setr_epi64(0, 8, 1, 9, 2, 10, 3, 11);
  const __m512i high = _mm512_setr_epi64(4, 12, 5, 13, 6, 14, 7, 15);
  _mm512_storeu_pd(static_cast<double*>(to), _mm512_permutex2var_pd(a, low, b));
  _mm512_storeu_pd(static_cast<double*>(to) + 8, _mm512_permutex2var_pd(a, high, b));
}
inline void store_single(float* to, Real value) {
  _mm256_storeu_ps(to, _mm512_maskz_cvtpd_ps(255, value));
}
inline Ends fetch_ends(const double* ends, const unsigned* slot) {
  const auto row = [&](int lane) {
    return _mm256_loadu_pd(ends + 4 * static_cast<long>(slot[lane]));
  };
  const auto rows = [&](int lane) {
    return _mm512_maskz_insertf64x4(255, _mm512_castpd256_pd512(row(lane)), row(lane + 4), 1);
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
inline Ends fetch_ends(const double* const* from, int by) {
  const auto rows = [&](int lane) {
    const Real low = _mm512_maskz_broadcast_f64x4(15, _mm256_loadu_pd(from[lane] + by));
    return _mm512_mask_broadcast_f64x4(low, 240, _mm256_loadu_pd(from[lane + 4] + by));
  };
  const Real r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
  const Real x01 = _mm512_maskz_unpacklo_pd(255, r0, r1),
             y01 = _mm512_maskz_unpackhi_pd(255, r0, r1);
  const Real x23 = _mm512_maskz_unpacklo_pd(255, r2, r3),
             y23 = _mm512_maskz_unpackhi_pd(255, r2, r3);
  const __m512i a = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i b = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  return {_mm512_permutex2var_pd(x01, a, x23), _mm512_permutex2var_pd(y01, a, y23),
          _mm512_permutex2var_pd(x01, b, x23), _mm512_permutex2var_pd(y01, b, y23)};
}
#endif
