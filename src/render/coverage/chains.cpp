#include "render/coverage/chains.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace flatray {
namespace {

void close_if_back(Chain& chain) {
  chain.closed = chain.points.size() > 2 && chain.points.front() == chain.points.back();
  if (chain.closed) chain.points.pop_back();
}

// Points nearer to each other than this are one: less than a picture shows, more than positions on
// a film and sums of lengths are rounded by.
constexpr double kSame_px = 0x1p-20;
constexpr double kCurveSagitta_px = 0.5 * kCapSagitta_px;  // the rest is for what the width adds

// Of a curve: a point, and its direction there, (0, 0) where it has none.
struct CurvePoint {
  Vec2 point, ahead;
};

void go_to(const CurvePoint& to, const Vec2& from, Chain& chain) {
  const Vec2 chord = to.point - chain.points.back();
  if (chord == Vec2(0, 0)) return;
  chain.points.push_back(to.point);
  for (const Vec2& ahead : {from, to.ahead})
    chain.ahead.push_back((ahead == Vec2(0, 0) ? chord : ahead).stableNormalized());
}

void go_straight(const Vec2& point, Chain& chain) {
  if (chain.points.empty())
    chain.points.push_back(point);
  else if ((point - chain.points.back()).stableNorm() > kSame_px)
    go_to({point, {0, 0}}, {0, 0}, chain);
}

// Goes on by chords of a curve over [0, 1].
template <class Curve>
void add_chords(const Curve& at, double chords, Chain& chain) {
  CurvePoint from = at(0);
  for (int i = 1; i <= static_cast<int>(chords); ++i) {
    const CurvePoint to = at(i / chords);
    go_to(to, from.ahead, chain);
    from = to;
  }
}

void add_arc(const EllipseArc& arc, Chain& chain) {
  const double way = arc.sweep < 0 ? -1 : 1;
  const EllipseArc ahead{{0, 0}, way * arc.v, -way * arc.u};
  const auto at = [&](double s) {
    const double t = arc.from + arc.sweep * s;
    return CurvePoint{arc.at(t), ahead.at(t)};
  };
  go_straight(arc.start(), chain);
  add_chords(at, chord_count(arc, kCurveSagitta_px), chain);
}

// Of control points that lie on an end, the next one tells the direction.
Vec2 ahead_at(const Bezier& curve, double s) {
  Vec2 ahead = tangent_at(curve, s);
  for (int k = 2; ahead == Vec2(0, 0) && k <= curve.degree; ++k) {
    if (s == 0) ahead = curve.point(k) - curve.start();
    if (s == 1) ahead = curve.end() - curve.point(curve.degree - k);
  }
  return ahead;
}

// Parameters between which the curve turns to one side only, so that chords turn as their ends say.
std::vector<double> bends(const Bezier& curve) {
  std::vector<double> cuts{0};
  if (curve.degree == 3) {
    // The second derivative beside the first is proportional to c + b s + a s^2.
    const Vec2 p = curve.point(1) - curve.start(), q = curve.point(2) - curve.point(1) - p,
               r = curve.end() - curve.point(2) - p - 2 * q;
    const double a = cross(q, r), b = cross(p, r), c = cross(p, q);
    const double h = b + std::copysign(std::sqrt(std::max(b * b - 4 * a * c, 0.0)), b);
    for (const double s : {-h / (2 * a), -2 * c / h})
      if (s > 0 && s < 1) cuts.push_back(s);
    std::sort(cuts.begin(), cuts.end());
  }
  cuts.push_back(1);
  return cuts;
}

// An acceleration up to A bends no further from k chords than A / (8 k^2).
void add_curve(const Bezier& curve, Chain& chain) {
  constexpr double kMostChords = 0x1p17;
  const double wanted = std::sqrt(most_acceleration(curve) / (8 * kCurveSagitta_px));
  const std::vector<double> cuts = bends(curve);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const auto at = [&](double part) {
      const double s = part < 1 ? cuts[k] + part * (cuts[k + 1] - cuts[k]) : cuts[k + 1];
      return CurvePoint{s < 1 ? point_at(curve, s) : curve.end(), ahead_at(curve, s)};
    };
    const double chords = std::min(wanted, kMostChords) * (cuts[k + 1] - cuts[k]);
    add_chords(at, std::max(1.0, std::ceil(chords)), chain);
  }
}

// Walks a chain and cuts it.
class Dasher {
 public:
  Dasher(std::span<const double> lengths, double offset) : lengths_(lengths) {
    const double period = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    double passed = std::fmod(offset, period);
    if (passed < 0) passed += period;
    while (passed > kSame_px && passed >= lengths_[index_] - kSame_px) {
      passed -= lengths_[index_];
      index_ = (index_ + 1) % lengths_.size();
    }
    left_ = std::max(lengths_[index_] - passed, 0.0);
  }

