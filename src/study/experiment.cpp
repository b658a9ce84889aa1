#include "study/experiment.h"

namespace flatray {

#define FLATRAY_ENTRY(name) extern const Experiment name;
namespace experiment_entries {
#include "experiments.inc"
}  // namespace experiment_entries
#undef FLATRAY_ENTRY

std::vector<const Experiment*> experiments() {
  return {
#define FLATRAY_ENTRY(name) &experiment_entries::name,
#include "experiments.inc"
#undef FLATRAY_ENTRY
  };
}

}  // namespace flatray
