#pragma once
#include "study/statistics/estimate.h"

namespace flatray {

/// A share of samples that are counted, without an error where fewer than ten are of one kind: its spread says
/// too little then, and of none nothing.
inline void withhold_error_of_few(Measure& share, const RatioSums& counted) {
  constexpr double kFewest = 10;
  if (counted.x >= kFewest && counted.y - counted.x >= kFewest) return;
  share.standard_error.reset();
  share.remark +=
      std::string(share.remark.empty() ? "" : "; ") + "no error: fewer than ten are of one kind";
}

}  // namespace flatray
