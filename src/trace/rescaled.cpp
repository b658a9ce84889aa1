#include "trace/rescaled.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace flatray {
namespace {

constexpr double kMost = 0x1p900;  // of a scaled number: what lanes take
constexpr int kUsual = 300;  // products of three differences, thinner by 2^40, stay above 2^-960

// The inverse of a power of two may be none: it is applied in two steps.
struct Factor {
  int exponent;

  double times(double x, int power) const {
    return std::ldexp(std::ldexp(x, power / 2), power - power / 2);
  }
  /// Whether `x` may be scaled without rounding; then it is.
  bool scale(double& x) const {
    const double scaled = times(x, exponent);
    const bool exact = std::fabs(scaled) < kMost && times(scaled, -exponent) == x;
    x = scaled;
    return exact;
  }
  bool scale(Vec2& v) const {
    const bool x = scale(v.x()), y = scale(v.y());
    return x && y;
  }
  bool scale(Ray& ray) const {
    const bool origin = scale(ray.origin), direction = scale(ray.direction);
    return origin && direction;
  }
};

// What makes the largest number of the walls 1 to 2.
Factor factor_of(const Surfaces& walls) {
  double most = 0;
  for (const Segment& wall : walls.segments)
    most = std::max({most, wall.a.cwiseAbs().maxCoeff(), wall.b.cwiseAbs().maxCoeff()});
  return {most > 0 ? -std::ilogb(most) : 0};
}

class Rescaled : public Accelerator {
 public:
  Rescaled(const Surfaces& walls, std::unique_ptr<const Surfaces> scaled, Factor factor,
           std::unique_ptr<Accelerator> inner, std::unique_ptr<Accelerator> as_given)
      : Accelerator(walls),
        scaled_(std::move(scaled)),
        factor_(factor),
        inner_(std::move(inner)),
        as_given_(std::move(as_given)) {}

  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    RayBatch scaled;
    scaled.tangents = rays.tangents;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Ray ray = rays.ray(i);
      if (factor_.scale(ray)) {
        scaled.add(ray, rays.left[i]);
        numbers.push_back(i);
      } else {
        hits[i] = as_given_->nearest_of_one(rays.ray(i), rays.left[i], rays.tangents);
      }
    }
    std::vector<NearestHit> found(numbers.size());
    inner_->nearest(scaled, found);
    for (std::size_t k = 0; k < numbers.size(); ++k) hits[numbers[k]] = found[k];
  }
  std::size_t left_by_lanes(const RayBatch& rays) const override {
    RayBatch scaled;
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (Ray ray = rays.ray(i); factor_.scale(ray)) scaled.add(ray, rays.left[i]);
    return inner_->left_by_lanes(scaled) + rays.size() - scaled.size();
  }
  NearestHit nearest_of_one(const Ray& ray, const Left& left, bool tangents) const override {
    Ray scaled = ray;
    return factor_.scale(scaled) ? inner_->nearest_of_one(scaled, left, tangents)
                                 : as_given_->nearest_of_one(ray, left, tangents);
  }
  std::size_t tested_of_one(const Ray& ray, const Left& left) const override {
    Ray scaled = ray;
    return factor_.scale(scaled) ? inner_->tested_of_one(scaled, left)
                                 : as_given_->tested_of_one(ray, left);
  }
  std::vector<NearestHit> all_of_one(const Ray& ray, const Left& left,
                                     bool tangents) const override {
    Ray scaled = ray;
    return factor_.scale(scaled) ? inner_->all_of_one(scaled, left, tangents)
                                 : as_given_->all_of_one(ray, left, tangents);
  }
  std::size_t bytes() const override {
    return inner_->bytes() + as_given_->bytes() + scaled_->size() * sizeof(Segment);
  }
  std::string structure() const override { return inner_->structure(); }
  std::size_t cells() const override { return inner_->cells(); }

 private:
  const std::unique_ptr<const Surfaces> scaled_;
  const Factor factor_;
  const std::unique_ptr<Accelerator> inner_, as_given_;
};

}  // namespace

bool is_unusual(const Surfaces& walls) { return std::abs(factor_of(walls).exponent) > kUsual; }

std::unique_ptr<Accelerator> trace_rescaled(
    const Surfaces& walls, std::unique_ptr<Accelerator>& as_given,
    const std::function<std::unique_ptr<Accelerator>(const Surfaces&)>& build) {
  if (!walls.curve_numbers.empty()) return nullptr;
  const Factor factor = factor_of(walls);
  if (factor.exponent == 0) return nullptr;
  auto scaled = std::make_unique<Surfaces>(walls);
  for (Segment& wall : scaled->segments) {
    const bool a = factor.scale(wall.a), b = factor.scale(wall.b);
    if (!a || !b) return nullptr;
  }
  auto inner = build(*scaled);
  return std::make_unique<Rescaled>(walls, std::move(scaled), factor, std::move(inner),
                                    std::move(as_given));
}

}  // namespace flatray
