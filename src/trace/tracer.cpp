#include "trace/tracer.h"

#include <algorithm>

#include "base/check.h"

namespace flatray {

#define FLATRAY_ENTRY(name) extern const Tracer name##_tracer;
#include "tracers.inc"
#undef FLATRAY_ENTRY

std::vector<const Tracer*> tracers() {
  return {
#define FLATRAY_ENTRY(name) &name##_tracer,
#include "tracers.inc"
#undef FLATRAY_ENTRY
  };
}

const Tracer* find_tracer(std::string_view name) {
  const std::vector<const Tracer*> all = tracers();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Tracer* each) { return each->name == name; });
  return found == all.end() ? nullptr : *found;
}

const Tracer& usual_tracer() {
  const std::vector<const Tracer*> all = tracers();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const Tracer* each) { return each->exact; });
  FLATRAY_CHECK(found != all.end(), "no exact tracer is registered in this build");
  return **found;
}

}  // namespace flatray
