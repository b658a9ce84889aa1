// Lanes of rows, for the kernels of one tier: `Rows` is its vector of doubles.

template <class Vector>
static inline Vector load(const void* from) {
  Vector v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}

template <class Vector>
static inline void store(void* to, Vector v) {
  __builtin_memcpy(to, &v, sizeof v);
}

// Rounds to the nearest integer while |v| < 2^51; larger ones are no columns.
constexpr double kRounder = 0x1.8p52;
constexpr size_t kRows = sizeof(Rows) / sizeof(double);
static const double kIndex[] = {0, 1, 2, 3, 4, 5, 6, 7};
