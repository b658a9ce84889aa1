#include "study/statistics/streaming_histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/npy.h"

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
  for (std::size_t i = 0; i + 1 < counts_.size(); ++i)
    table.add({from(i), from(i) + width_, counts_[i], all > 0 ? counts_[i] / (all * width_) : 0});
  table.add({from(counts_.size() - 1), kInfinity, counts_.back(), ""});
  return table;
}

void StreamingHistogram::add_files(ExperimentResult& result, const std::string& name,
                                   const std::string& caption) const {
  using Kind = NpyTable::Kind;
  NpyTable numbers(
      {{"from", Kind::real}, {"to", Kind::real}, {"count", Kind::whole}, {"density", Kind::real}},
      counts_.size());
  const Table bins = table();
  for (const Values& row : bins.rows) {
    for (const std::size_t end : {0U, 1U}) numbers.add(*row[end].as_number());
    numbers.add(*row[2].as_whole());
    numbers.add(row[3].as_number().value_or(std::nan("")));
  }
  result.files.push_back(csv_file(name, bins));
  result.files.push_back({name + ".npy", std::move(numbers).take(), caption});
}

double StreamingHistogram::chi_squared_of_even() const {
  const auto bins = counts_.end() - 1;
  const double even = count() / static_cast<double>(counts_.size() - 1);
  double sum = 0;
  for (auto bin = counts_.begin(); bin != bins; ++bin) sum += (*bin - even) * (*bin - even) / even;
  return sum;
}

}  // namespace flatray
