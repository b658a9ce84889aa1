#include <algorithm>

#include "study/periodic/closed_orbits.h"

namespace flatray {
namespace {

constexpr int kMostBoxes = 20'000;
constexpr double kLeastHalf = 0x1p-10;

// Boxes of places: each curve is two charts of half of it, q from -1 to 1.
class OrbitExclusion {
 public:
  OrbitExclusion(const MirrorRoom& room, const Word& word)
      : room_(room), word_(word), unfolded_(unfold(room, word, curved_places(room, word))) {}

  bool rules_out_all() {
    const std::size_t n = unfolded_.bounces.size();
    for (std::size_t charts = 0; charts < std::size_t{1} << n; ++charts) {
      for (std::size_t i = 0; i < n; ++i)
        unfolded_.bounces[i].at = {(charts >> i & 1) == 0 ? 1.0 : -1.0, 0};
      if (!rules_out(std::vector<double>(n, 0), std::vector<double>(n, 1))) return false;
    }
    return true;
  }

 private:
  // Gives up at the first box that is too small, and not ruled out.
  bool rules_out(const std::vector<double>& middle, const std::vector<double>& half) {
    if (++boxes_ > kMostBoxes) return false;
    std::vector<Near> box;
    for (std::size_t i = 0; i < middle.size(); ++i) box.push_back(Near::within(middle[i], half[i]));
    StationaryPolygon polygon(unfolded_.bounces);
    if (!polygon.may_be_within(box)) return true;
    const Judged judged = judge(room_, word_, polygon, unfolded_.legs);
    if ((judged.reflects & judged.clear) == Proof::no) return true;
    const auto widest = std::ranges::max_element(half) - half.begin();
    const auto k = static_cast<std::size_t>(widest);
    if (half[k] < kLeastHalf) return false;
    std::vector<double> part = half, low = middle, high = middle;
    part[k] = half[k] / 2;
    low[k] -= part[k];
    high[k] += part[k];
    return rules_out(low, part) && rules_out(high, part);
  }

  const MirrorRoom& room_;
  const Word& word_;
  Unfolded unfolded_;
  int boxes_ = 0;
};

}  // namespace

bool is_ruled_out(const MirrorRoom& room, const Word& word) {
  constexpr std::size_t kMostCurves = 4;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (word[i] == word[(i + 1) % word.size()] && room.mirrors[word[i]].arc) return false;
  const std::size_t curves = curved_places(room, word).size();
  return curves > 0 && curves <= kMostCurves && OrbitExclusion(room, word).rules_out_all();
}

}  // namespace flatray
