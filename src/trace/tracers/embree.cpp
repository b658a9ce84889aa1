#include <algorithm>
#include <cmath>
#include <new>

#include "base/check.h"
#include "base/module_file.h"
#include "trace/embree/module.h"
#include "trace/plain.h"
#include "trace/tracer.h"

namespace flatray::embree_tracer {
namespace {

LoadedTable<FlatrayEmbreeModule> find_module() {
  auto found = load_table(kEmbreeModule, FLATRAY_EMBREE_ENTRY, &FlatrayEmbreeModule::abi,
                          FLATRAY_EMBREE_ABI);
  if (found.table == nullptr)
    found.problem += "; tools/setup --bench installs what it is built from, then build again";
  return found;
}

// The power of two that makes the larger part of a direction 1 to 2 in size: products of a long one
// with edges of 1e15 would overflow in single precision, and Embree meet nothing.
double unit_scale(const Vec2& direction) {
  const double most = direction.cwiseAbs().maxCoeff();
  return most > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(most), -1000, 1000)) : 1;
}

// A box in single precision that holds a curve and what rounding its numbers to floats makes of it.
FlatrayEmbreeBox box_around(const Bounds& box) {
  const double reach = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  const double more = 0x1p-20 * reach;
  const auto number = [](double x) { return static_cast<float>(x); };
  return {number(box.low.x() - more), number(box.low.y() - more), number(box.high.x() + more),
          number(box.high.y() + more)};
}

class Embree : public Accelerator {
 public:
  Embree(const Surfaces& walls, const FlatrayEmbreeModule& module)
      : Accelerator(walls), module_(module) {
    std::vector<FlatrayEmbreeBox> boxes;
    for (const std::uint32_t i : walls.curve_numbers)
      boxes.push_back(box_around(walls.visit(i, [](const auto& wall) { return bounds_of(wall); })));
    const FlatrayEmbreeWalls given = {
        walls.segments.empty() ? nullptr : walls.segments.front().a.data(),
        static_cast<unsigned>(walls.segments.size()), boxes.data(),
        static_cast<unsigned>(boxes.size())};
    bool out_of_memory = false;
    scene_ = module.build(&given, &out_of_memory);
    if (out_of_memory) throw std::bad_alloc();
    FLATRAY_CHECK(scene_ != nullptr, "Embree makes no device");
  }
  ~Embree() override { module_.release(scene_); }

  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    std::vector<FlatrayEmbreeRay> given;
    Asked asked{*this, rays, hits, {}};
    std::vector<FlatrayEmbreeHit> met(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Ray ray = rays.ray(i);
      asked.scale.push_back(unit_scale(ray.direction));
      const auto start = plain::start_of<float>({ray.origin, asked.scale[i] * ray.direction});
      given.push_back(
          {start.x, start.y, start.dx, start.dy, walls_.segment_slot(rays.departed[i].surface)});
      hits[i] = {};
    }
    const FlatrayEmbreeAsker asker = {&meets, &asked};
    module_.nearest(scene_, given.data(), static_cast<unsigned>(given.size()), &asker, met.data());
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (met[i].wall == kNoSurface)
        hits[i] = {};
      else if (!met[i].curve)  // of curves meets() has left it there
        hits[i] = {walls_.segment_numbers[met[i].wall], HitClass::touch, Root::none, false,
                   asked.scale[i] * static_cast<double>(met[i].t)};
  }
  std::size_t bytes() const override { return 0; }  // Embree does not say

 private:
  // What a call is about, and what it has found of curves.
  struct Asked {
    const Embree& tracer;
    const RayBatch& rays;
    std::span<NearestHit> hits;
    std::vector<double> scale;
  };

  // The formulas of the tracer `float`.
  static bool meets(void* asker, unsigned ray, unsigned curve, float* t) {
    const Asked& asked = *static_cast<const Asked*>(asker);
    NearestHit best;
    best.t = asked.scale[ray] * static_cast<double>(*t);
    const Surfaces& walls = asked.tracer.walls_;
    plain::offer_curve<float>(walls, walls.curve_numbers[curve], asked.rays.ray(ray),
                              asked.rays.departed[ray], best);
    if (!best) return false;
    asked.hits[ray] = best;
    *t = plain::single(best.t / asked.scale[ray]);
    return true;
  }

  const FlatrayEmbreeModule& module_;
  FlatrayEmbreeScene* scene_ = nullptr;
};

std::unique_ptr<Accelerator> build(const Surfaces& walls, Isa, unsigned) {
  const auto found = find_module();
  FLATRAY_CHECK(found.table != nullptr, found.problem.c_str());
  return std::make_unique<Embree>(walls, *found.table);
}

}  // namespace

extern const Tracer entry = {
    "embree", "Embree, robust, a module loaded at run time; single precision: not exact", false,
    &build, [] { return find_module().problem; }};

}  // namespace flatray::embree_tracer
