#include "geom/box_tree.h"

#include <algorithm>
#include <numeric>

namespace flatray {

BoxTree::BoxTree(std::vector<Bounds> boxes)
    : boxes_(std::move(boxes)), order_(boxes_.size()), around_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  part(0, boxes_.size());
}

std::vector<std::size_t> BoxTree::near(const Bounds& box) const {
  std::vector<std::size_t> found;
  find(box, 0, boxes_.size(), found);
  return found;
}

void BoxTree::part(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  Bounds all;
  for (std::size_t i = begin; i < end; ++i) all.add(boxes_[order_[i]]);
  const Eigen::Index axis = all.size().x() < all.size().y() ? 1 : 0;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
    return boxes_[a].low[axis] < boxes_[b].low[axis];
  });
  around_[middle] = all;
  part(begin, middle);
  part(middle + 1, end);
}

void BoxTree::find(const Bounds& box, std::size_t begin, std::size_t end,
                   std::vector<std::size_t>& found) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  if (!around_[middle].meets(box)) return;
  if (boxes_[order_[middle]].meets(box)) found.push_back(order_[middle]);
  find(box, begin, middle, found);
  find(box, middle + 1, end, found);
}

}  // namespace flatray
