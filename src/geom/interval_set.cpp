#include "geom/interval_set.h"

#include <algorithm>

namespace flatray {

IntervalSet interval_set(std::vector<Range> parts) {
  std::erase_if(parts, [](const Range& part) { return !(part.low <= part.high); });
  std::ranges::sort(parts, {}, &Range::low);
  std::size_t kept = 0;
  for (const Range& part : parts) {
    if (kept > 0 && part.low <= parts[kept - 1].high)
      parts[kept - 1].high = std::max(parts[kept - 1].high, part.high);
    else
      parts[kept++] = part;
  }
  parts.resize(kept);
  return parts;
}

IntervalSet union_of(std::span<const Range> a, std::span<const Range> b) {
  IntervalSet both(a.begin(), a.end());
  both.insert(both.end(), b.begin(), b.end());
  return interval_set(std::move(both));
}

IntervalSet intersection_of(std::span<const Range> a, std::span<const Range> b) {
  IntervalSet shared;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const Range part{std::max(a[i].low, b[j].low), std::min(a[i].high, b[j].high)};
    if (part.low <= part.high) shared.push_back(part);
    if (a[i].high < b[j].high)
      ++i;
    else
      ++j;
  }
  return shared;
}

IntervalSet difference_of(std::span<const Range> a, std::span<const Range> b) {
  IntervalSet left;
  std::size_t next = 0;
  for (Range part : a) {
    while (next < b.size() && b[next].high < part.low) ++next;
    bool whole = true;
    for (std::size_t j = next; j < b.size() && b[j].low <= part.high && whole; ++j) {
      if (part.low < b[j].low) left.push_back({part.low, b[j].low});
      part.low = b[j].high;
      whole = part.low < part.high;
    }
    if (whole) left.push_back(part);
  }
  return interval_set(std::move(left));  // a single point taken out leaves no gap
}

double length_of(std::span<const Range> set) {
  double sum = 0;
  for (const Range& part : set) sum += part.high - part.low;
  return sum;
}

}  // namespace flatray
