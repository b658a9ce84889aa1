#include "study/statistics/streaming_histogram.h"

#include <algorithm>
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

double StreamingHistogram::density(std::size_t bin, double all) const {
  return all > 0 ? counts_[bin] / (all * width_) : 0;
}

Table StreamingHistogram::table() const {
  Table table({"from", "to", "count", "density"});
  const double all = count();
  for (std::size_t i = 0; i + 1 < counts_.size(); ++i)
    table.add({from(i), from(i) + width_, counts_[i], density(i, all)});
  table.add({from(counts_.size() - 1), kInfinity, counts_.back(), ""});
  return table;
}

void StreamingHistogram::add_files(ExperimentResult& result, const std::string& name,
                                   const std::string& caption) const {
  using Kind = NpyTable::Kind;
  NpyTable numbers(
      {{"from", Kind::real}, {"to", Kind::real}, {"count", Kind::whole}, {"density", Kind::real}},
      counts_.size());
  const double all = count();
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const bool last = i + 1 == counts_.size();
    numbers.add(from(i));
    numbers.add(last ? kInfinity : from(i) + width_);
    numbers.add(static_cast<std::uint64_t>(counts_[i]));
    numbers.add(last ? 0.0 : density(i, all));
  }
  result.files.push_back(csv_file(name, table()));
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
