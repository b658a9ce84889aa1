#include "collide/box_grid.h"

#include <algorithm>

namespace flatray {

BoxGrid::BoxGrid(std::vector<Bounds> boxes) : boxes_(std::move(boxes)), seen_(boxes_.size(), 0) {
  put_in_cells();
}

void BoxGrid::put_in_cells() {
  constexpr std::size_t kMostAcross = 1024;
  std::vector<double> widths;
  for (const Bounds& box : boxes_)
    if (!box.empty()) widths.push_back(box.size().maxCoeff());
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  if (!widths.empty()) std::nth_element(widths.begin(), middle, widths.end());
  width_ = !widths.empty() && *middle > 0 && *middle < kInfinity ? *middle : 1;
  across_ = 1;
  while (across_ < kMostAcross && across_ * across_ < widths.size()) across_ *= 2;
  first_.assign(across_ * across_, kNone);
  entries_.clear();
  large_.clear();
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    if (!boxes_[i].empty()) put_in_cells(i);
  most_kept_ = 2 * (entries_.size() + large_.size()) + boxes_.size();
}

void BoxGrid::put_in_cells(std::uint32_t number) {
  const bool is_small = each_list(boxes_[number], [&](std::size_t list) {
    entries_.push_back({number, first_[list]});
    first_[list] = static_cast<std::uint32_t>(entries_.size() - 1);
  });
  if (!is_small) large_.push_back(number);
}

void BoxGrid::change(std::uint32_t number, const Bounds& box) {
  boxes_[number] = box;
  if (box.empty()) return;
  put_in_cells(number);
  // Boxes that are gone stay in their cells: many would be looked at for each that counts.
  if (entries_.size() + large_.size() > most_kept_) put_in_cells();
}

}  // namespace flatray
