#include "study/statistics/streaming_histogram.h"

#include <algorithm>
#include <numeric>

namespace flatray {

StreamingHistogram::StreamingHistogram(double low, double high, std::size_t bins)
    : low_(low), width_((high - low) / static_cast<double>(bins)), counts_(bins + 1, 0.0) {}

void StreamingHistogram::add(double number) {
  const double last = static_cast<double>(counts_.size() - 1);
  const double bin = std::clamp((number - low_) / width_, 0.0, last);
  ++counts_[static_cast<std::size_t>(bin)];
}

double StreamingHistogram::count() const {
  return std::accumulate(counts_.begin(), counts_.end(), 0.0);
}

Table StreamingHistogram::table() const {
  Table table({"from", "to", "count", "density"});
  const double all = count();
  for (std::size_t i = 0; i + 1 < counts_.size(); ++i) {
    const double from = low_ + width_ * static_cast<double>(i);
    table.add({from, from + width_, counts_[i], all > 0 ? counts_[i] / (all * width_) : 0});
  }
  table.add(
      {low_ + width_ * static_cast<double>(counts_.size() - 1), kInfinity, counts_.back(), ""});
  return table;
}

double StreamingHistogram::chi_squared_of_even() const {
  const auto bins = counts_.end() - 1;
  const double even = count() / static_cast<double>(counts_.size() - 1);
  double sum = 0;
  for (auto bin = counts_.begin(); bin != bins; ++bin) sum += (*bin - even) * (*bin - even) / even;
  return sum;
}

void StreamingHistogram::add_counts(std::span<const double> numbers) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += numbers[i];
}

}  // namespace flatray
