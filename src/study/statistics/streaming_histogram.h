#pragma once
#include "base/table.h"
#include "study/statistics/blocks.h"

namespace flatray {

/// How numbers are spread, counted as they come: it needs no more memory for 10^9 of them than for
/// ten. Bins are equally wide; what lies above the last is counted there, too, by itself.
class StreamingHistogram {
 public:
  StreamingHistogram(double low, double high, std::size_t bins);

  /// Needs   a number that is not below the first bin.
  void add(double number);
  double count() const;  ///< of all
  double above() const { return counts_.back(); }

  /// A row for each bin: its ends, how many, their density; the last up to infinity without one.
  Table table() const;
  /// NAME.csv of these rows, and NAME.npy (base/npy.h) with a caption.
  void add_files(ExperimentResult& result, const std::string& name,
                 const std::string& caption) const;
  /// Pearson's sum of (counted - even)^2 / even over the bins, if numbers were equally likely in
  /// all.
  double chi_squared_of_even() const;

  void append_to(SumList& list) { append(list, counts_); }

 private:
  double from(std::size_t bin) const { return low_ + width_ * static_cast<double>(bin); }

  double low_, width_;
  Numbers counts_;  // one more than there are bins
};

}  // namespace flatray
