#include "base/processor_time.h"

#include <ctime>

namespace flatray {

double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

}  // namespace flatray
