// The kernels of one tier, included inside its namespace: `Bytes`, `Halves` and `Words` are the
// tier's vectors of 8-bit, 16-bit and 32-bit numbers.

constexpr size_t kWidth = sizeof(Bytes);
constexpr size_t kLanes = kWidth / 4;
// Prefix sums of so many bytes fit 16 bits: 255 * 22 * 23 / 2 < 2^16.
constexpr size_t kSteps = 22;
constexpr size_t kBlock = kSteps * kWidth;

template <class Vector>
static inline Vector load(const void* from) {
  Vector v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}

static void subtract(uint8_t* out, const uint8_t* row, const uint8_t* before, size_t count) {
  size_t i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    const Bytes difference = load<Bytes>(row + i) - load<Bytes>(before + i);
    __builtin_memcpy(out + i, &difference, kWidth);
  }
  for (; i < count; ++i) out[i] = (uint8_t)(row[i] - before[i]);
}

static inline Words lower(Halves v) { return (Words)v & 0xffff; }
static inline Words upper(Halves v) { return (Words)v >> 16; }

static inline uint32_t total(Words v) {
  uint32_t lanes[kLanes], sum = 0;
  __builtin_memcpy(lanes, &v, sizeof v);
  for (size_t i = 0; i < kLanes; ++i) sum += lanes[i];
  return sum;
}

// Places of the first byte of each four.
static inline Words places() {
  uint32_t lanes[kLanes];
  for (size_t i = 0; i < kLanes; ++i) lanes[i] = (uint32_t)(4 * i);
  return load<Words>(lanes);
}

// Byte k of step i of a block stands for (steps - i) * width - k in the second sum: `prefix` counts
// it steps - i times, the places are taken off at the end.
static AdlerSums block_sums(AdlerSums sums, const uint8_t* bytes) {
  Halves even{}, odd{}, even_prefix{}, odd_prefix{};
  for (size_t i = 0; i < kSteps; ++i) {
    const Halves v = load<Halves>(bytes + i * kWidth);
    even += v & 0xff;
    odd += v >> 8;
    even_prefix += even;
    odd_prefix += odd;
  }
  const Words odds = lower(odd) + upper(odd);
  const Words first = lower(even) + lower(odd), second = upper(even) + upper(odd);
  const uint32_t prefix = total(lower(even_prefix) + upper(even_prefix) + lower(odd_prefix) +
                                upper(odd_prefix));
  const uint32_t off = total((first + second) * places() + second * 2 + odds);
  return {(sums.a + total(first + second)) % kAdlerModulus,
          (sums.b + (uint32_t)kBlock * sums.a + (uint32_t)kWidth * prefix - off) % kAdlerModulus};
}

static AdlerSums adler(AdlerSums sums, const uint8_t* bytes, size_t count) {
  for (; count >= kBlock; count -= kBlock, bytes += kBlock) sums = block_sums(sums, bytes);
  for (; count > 0; --count, ++bytes) {
    sums.a += *bytes;
    sums.b += sums.a;
  }
  return {sums.a % kAdlerModulus, sums.b % kAdlerModulus};
}
