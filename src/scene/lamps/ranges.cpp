#include <array>

#include "geom/turn.h"
#include "scene/lamp.h"

namespace flatray::ranges_lamp {
namespace {

constexpr const char* kTakes = "number, [low, high] or a curve";
// In the order in which they take numbers: directions decide most of a picture.
constexpr KeyInfo kKeys[] = {{"ray_angle", kTakes, "0"},
                             {"polar_angle", kTakes, "0"},
                             {"polar_distance", kTakes, "0"},
                             {"x", kTakes, "0"},
                             {"y", kTakes, "0"}};
enum : std::size_t { kRayAngle, kPolarAngle, kPolarDistance, kX, kY, kCount };

class Ranges : public Emitter {
 public:
  explicit Ranges(const std::array<Vec2, kCount>& ranges) {
    for (std::size_t i = 0; i < kCount; ++i) {
      low_[i] = ranges[i].x(), extent_[i] = ranges[i].y() - ranges[i].x();
      // What stays needs no number, so that what does not has the most even ones.
      if (extent_[i] != 0) number_[i] = used_++;
    }
  }

  Emitted emit(const double* u) const override {
    std::array<double, kCount> value{};
    for (std::size_t i = 0; i < kCount; ++i) value[i] = low_[i] + u[number_[i]] * extent_[i];
    const Turn out = turn(value[kRayAngle]), place = turn(value[kPolarAngle]);
    return {Vec2(value[kX], value[kY]) + value[kPolarDistance] * Vec2(place.cos, place.sin),
            {out.cos, out.sin}};
  }

 private:
  std::array<double, kCount> low_{}, extent_{};
  std::array<std::size_t, kCount> number_{};
  std::size_t used_ = 0;
};

Result<std::unique_ptr<const Emitter>> build(Args& args) {
  constexpr double kFarthestStart = 1e150;  // sums of products stay doubles
  std::array<Vec2, kCount> ranges;
  for (std::size_t i = 0; i < kCount; ++i) {
    ranges[i] = args.range(kKeys[i].name);
    if (!(ranges[i].cwiseAbs().maxCoeff() <= kFarthestStart))
      args.problem(kKeys[i].name, "reaches beyond 1e150", "write numbers between -1e150 and 1e150");
    if (i == kRayAngle || i == kPolarAngle)
      ranges[i] = {radians(ranges[i].x()), radians(ranges[i].y())};
  }
  return std::make_unique<Ranges>(ranges);
}

}  // namespace

extern const LampType entry = {"ranges",
                               "every number of a start is drawn evenly from a range of its own",
                               kKeys, kCount, &build};

}  // namespace flatray::ranges_lamp
