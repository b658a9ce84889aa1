#pragma once
#include <algorithm>
#include <cmath>
#include <memory>

#include "study/accuracy/accuracy.h"

namespace flatray {

/// A frame as choices draw it: what is true of its linear light, and what a setting drew last.
struct DrawnFrame {
  DrawList list;
  unsigned threads = 1;
  LinearImage truth{}, drawn{};
};
/// The middle one of a scene, by exact areas whatever the scene asks for; nothing is drawn yet.
Result<std::shared_ptr<DrawnFrame>> frame_to_draw(const AccuracyContext& context);

/// Root mean square of the differences. Needs   as many numbers in both.
template <class Number>
double rms_difference(const std::vector<Number>& a, const std::vector<Number>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double off = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(a.size(), 1)));
}

}  // namespace flatray
