#include <algorithm>

#include "render/coverage/closed_parts.h"
#include "render/row_lengths.h"
#include "render/view.h"

namespace flatray::intervals_view {
namespace {

// Whether the grey of a length stays the same where it is off by `error`. That of a picture is a
// product of 255 that is rounded some four times.
bool is_sure(double length, double error, double most) {
  const double grey = 255 * (1 - std::clamp(length / most, 0.0, 1.0));
  const double to_a_half = std::fabs(grey - std::floor(grey) - 0.5);
  return to_a_half > 255 * error / most + 0x1p-40;
}

// All rays of a row lie on the first: the parts that one meets are asked of the tracer, and lengths
// taken along it. Pixels whose grey that leaves in doubt are clipped each for itself.
class Intervals : public ViewRows {
 public:
  explicit Intervals(const ViewFrame& frame)
      : frame_(frame),
        parts_(frame.scene, frame.state),
        walls_(made_ready(parts_.walls(), frame)) {}

  void draw(int row, std::uint8_t* pixels) const override {
    const RayBatch rays = rays_to_the_right(frame_, row);
    const std::vector<std::uint32_t> met = parts_met(rays.ray(0));
    RayBatch first, doubtful;
    first.add(rays.ray(0));
    std::vector<Range> inside;
    for (const std::uint32_t part : met) parts_.clip(part, first, {&inside, 1});
    RowLengths lengths(std::move(inside));
    const double most = frame_.scene.film.width;
    std::vector<std::uint8_t*> left;
    for (std::size_t i = 0; i < rays.size(); ++i, pixels += 3) {
      const double length = lengths.ahead((rays.ox[i] - rays.ox[0]) / rays.dx[0]);
      std::fill_n(pixels, 3, grey_of(length, most));
      if (is_sure(length, lengths.error(), most)) continue;
      doubtful.add(rays.ray(i));
      left.push_back(pixels);
    }
    draw_each(doubtful, met, left);
  }

 private:
  std::vector<std::uint32_t> parts_met(const Ray& ray) const {
    std::vector<std::uint32_t> met;
    for (const NearestHit& hit : walls_->all_of_one(ray))
      met.push_back(parts_.part_of(hit.surface));
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    return met;
  }

  void draw_each(const RayBatch& rays, std::span<const std::uint32_t> met,
                 std::span<std::uint8_t* const> pixels) const {
    if (rays.size() == 0) return;
    std::vector<std::vector<Range>> inside(rays.size());
    for (const std::uint32_t part : met) parts_.clip(part, rays, inside);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const double length = length_of(interval_set(std::move(inside[i])));
      std::fill_n(pixels[i], 3, grey_of(length, frame_.scene.film.width));
    }
  }

  const ViewFrame frame_;
  const ClosedParts parts_;
  const std::unique_ptr<Accelerator> walls_;
};

}  // namespace

extern const View entry = {"intervals",
                           "how much of the way to the right lies inside shapes: none is white",
                           false, true, &make_rows<Intervals>};

}  // namespace flatray::intervals_view
