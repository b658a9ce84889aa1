// The kernels of one tier, included inside its namespace after the one for centres: `Lanes` is the tier's
// vector of floats.

typedef float Pixel __attribute__((vector_size(16)));
constexpr size_t kPixels = sizeof(Lanes) / sizeof(Pixel);

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

static inline Rows floor_of(Rows v) {
  const Rows nearest = (v + kRounder) - kRounder;
  return nearest > v ? nearest - 1.0 : nearest;
}

static void edge_columns(const EdgeLine& edge, double y, size_t count, double offset, double* x,
                         double* column) {
  const Rows none = load<Rows>(kIndex) * 0.0;
  const Rows low_x = none + edge.low, high_x = none + edge.high;
  for (size_t i = 0; i < count; i += kRows) {
    const Rows row = load<Rows>(kIndex) + (double)i;
    const Rows at = edge.x_ref + (y + row - edge.y_ref) * edge.slope;
    const Rows above = at > low_x ? at : low_x;
    const Rows inside = above < high_x ? above : high_x;
    const Rows v = inside + offset;
    const Rows low = floor_of(v - edge.error), high = floor_of(v + edge.error);
    const Rows certain = low == high ? low : none + kNoColumn;
    store(x + i, inside);
    store(column + i, low == v ? none + kNoColumn : certain);
  }
}
