#pragma once
#include <vector>

#include "study/plots/drawing.h"

namespace flatray::testing {

/// The marks of one kind, in order.
template <class Mark>
std::vector<Mark> marks_of(const Drawing& drawing) {
  std::vector<Mark> found;
  for (const auto& mark : drawing.marks)
    if (const auto* one = std::get_if<Mark>(&mark)) found.push_back(*one);
  return found;
}

}  // namespace flatray::testing
