// One ray per lane: FLATRAY_LANES doubles in a Real, a yes or no for each in a Mask. Included by
// the kernel of one tier only, in its own namespace.
#if FLATRAY_LANES == 1
using Real = double;
using Mask = bool;
inline Real load(const double* from) { return *from; }
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
#elif FLATRAY_LANES == 2
using Real = __m128d;
using Mask = __m128d;
inline Real load(const double* from) { return _mm_loadu_pd(from); }
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
#elif FLATRAY_LANES == 4
using Real = __m256d;
using Mask = __m256d;
inline Real load(const double* from) { return _mm256_loadu_pd(from); }
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
#else
using Real = __m512d;
using Mask = __mmask8;
inline Real load(const double* from) { return _mm512_loadu_pd(from); }
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
#endif
