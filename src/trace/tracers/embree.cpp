#include <algorithm>
#include <cmath>
#include <new>

#include "base/check.h"
#include "base/module_file.h"
#include "trace/embree/module.h"
#include "trace/plain.h"
#include "trace/tracer.h"

namespace flatray {
namespace {

// The module, or why there is none.
struct Found {
  const FlatrayEmbreeModule* module = nullptr;
  std::string problem;
};

Found find_module() {
  const LoadedEntry loaded = load_module(kEmbreeModule, FLATRAY_EMBREE_ENTRY);
  if (loaded.entry == nullptr)
    return {nullptr, loaded.problem +
                         "; tools/setup --bench installs what it is built from, then build again"};
  const FlatrayEmbreeModule* module = reinterpret_cast<FlatrayEmbreeEntry>(loaded.entry)();
  if (module == nullptr || module->abi != FLATRAY_EMBREE_ABI)
    return {nullptr, "its module belongs to another version of flatray"};
  return {module, ""};
}

// The power of two that makes the larger part of a direction 1 to 2 in size: products of a long one
// with edges of 1e15 would overflow in single precision, and Embree meet nothing.
double unit_scale(const Vec2& direction) {
  const double most = direction.cwiseAbs().maxCoeff();
  return most > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(most), -1000, 1000)) : 1;
}

class Embree : public Accelerator {
 public:
  Embree(const Surfaces& walls, const FlatrayEmbreeModule& module)
      : Accelerator(walls), module_(module) {
    bool out_of_memory = false;
    scene_ = module.build(walls.segments.empty() ? nullptr : walls.segments.front().a.data(),
                          static_cast<unsigned>(walls.segments.size()), &out_of_memory);
    if (out_of_memory) throw std::bad_alloc();
    FLATRAY_CHECK(scene_ != nullptr, "Embree makes no device");
  }
  ~Embree() override { module_.release(scene_); }

  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    std::vector<FlatrayEmbreeRay> given;
    std::vector<double> scale;
    std::vector<FlatrayEmbreeHit> met(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Ray asked = rays.ray(i);
      scale.push_back(unit_scale(asked.direction));
      const auto ray = plain::start_of<float>({asked.origin, scale[i] * asked.direction});
      given.push_back({ray.x, ray.y, ray.dx, ray.dy, walls_.segment_slot(rays.left[i].surface)});
    }
    module_.nearest(scene_, given.data(), static_cast<unsigned>(given.size()), met.data());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits[i] = {};
      if (met[i].segment != kNoSurface)
        hits[i] = {walls_.segment_numbers[met[i].segment], HitClass::touch, Root::none, false,
                   scale[i] * static_cast<double>(met[i].t)};
      plain::offer_curves<float>(walls_, rays.ray(i), rays.left[i], hits[i]);
    }
  }
  std::size_t bytes() const override { return 0; }  // Embree does not say

 private:
  const FlatrayEmbreeModule& module_;
  FlatrayEmbreeScene* scene_ = nullptr;
};

std::unique_ptr<Accelerator> build(const Surfaces& walls, Isa, unsigned) {
  const Found found = find_module();
  FLATRAY_CHECK(found.module != nullptr, found.problem.c_str());
  return std::make_unique<Embree>(walls, *found.module);
}

}  // namespace

extern const Tracer embree_tracer;
const Tracer embree_tracer = {
    "embree", "Embree, robust, a module loaded at run time; single precision: not exact", false,
    &build, [] { return find_module().problem; }};

}  // namespace flatray
