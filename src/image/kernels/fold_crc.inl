// CRC-32 by carry-less multiplication, after Gopal and others, "Fast CRC computation for generic
// polynomials using PCLMULQDQ" (Intel, 2009): 64 bytes are moved 64 bytes on by multiplying with
// x^(512+32) and x^(512-32) modulo the polynomial, bits reflected. Included inside a tier's
// namespace.

#define FLATRAY_CARRYLESS __attribute__((target("pclmul")))

FLATRAY_CARRYLESS static inline __m128i moved_on(__m128i x, __m128i powers) {
  return _mm_xor_si128(_mm_clmulepi64_si128(x, powers, 0x00),
                       _mm_clmulepi64_si128(x, powers, 0x11));
}

FLATRAY_CARRYLESS static void fold_crc(uint32_t crc, const uint8_t* bytes, size_t blocks,
                                       uint8_t* folded) {
  const __m128i by_64 = _mm_set_epi64x(0x1c6e41596, 0x154442bd4);
  const __m128i by_16 = _mm_set_epi64x(0x0ccaa009e, 0x1751997d0);
  const auto* at = reinterpret_cast<const __m128i*>(bytes);
  __m128i x[4];
  for (size_t i = 0; i < 4; ++i) x[i] = _mm_loadu_si128(at + i);
  x[0] = _mm_xor_si128(x[0], _mm_cvtsi32_si128((int)crc));
  for (size_t block = 1; block < blocks; ++block)
    for (size_t i = 0; i < 4; ++i)
      x[i] = _mm_xor_si128(moved_on(x[i], by_64), _mm_loadu_si128(at + 4 * block + i));
  for (size_t i = 1; i < 4; ++i) x[i] = _mm_xor_si128(moved_on(x[i - 1], by_16), x[i]);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(folded), x[3]);
}

#undef FLATRAY_CARRYLESS
