#include "render/row_lengths.h"

#include <algorithm>

namespace flatray {
namespace {

double error_of(std::span<const Range> parts) {
  double last = 0;
  for (const Range& part : parts) last = std::max(last, part.high);
  return (8 * static_cast<double>(parts.size()) + 8) * 0x1p-52 * last;
}

}  // namespace

RowLengths::RowLengths(std::vector<Range> parts)
    : error_(error_of(parts)), set_(interval_set(std::move(parts))), after_(set_.size()) {
  for (std::size_t i = set_.size(); i-- > 1;)
    after_[i - 1] = after_[i] + (set_[i].high - set_[i].low);
}

double RowLengths::ahead(double t) {
  while (next_ < set_.size() && set_[next_].high <= t) ++next_;
  if (next_ == set_.size()) return 0;
  return after_[next_] + (set_[next_].high - std::max(set_[next_].low, t));
}

}  // namespace flatray
