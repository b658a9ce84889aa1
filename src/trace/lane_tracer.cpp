#include "trace/lane_tracer.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "geom/error_bounds.h"
#include "trace/cell_search.h"
#include "trace/kernels/tiers.h"
#include "trace/many_rays.h"
#include "trace/rescaled.h"

namespace flatray {
namespace {

constexpr std::size_t kBlock = 4096;
// Up to so many rays one after the other are faster than lanes (benchmarks/batch_size).
constexpr std::size_t kFewRays = kMostRaysOneByOne, kFewRaysOfList = 4;
constexpr auto kWide = static_cast<std::size_t>(lanes::kWidest);
constexpr std::size_t kVector = 16;  // floats of the widest tier

std::size_t whole_vectors(std::size_t count) { return (count + kWide - 1) / kWide * kWide; }

// What the lanes say of a ray.
struct Verdict {
  int found;
  std::uint32_t slot;  // of a wall, and t
  double t;

  bool is_certain() const { return found != lanes::kDoubt; }
  bool is_hit() const { return found >= 0; }
};

// What tells the lanes which wall a ray has just left; whether it has left one.
bool mark_left(const Surfaces& walls, const CellGrid& grid, const Left& left,
               const lanes::Walking& to, std::size_t i, int& fate) {
  CellGrid::Mark mark{NAN, NAN, NAN};
  const std::uint32_t slot = walls.segment_slot(left.surface);
  if (slot != kNoSurface) {
    mark = grid.mark(walls.segments[slot]);
    if (grid.is_twin(slot) || grid.next_copy(slot) != CellGrid::kNoSlot) fate = lanes::kDoubt;
  }
  to.left_ax[i] = mark.ax;
  to.left_ay[i] = mark.ay;
  to.left_bx[i] = mark.bx;
  return slot != kNoSurface;
}

// Columns of some rays one after the other, `room` floats each.
lanes::Walking columns_of(float* column, const float* numbers, std::size_t room) {
  lanes::Walking w{};
  w.number = numbers;
  for (float** each : {&w.ox, &w.oy, &w.dx, &w.dy, &w.inverse_x, &w.inverse_y, &w.left_ax,
                       &w.left_ay, &w.left_bx, &w.end_low, &w.end_high})
    *each = std::exchange(column, column + room);
  return w;
}

std::string both(std::string segments, const std::string& curves) {
  return curves.empty() ? segments : std::move(segments) + ", " + curves;
}

// Some rays of a batch on their way through the kernels.
class Block {
 public:
  explicit Block(std::size_t most)
      : room_(whole_vectors(most) + kVector),
        numbers_(room_),
        columns_(11 * room_),
        fate_(room_),
        found_(room_),
        slots_(room_),
        t_(room_) {
    std::iota(numbers_.begin(), numbers_.end(), 0.0F);
  }

  void load(const RayBatch& rays, std::size_t begin, std::size_t count) {
    rays_ = &rays;
    begin_ = begin;
    count_ = count;
    given_ = {&rays.ox[begin], &rays.oy[begin], &rays.dx[begin], &rays.dy[begin],
              static_cast<int>(count)};
    if (count % kWide == 0) return;
    padded_.resize(0);  // the kernels read whole vectors: the last ray again
    for (std::size_t i = 0; i < whole_vectors(count); ++i)
      padded_.add(rays.ray(begin + std::min(i, count - 1)));
    given_ = {padded_.ox.data(), padded_.oy.data(), padded_.dx.data(), padded_.dy.data(),
              static_cast<int>(padded_.size())};
  }

  // Walls that may be the first of each ray, of rays that end one they may meet: the record, or what
  // is not certain. `up_to` by ray of the batch, or empty.
  void walk(const Surfaces& walls, const CellGrid& grid, const lanes::WalkKernels& kernels,
            std::span<const double> up_to = {}) {
    lanes::Walking w = columns_of(columns_.data(), numbers_.data(), room_);
    w.count = static_cast<int>(count_);
    if (!up_to.empty()) {
      ends_.assign(room_, 0);
      std::copy_n(up_to.begin() + static_cast<std::ptrdiff_t>(begin_), count_, ends_.begin());
      w.up_to = ends_.data();
    }
    kernels.prepare(grid.view(), given_, w, fate_.data());
    if (!mark_all_left(walls, grid, w)) w.left_ax = nullptr;
    (grid.has_cells() ? kernels.walk : kernels.scan)(grid.view(), w, found_.data());
  }

  // Of rays that end.
  int found(std::size_t i) const { return fate_[i] != 0 ? lanes::kDoubt : found_[i]; }

