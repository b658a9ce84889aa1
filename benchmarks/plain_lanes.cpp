#include "plain_lanes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/isa.h"
#include "trace/cells.h"
#include "trace/kernels/tiers.h"

#if defined(__AVX2__)
#include <immintrin.h>

namespace bench {
namespace {

using flatray::CellGrid;
using flatray::lanes::Grid;
using flatray::lanes::kCurve;
using flatray::lanes::kDoubt;
using flatray::lanes::kNear;
using flatray::lanes::kNoRecord;
using flatray::lanes::kPart;
using flatray::lanes::kSecond;
using flatray::lanes::kSide;
using flatray::lanes::kTime;
using flatray::lanes::Rays;
using flatray::lanes::Walking;

#define FLATRAY_LANES 4
namespace doubles {
#include "trace/kernels/vector.h"
}  // namespace doubles

namespace plain {
#include "plain_vector.h"
#include "trace/kernels/group_body.h"

// A wall is met where its ends are on different sides.
template <bool together>
inline void judge(const Constants&, const Record& r, Mask idle, Group& g) {
  const Float ax = r.ax - g.ox, ay = r.ay - g.oy, bx = r.bx - g.ox, by = r.by - g.oy;
  const Float side_a = fused_difference(g.dx, ay, g.dy * ax);
  const Float side_b = fused_difference(g.dx, by, g.dy * bx);
  const Float t_a = fused(g.dx, ax, g.dy * ay), t_b = fused(g.dx, bx, g.dy * by);
  const Float t = fused(side_a, (t_b - t_a) / (side_a - side_b), t_a);
  const Mask met = less(side_a * side_b, all(0.0F));
  const Mask closer = but_not(both(both(met, less(all(0.0F), t)), less(t, g.high)), idle);
  g.high = choose(closer, t, g.high);
  g.best = choose(closer, g.record, g.best);
}
#include "trace/kernels/walk_body.h"
}  // namespace plain

class PlainLanes : public Tracing {
 public:
  explicit PlainLanes(const flatray::Surfaces& walls)
      : walls_(walls), grid_(*CellGrid::build(walls)), numbers_(kBlock), columns_(6 * kRoom) {
    std::iota(numbers_.begin(), numbers_.end(), 0.0F);
  }
  std::string name() const override { return "plain double lanes"; }
  std::string arithmetic() const override { return "doubles"; }
  bool for_chambers() const override { return false; }
  void take(const flatray::RayBatch& rays) override {
    rays_ = rays;
    slots_.resize(rays.size());
    t_.resize(rays.size());
  }
  Met met(std::size_t ray) const override { return {slots_[ray], t_[ray]}; }
  void turn(std::size_t, const flatray::Vec2&, const flatray::Vec2&, std::uint32_t) override {}

  void trace() override {
    const flatray::lanes::WalkKernels& kernels = flatray::lane_kernels(flatray::active_isa()).walk;
    Walking w{};
    float* column = columns_.data();
    for (float** each : {&w.ox, &w.oy, &w.dx, &w.dy, &w.inverse_x, &w.inverse_y}) {
      *each = column;
      column += kRoom;
    }
    w.number = numbers_.data();
    std::vector<int> fate(kRoom), found(kRoom);
    for (std::size_t begin = 0; begin < rays_.size(); begin += kBlock) {
      const std::size_t count = std::min(kBlock, rays_.size() - begin);
      w.count = static_cast<int>(count);
      const Rays rays = {&rays_.ox[begin], &rays_.oy[begin], &rays_.dx[begin], &rays_.dy[begin],
                         w.count};
      kernels.prepare(grid_.view(), rays, w, fate.data());
      plain::walk_all(grid_.view(), w, found.data(),
                      [](const plain::Constants& c, const Grid& grid, plain::Group& g) {
                        plain::test<false>(c, grid, g);
                      });
      for (std::size_t i = 0; i < count; ++i)
        slots_[begin + i] = found[i] < 0 ? 0 : static_cast<std::uint32_t>(found[i]);
      finish(rays, begin);
      for (std::size_t i = 0; i < count; ++i)
        if (found[i] < 0) slots_[begin + i] = flatray::kNoSurface;
    }
  }

 private:
  static constexpr std::size_t kBlock = 4096, kRoom = kBlock + 16;

  void finish(const Rays& rays, std::size_t begin) {
    using namespace doubles;
    for (int i = 0; i < rays.count; i += 4) {
      const std::size_t at = begin + static_cast<std::size_t>(i);
      const Ends e = fetch_ends(walls_.segments.front().a.data(), &slots_[at]);
      const Real ex = e.bx - e.ax, ey = e.by - e.ay;
      const Real wx = e.ax - load(rays.ox + i), wy = e.ay - load(rays.oy + i);
      const Real across = load(rays.dx + i) * ey - load(rays.dy + i) * ex;
      store(&t_[at], (wx * ey - wy * ex) / across);
    }
  }

  const flatray::Surfaces& walls_;
  const CellGrid grid_;
  std::vector<float> numbers_, columns_;
  flatray::RayBatch rays_;
  std::vector<std::uint32_t> slots_;
  std::vector<double> t_;
};

}  // namespace

void add_plain_lanes(const flatray::Surfaces& walls, Tracings& all) {
  if (flatray::active_isa() >= flatray::Isa::avx2)
    all.push_back(std::make_unique<PlainLanes>(walls));
}

}  // namespace bench
#else
namespace bench {
void add_plain_lanes(const flatray::Surfaces&, Tracings&) {}
}  // namespace bench
#endif
