// The kernels of one tier, included inside its namespace: `Lanes` is the tier's vector of floats.

typedef float Pixel __attribute__((vector_size(16)));
constexpr size_t kPixels = sizeof(Lanes) / sizeof(Pixel);

template <class Vector>
static inline Vector load(const float* from) {
  Vector v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}

template <class Vector>
static inline void store(float* to, Vector v) {
  __builtin_memcpy(to, &v, sizeof v);
}

static inline Lanes repeated(Pixel pixel) {
  float all[4 * kPixels];
  for (size_t i = 0; i < kPixels; ++i) store(all + 4 * i, pixel);
  return load<Lanes>(all);
}

static void fill(float* rgba, size_t count, const float* colour) {
  const Pixel pixel = load<Pixel>(colour);
  const Lanes lanes = repeated(pixel);
  for (; count >= kPixels; count -= kPixels, rgba += 4 * kPixels) store(rgba, lanes);
  for (; count > 0; --count, rgba += 4) store(rgba, pixel);
}

static void blend(float* rgba, size_t count, Pixel over, float keep) {
  const Lanes lanes = repeated(over);
  for (; count >= kPixels; count -= kPixels, rgba += 4 * kPixels)
    store(rgba, lanes + load<Lanes>(rgba) * keep);
  for (; count > 0; --count, rgba += 4) store(rgba, over + load<Pixel>(rgba) * keep);
}

static void blend_runs(const Target& target, const Run* runs, size_t count, const float* colour) {
  const Pixel pixel = load<Pixel>(colour);
  for (const Run* run = runs; run != runs + count; ++run) {
    float* first = target.rgba +
                   4 * ((ptrdiff_t)(run->y - target.y) * target.width + (run->x_begin - target.x));
    const size_t pixels = (size_t)(run->x_end - run->x_begin);
    if (run->steps == kFullSteps && colour[3] == 1.0F) {
      fill(first, pixels, colour);
      continue;
    }
    const float part = share(run->steps);
    blend(first, pixels, pixel * part, 1.0F - colour[3] * part);
  }
}
