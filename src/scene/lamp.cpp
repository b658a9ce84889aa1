#include "scene/lamp.h"

namespace flatray {
namespace lamps {
#define FLATRAY_ENTRY(name) extern const LampType name;
#include "lamps.inc"
#undef FLATRAY_ENTRY
}  // namespace lamps

std::vector<const LampType*> lamp_types() {
  return {
#define FLATRAY_ENTRY(name) &lamps::name,
#include "lamps.inc"
#undef FLATRAY_ENTRY
  };
}

std::unique_ptr<const Emitter> emitter_at(const Scene& scene, const Lamp& lamp, double time) {
  Args args(scene, lamp.source, time);
  Result<std::unique_ptr<const Emitter>> emitter = lamp.type->build(args);
  return emitter && !args.gone() ? std::move(*emitter) : nullptr;
}

std::vector<Listed> listed_lamps() {
  std::vector<Listed> all;
  for (const auto* type : lamp_types()) all.push_back({type->name, type->summary});
  return all;
}

}  // namespace flatray