  std::vector<Chain> walk(const std::vector<ChainLeg>& legs, bool closed) {
    const bool starts = is_line();
    if (starts) dash_.points.push_back(legs.front().a);
    for (const ChainLeg& leg : legs) walk(leg);
    const bool unfinished = dash_.points.size() > 1;  // one that begins at the end is none
    if (unfinished) dashes_.push_back(std::move(dash_));
    if (closed && starts && (unfinished || (ended_ && !is_line()))) join_ends();
    return std::move(dashes_);
  }

 private:
  bool is_line() const { return index_ % 2 == 0; }

  void walk(const ChainLeg& leg) {
    Vec2 from = leg.from;
    const auto go_to = [&](const Vec2& point, const Vec2& to) {
      dash_.points.push_back(point);
      dash_.ahead.insert(dash_.ahead.end(), {from, to});
    };
    double at = 0;
    ended_ = false;
    while (left_ <= leg.length - at + kSame_px) {
      at += left_;
      const double part = at < leg.length ? at / leg.length : 1;
      const Vec2 ahead = (leg.from + part * (leg.to - leg.from)).stableNormalized();
      ended_ = at >= leg.length - kSame_px;
      const Vec2 point = ended_ ? leg.b : leg.a + part * (leg.b - leg.a);
      if (is_line()) {
        go_to(point, ahead);
        dashes_.push_back(std::move(dash_));
      }
      dash_ = {};
      index_ = (index_ + 1) % lengths_.size();
      left_ = lengths_[index_];
      if (is_line()) dash_.points.push_back(point);
      from = ahead;
    }
    left_ -= leg.length - at;
    if (is_line() && !ended_) go_to(leg.b, leg.to);
  }

  // The last dash ends where the first begins.
  void join_ends() {
    Chain last = std::move(dashes_.back());
    dashes_.pop_back();
    if (dashes_.empty()) {
      close_if_back(last);
      return dashes_.push_back(std::move(last));
    }
    Chain& first = dashes_.front();
    last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
    last.ahead.insert(last.ahead.end(), first.ahead.begin(), first.ahead.end());
    first = std::move(last);
  }

  std::span<const double> lengths_;
  std::size_t index_ = 0;
  double left_ = 0;     // of the present line or gap
  bool ended_ = false;  // at the end of the leg
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
  std::vector<char> taken(edges.size(), 0);
  const auto take = [&](std::size_t i) { return std::exchange(taken[i], 1) == 0; };
  std::vector<std::size_t> order;  // by the point they begin at, once one is looked for
  const auto beginning = [&](std::size_t i) -> const Vec2& { return edges[i].a; };
  const auto take_at = [&](const Vec2& point) -> std::optional<std::size_t> {
    if (order.empty()) {
      order.resize(edges.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::ranges::stable_sort(order, is_before, beginning);
    }
    auto found = std::ranges::lower_bound(order, point, is_before, beginning);
    for (; found != order.end() && edges[*found].a == point; ++found)
      if (take(*found)) return *found;
    return std::nullopt;
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!take(i)) continue;
    Chain ring{{edges[i].a, edges[i].b}};
    std::size_t last = i;
    while (ring.points.back() != ring.points.front()) {
      const bool in_turn =
          last + 1 < edges.size() && edges[last + 1].a == edges[last].b && take(last + 1);
      const auto next = in_turn ? std::optional(last + 1) : take_at(ring.points.back());
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
  Chain chain;
  for (const EllipseArc& arc : film_path.arcs) add_arc(arc, chain);
  if (!film_path.closed) return chain;
  go_straight(chain.points.front(), chain);
  chain.points.back() = chain.points.front();
  close_if_back(chain);
  return chain;
}

std::vector<Chain> chains_of(std::span<const Bezier> film_curves) {
  std::vector<Chain> chains;
  for (const Bezier& curve : film_curves) {
    if (chains.empty() || chains.back().points.back() != curve.start())
      chains.push_back({{curve.start()}});
    add_curve(curve, chains.back());
  }
  for (Chain& chain : chains) close_if_back(chain);
  return chains;
}

std::vector<Chain> dashed(const Chain& chain, std::span<const double> lengths, double offset) {
  constexpr double kMostDashes = 1e6;
  const std::vector<ChainLeg> legs = legs_of(chain);
  double length = 0;
  for (const ChainLeg& leg : legs) length += leg.length;
  const double period = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const double count = length / period * 0.5 * static_cast<double>(lengths.size());
  if (!(count <= kMostDashes) || !(length > 0)) return {chain};
  return Dasher(lengths, offset).walk(legs, chain.closed);
}

}  // namespace flatray
