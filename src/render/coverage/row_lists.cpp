#include "render/coverage/row_lists.h"

#include <algorithm>
#include <bit>

namespace flatray {

RowLists::RowLists(std::size_t rows)
    : rows_(rows), leaves_(std::bit_ceil(rows)), blocks_(2 * leaves_) {}

void RowLists::add(std::uint32_t number, std::size_t first, std::size_t last) {
  std::size_t begin = first + leaves_;
  std::size_t end = (last + 1 == rows_ ? leaves_ : last + 1) + leaves_;  // all rows are one block
  for (; begin < end; begin /= 2, end /= 2) {
    if (begin % 2 == 1) blocks_[begin++].push_back(number);
    if (end % 2 == 1) blocks_[--end].push_back(number);
  }
}

void RowLists::list(std::size_t row, std::vector<std::uint32_t>& out) const {
  out.clear();
  for (std::size_t block = row + leaves_; block > 0; block /= 2) {
    const std::vector<std::uint32_t>& more = blocks_[block];
    const auto before = static_cast<std::ptrdiff_t>(out.size());
    out.insert(out.end(), more.begin(), more.end());
    if (before > 0 && !more.empty())
      std::inplace_merge(out.begin(), out.begin() + before, out.end());
  }
}

}  // namespace flatray
