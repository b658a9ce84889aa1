#include "render/coverage/chains.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace flatray {
namespace {

// Edges by the point they begin at, to be taken once each.
class Beginnings {
 public:
  explicit Beginnings(std::span<const Segment> edges) : edges_(edges), taken_(edges.size()) {}

  bool take(std::size_t i) {
    if (taken_[i]) return false;
    return taken_[i] = true;
  }

  std::optional<std::size_t> take_at(const Vec2& point) {
    if (order_.empty()) sort();
    auto found =
        std::lower_bound(order_.begin(), order_.end(), point,
                         [this](std::size_t i, const Vec2& p) { return before(edges_[i].a, p); });
    for (; found != order_.end() && edges_[*found].a == point; ++found)
      if (take(*found)) return *found;
    return std::nullopt;
  }

 private:
  static bool before(const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  }
  void sort() {
    order_.resize(edges_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [this](std::size_t i, std::size_t k) {
      return before(edges_[i].a, edges_[k].a) || (edges_[i].a == edges_[k].a && i < k);
    });
  }

  std::span<const Segment> edges_;
  std::vector<bool> taken_;
  std::vector<std::size_t> order_;
};

void close_if_back(Chain& chain) {
  chain.closed = chain.points.size() > 2 && chain.points.front() == chain.points.back();
  if (chain.closed) chain.points.pop_back();
}

double length_of(const Vec2& a, const Vec2& b) { return std::sqrt((b - a).squaredNorm()); }

// Walks a chain and cuts it.
class Dasher {
 public:
  Dasher(std::span<const double> lengths, double offset) : lengths_(lengths) {
    const double period = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    left_ = offset - period * std::floor(offset / period);
    while (left_ > 0 && left_ >= lengths_[index_] && index_ + 1 < lengths_.size())
      left_ -= lengths_[index_++];
    left_ = std::max(lengths_[index_] - left_, 0.0);
  }

  void walk(const std::vector<Vec2>& points) {
    started_on_ = is_line();
    if (started_on_) dash_.points.push_back(points.front());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) leg(points[i], points[i + 1]);
  }

  // `joined`: the walk came back to where it began.
  std::vector<Chain> finish(bool joined) {
    if (dash_.points.size() < 2) return std::move(dashes_);  // none, or one that begins at the end
    if (joined && dashes_.empty() && started_on_) close_if_back(dash_);
    if (joined && started_on_ && !dashes_.empty()) {
      Chain& first = dashes_.front();
      dash_.points.insert(dash_.points.end(), first.points.begin() + 1, first.points.end());
      first.points = std::move(dash_.points);
    } else {
      dashes_.push_back(std::move(dash_));
    }
    return std::move(dashes_);
  }

 private:
  bool is_line() const { return index_ % 2 == 0; }

  void leg(const Vec2& a, const Vec2& b) {
    const double length = length_of(a, b);
    if (!(length > 0)) return;
    const Vec2 ahead = (b - a) / length;
    double at = 0;
    while (left_ <= length - at) {
      at += left_;
      cut(a + at * ahead, ahead);
    }
    left_ -= length - at;
    if (is_line() && at < length) dash_.points.push_back(b);
  }

  void cut(const Vec2& point, const Vec2& ahead) {
    if (is_line()) {
      dash_.points.push_back(point);
      dash_.ahead = ahead;
      dashes_.push_back(std::move(dash_));
    }
    dash_ = {};
    index_ = (index_ + 1) % lengths_.size();
    left_ = lengths_[index_];
    if (is_line()) dash_.points.push_back(point);
  }

  std::span<const double> lengths_;
  std::size_t index_ = 0;
  double left_ = 0;  // of the present line or gap
  bool started_on_ = false;
  Chain dash_;
  std::vector<Chain> dashes_;
};

}  // namespace

std::vector<Chain> chained(std::span<const Segment> lines) {
  std::vector<Chain> chains;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == 0 || lines[i].a != lines[i - 1].b) chains.push_back({{lines[i].a}});
    chains.back().points.push_back(lines[i].b);
  }
  for (Chain& chain : chains) close_if_back(chain);
  return chains;
}

std::vector<Chain> rings_of(std::span<const Segment> edges) {
  std::vector<Chain> rings;
  Beginnings beginnings(edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!beginnings.take(i)) continue;
    Chain ring{{edges[i].a, edges[i].b}};
    std::size_t last = i;
    while (ring.points.back() != ring.points.front()) {
      const bool in_turn = last + 1 < edges.size() && edges[last + 1].a == edges[last].b &&
                           beginnings.take(last + 1);
      const auto next = in_turn ? std::optional(last + 1) : beginnings.take_at(ring.points.back());
      if (!next) break;
      last = *next;
      ring.points.push_back(edges[last].b);
    }
    close_if_back(ring);
    rings.push_back(std::move(ring));
  }
  return rings;
}

Chain chain_of(const ArcPath& film_path) {
  Chain chain{flattened(film_path, kCapSagitta_px)};
  if (film_path.closed) close_if_back(chain);
  return chain;
}

std::vector<Chain> dashed(const Chain& chain, std::span<const double> lengths, double offset) {
  constexpr double kMostDashes = 1e6;
  std::vector<Vec2> points = chain.points;
  if (chain.closed) points.push_back(points.front());
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) length += length_of(points[i], points[i + 1]);
  const double period = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const double count = length / period * static_cast<double>(lengths.size() / 2);
  if (!(count <= kMostDashes) || !(length > 0)) return {chain};
  Dasher dasher(lengths, offset);
  dasher.walk(points);
  return dasher.finish(chain.closed);
}

}  // namespace flatray
