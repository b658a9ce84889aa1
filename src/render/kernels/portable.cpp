#include "render/kernels/span_kernels.h"

namespace flatray::kernels {
namespace portable {
namespace {

typedef double Rows __attribute__((vector_size(16)));  // the compiler makes of them what it can
#include "render/kernels/centre_kernel.inl"

void fill(float* rgba, size_t count, const float* colour) {
  for (size_t i = 0; i < 4 * count; ++i) rgba[i] = colour[i % 4];
}

void blend(float* rgba, size_t count, const float* colour, float share) {
  const float keep = 1.0F - colour[3] * share;
  const float over[4] = {colour[0] * share, colour[1] * share, colour[2] * share,
                         colour[3] * share};
  for (size_t i = 0; i < 4 * count; ++i) rgba[i] = over[i % 4] + rgba[i] * keep;
}

void blend_runs(const Target& target, const Run* runs, size_t count, const float* colour) {
  for (const Run* run = runs; run != runs + count; ++run) {
    float* first = target.rgba +
                   4 * ((ptrdiff_t)(run->y - target.y) * target.width + (run->x_begin - target.x));
    const size_t pixels = (size_t)(run->x_end - run->x_begin);
    if (run->steps == kFullSteps && colour[3] == 1.0F)
      fill(first, pixels, colour);
    else
      blend(first, pixels, colour, share(run->steps));
  }
}

double floor_of(double v) {
  const double nearest = (v + kRounder) - kRounder;
  return nearest - (nearest > v ? 1.0 : 0.0);
}

void edge_columns(const EdgeLine& edge, double y, size_t count, double offset, double* x,
                  double* column) {
  for (size_t i = 0; i < count; ++i) {
    const double at = edge.x_ref + (y + (double)i - edge.y_ref) * edge.slope;
    const double above = at > edge.low ? at : edge.low;
    x[i] = above < edge.high ? above : edge.high;
    const double v = x[i] + offset;
    const double low = floor_of(v - edge.error), high = floor_of(v + edge.error);
    column[i] = low == high && low != v ? low : kNoColumn;
  }
}

}  // namespace
}  // namespace portable

const SpanKernels portable_kernels = {&portable::blend_runs, &portable::edge_columns,
                                      &portable::centre_runs, &portable::fill};

}  // namespace flatray::kernels