  void finish(const Surfaces& walls, const CellGrid& grid, const lanes::WalkKernels& kernels) {
    for (std::size_t i = 0; i < count_; ++i) {
      if (fate_[i] != 0) found_[i] = lanes::kDoubt;
      slots_[i] = found_[i] < 0 ? 0 : grid.slot(static_cast<std::size_t>(found_[i]));
      __builtin_prefetch(&walls.segments[slots_[i]]);
    }
    std::fill(slots_.begin() + static_cast<std::ptrdiff_t>(count_), slots_.end(), 0U);
    kernels.finish(given_, {walls.segments.front().a.data(), slots_.data(), t_.data()});
  }

  struct Verdicts {
    const int* found;
    const std::uint32_t* slots;
    const double* t;
    Verdict operator[](std::size_t i) const { return {found[i], slots[i], t[i]}; }
  };
  Verdicts verdicts() const { return {found_.data(), slots_.data(), t_.data()}; }

 private:
  // Whether any ray has left a segment.
  bool mark_all_left(const Surfaces& walls, const CellGrid& grid, const lanes::Walking& w) {
    const std::span left = std::span(rays_->left).subspan(begin_, count_);
    std::uint32_t none = kNoSurface;  // all bits
    for (const Left& each : left) none &= each.surface;
    if (none == kNoSurface) return false;
    bool any = false;
    for (std::size_t i = 0; i < count_; ++i)
      any = mark_left(walls, grid, left[i], w, i, fate_[i]) || any;
    return any;
  }

  std::size_t room_;
  std::vector<float> numbers_, columns_;
  std::vector<int> fate_, found_;
  std::vector<std::uint32_t> slots_;
  std::vector<double> t_, ends_;
  const RayBatch* rays_ = nullptr;
  std::size_t begin_ = 0, count_ = 0;
  lanes::Rays given_{};
  RayBatch padded_;
};

class LaneTracer : public Accelerator {
 public:
  LaneTracer(const Surfaces& walls, CellGrid cells, Isa isa)
      : Accelerator(walls),
        cells_(std::move(cells)),
        view_(cells_.view()),
        curves_(walls),
        search_(walls, &cells_, curves_),
        kernels_(lane_kernels(isa).walk) {}

  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    if (are_few(rays)) {
      for (std::size_t i = 0; i < rays.size(); ++i)
        hits[i] = nearest_of_one(rays.ray(i), rays.left[i], rays.tangents);
      return;
    }
    in_blocks(rays, [&](std::size_t i, const Verdict& verdict) {
      if (!decided(verdict, hits[i]))
        hits[i] = decide_exactly(verdict, rays.ray(i), rays.left[i], rays.tangents);
    });
  }
  // No ray goes on beyond its end, nor asks which wall of those it meets is the first.
  void any(const RayBatch& rays, std::span<const double> up_to,
           std::span<std::uint8_t> met) const override {
    if (are_few(rays)) return Accelerator::any(rays, up_to, met);
    Block block(std::min(kBlock, rays.size()));
    for (std::size_t begin = 0; begin < rays.size(); begin += kBlock) {
      const std::size_t count = std::min(kBlock, rays.size() - begin);
      block.load(rays, begin, count);
      block.walk(walls_, cells_, kernels_, up_to);
      for (std::size_t i = begin; i < begin + count; ++i) {
        const int found = block.found(i - begin);
        const bool open =
            found == lanes::kDoubt || (found < 0 && may_meet_curve(rays, i, up_to[i]));
        met[i] = open ? any_of_one(rays.ray(i), up_to[i], rays.left[i], rays.tangents) : found >= 0;
      }
    }
  }
  std::size_t left_by_lanes(const RayBatch& rays) const override {
    std::size_t left = 0;
    NearestHit hit;
    in_blocks(rays,
              [&](std::size_t, const Verdict& verdict) { left += decided(verdict, hit) ? 0 : 1; });
    return left;
  }
  NearestHit nearest_of_one(const Ray& ray, const Left& left, bool tangents) const override {
    const std::uint32_t slot = walls_.segment_slot(left.surface);
    if (slot != kNoSurface && cells_.next_copy(slot) != CellGrid::kNoSlot)
      return search_.nearest(ray, left, tangents);
    const lanes::SingleHit found = kernels_.single_ray(
        view_, walls_.segments.front().a.data(),
        {ray.origin.x(), ray.origin.y(), ray.direction.x(), ray.direction.y(), slot});
    return decide({found.found, found.slot, found.t}, ray, left, tangents);
  }
  std::vector<NearestHit> all_of_one(const Ray& ray, const Left& left,
                                     bool tangents) const override {
    return search_.all(ray, left, tangents);
  }
  std::size_t tested_of_one(const Ray& ray, const Left& left) const override {
    return search_.tested(ray, left);
  }
  std::size_t bytes() const override { return cells_.bytes() + curves_.bytes(); }
  std::string structure() const override { return both(segments_in(), curves_.structure()); }
  std::size_t cells() const override {
    const auto side = [](std::int32_t count) { return static_cast<std::size_t>(count); };
    return (cells_.has_cells() ? side(cells_.columns()) * side(cells_.rows()) : 0) +
           curves_.cells();
  }

