#include "trace/rays.h"

namespace flatray {

void RayBatch::add(const Ray& ray, const DepartedSurface& from) {
  resize(size() + 1);
  set(size() - 1, ray, from);
}

void RayBatch::resize(std::size_t count) {
  for (std::vector<double>* column : {&ox, &oy, &dx, &dy}) column->resize(count);
  departed.resize(count);
}

}  // namespace flatray
