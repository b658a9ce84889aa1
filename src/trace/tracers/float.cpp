#include "trace/plain.h"
#include "trace/tracer.h"

namespace flatray::float_tracer {
namespace {

class Float : public Accelerator {
 public:
  explicit Float(const Surfaces& walls) : Accelerator(walls) {
    using plain::single;
    for (const Segment& s : walls.segments)
      edges_.push_back(
          {single(s.a.x()), single(s.a.y()), single(s.b.x() - s.a.x()), single(s.b.y() - s.a.y())});
  }
  NearestHit nearest_of_one(const Ray& ray, const DepartedSurface& departed, bool) const override {
    const plain::Start<float> start = plain::start_of<float>(ray);
    NearestHit best;
    float least = plain::kNever;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const float t = plain::time_of(start, edges_[i]);
      if (!(t < least) || walls_.segment_numbers[i] == departed.surface) continue;
      least = t;
      best = {walls_.segment_numbers[i], HitClass::touch, Root::none, false,
              static_cast<double>(t)};
    }
    plain::offer_curves<float>(walls_, ray, departed, best);
    return best;
  }
  std::size_t bytes() const override { return edges_.size() * sizeof(plain::Line); }

 private:
  std::vector<plain::Line> edges_;
};

}  // namespace

extern const Tracer entry = {
    "float", "every wall in plain single precision: not exact, to see what that gets wrong", false,
    [](const Surfaces& walls, Isa, unsigned) -> std::unique_ptr<Accelerator> {
      return std::make_unique<Float>(walls);
    }};

}  // namespace flatray::float_tracer