 private:
  std::string segments_in() const {
    if (!cells_.has_cells()) return "one list";
    const std::string cells =
        std::to_string(cells_.columns()) + " x " + std::to_string(cells_.rows()) + " cells";
    return cells_.divided() == 0
               ? cells
               : cells + ", " + std::to_string(cells_.divided()) + " of them crowded and divided";
  }
  bool are_few(const RayBatch& rays) const {
    return rays.size() <= (cells_.has_cells() ? kFewRays : kFewRaysOfList);
  }
  bool may_meet_curve(const RayBatch& rays, std::size_t i, double up_to) const {
    if (up_to < 0) return false;
    const Ray ray = rays.ray(i);
    Candidates found(walls_, ray, rays.left[i], up_to * (1 + 0x1p-50) + kUnderflowError);
    curves_.offer_to(found, ray);
    return !found.empty();
  }

  template <class Each>
  void in_blocks(const RayBatch& rays, const Each& each) const {
    Block block(std::min(kBlock, rays.size()));
    for (std::size_t begin = 0; begin < rays.size(); begin += kBlock) {
      const std::size_t count = std::min(kBlock, rays.size() - begin);
      block.load(rays, begin, count);
      block.walk(walls_, cells_, kernels_);
      block.finish(walls_, cells_, kernels_);
      const Block::Verdicts verdicts = block.verdicts();
      for (std::size_t i = 0; i < count; ++i) each(begin + i, verdicts[i]);
    }
  }

  NearestHit decide(const Verdict& verdict, const Ray& ray, const Left& left, bool tangents) const {
    NearestHit hit;
    return decided(verdict, hit) ? hit : decide_exactly(verdict, ray, left, tangents);
  }

  // The usual case: sure of one segment, and of its t. (Without curves slots are numbers.)
  bool decided(const Verdict& verdict, NearestHit& hit) const {
    if (!walls_.curve_numbers.empty() || !verdict.is_certain()) return false;
    if (verdict.is_hit() && std::isnan(verdict.t)) return false;
    hit = verdict.is_hit() ? crossed(verdict.slot, verdict.t) : NearestHit{};
    return true;
  }
  static NearestHit crossed(std::uint32_t surface, double t) {
    return {surface, HitClass::touch, Root::none, false, t};
  }

  NearestHit decide_exactly(const Verdict& verdict, const Ray& ray, const Left& left,
                            bool tangents) const {
    if (!verdict.is_certain()) return search_.nearest(ray, left, tangents);
    Candidates found(walls_, ray, left);
    if (verdict.is_hit()) found.take_segment(verdict.slot, verdict.t);
    curves_.offer_to(found, ray);
    return found.first(tangents);
  }

  const CellGrid cells_;
  const lanes::Grid view_;
  const CurveCells curves_;
  const CellSearch search_;
  const lanes::WalkKernels& kernels_;
};

// Where coordinates leave no room for lanes.
class OneByOne : public Accelerator {
 public:
  explicit OneByOne(const Surfaces& walls)
      : Accelerator(walls), curves_(walls), search_(walls, nullptr, curves_) {}
  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = search_.nearest(rays.ray(i), rays.left[i], rays.tangents);
  }
  NearestHit nearest_of_one(const Ray& ray, const Left& left, bool tangents) const override {
    return search_.nearest(ray, left, tangents);
  }
  std::vector<NearestHit> all_of_one(const Ray& ray, const Left& left,
                                     bool tangents) const override {
    return search_.all(ray, left, tangents);
  }
  std::size_t bytes() const override { return curves_.bytes(); }
  std::string structure() const override {
    const bool curves_alone = walls_.segments.empty() && walls_.size() > 0;
    return curves_alone ? curves_.structure() : both("one list", curves_.structure());
  }
  std::size_t cells() const override { return curves_.cells(); }

 private:
  const CurveCells curves_;
  const CellSearch search_;
};

}  // namespace

std::unique_ptr<Accelerator> trace_in_lanes(const Surfaces& walls, const CellBuilder& cells_of,
                                            Isa isa) {
  const auto in_lanes = [&](const Surfaces& given) -> std::unique_ptr<Accelerator> {
    if (auto cells = cells_of(given))
      return std::make_unique<LaneTracer>(given, std::move(*cells), isa);
    return std::make_unique<OneByOne>(given);
  };
  auto as_given = in_lanes(walls);
  if (!is_unusual(walls)) return as_given;
  auto rescaled = trace_rescaled(walls, as_given, in_lanes);
  return rescaled ? std::move(rescaled) : std::move(as_given);
}

}  // namespace flatray
