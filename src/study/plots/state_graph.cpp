#include "study/plots/state_graph.h"

#include <algorithm>

#include "base/portable_math.h"
#include "geom/bounds.h"

namespace flatray {
namespace {

// Lengths in pixels of the picture.
constexpr double kHalfLetter = 7, kSmallestState = 30, kGap = 5, kTitleHeight = 30, kMargin = 12;
constexpr double kTip = 9, kHalfTip = 4;  // of an arrow: length, half width
constexpr double kLoopHeight = 52,
                 kLoopSpread = 0.45;   // of a self loop: reach, half angle at the state
constexpr double kBend = 0.16;         // of an arrow: sideways, as a share of its length
constexpr double kLabelPlace = 0.42;   // along an arrow: off the middle, where others cross
constexpr double kSmallestRing = 2.6;  // in radii of a state
constexpr double kSpacing = 4.8;       // along the ring from state to state, in radii of a state
constexpr double kHalfTurn = 0x1.921fb54442d18p+1;

Vec2 turned(double angle) { return {portable::cos(angle), portable::sin(angle)}; }

class GraphDrawing {
 public:
  explicit GraphDrawing(const StateGraph& graph) : graph_(graph) {
    double longest = 0;
    for (const std::string& state : graph.states) longest = std::max(longest, words_width(state));
    radius_ = std::max(kSmallestState, longest / 2 + 6);
    const auto count = static_cast<double>(graph.states.size());
    ring_ = count < 2 ? 0 : radius_ * std::max(kSmallestRing, kSpacing * count / (2 * kHalfTurn));
    out_.title = graph.title;
  }

  // Drawn about the origin first, to see how far it reaches.
  Drawing drawing() && {
    draw();
    const Bounds box = box_;
    out_.marks.clear();
    out_.size = {std::max(box.size().x(), words_width(graph_.title)) + 2 * kMargin,
                 box.size().y() + kTitleHeight + 2 * kMargin};
    centre_ = Vec2(out_.size.x() / 2, kTitleHeight + kMargin) -
              Vec2(0.5 * (box.low.x() + box.high.x()), box.low.y());
    label({out_.size.x() / 2, kTitleHeight / 2 + 4}, graph_.title, true);
    draw();
    return std::move(out_);
  }

 private:
  void draw() {
    box_.add(centre_);
    for (const StateGraph::Arrow& arrow : graph_.arrows)
      arrow.from == arrow.to ? loop(arrow) : bend(arrow);
    for (std::size_t i = 0; i < graph_.states.size(); ++i) {
      out_.marks.push_back(Drawing::Disc{place(i), radius_, {"text", "paper", 1.5}});
      for (const double side : {-radius_, radius_}) box_.add(place(i) + Vec2::Constant(side));
      label(place(i), graph_.states[i]);
    }
  }
  double angle(std::size_t i) const {
    return 2 * kHalfTurn * static_cast<double>(i) / static_cast<double>(graph_.states.size()) -
           kHalfTurn / 2;
  }
  Vec2 place(std::size_t i) const { return centre_ + ring_ * turned(angle(i)); }

  void label(const Vec2& at, const std::string& words, bool bold = false) {
    const Vec2 half(words_width(words) / 2, kHalfLetter);
    box_.add(at - half);
    box_.add(at + half);
    out_.marks.push_back(Drawing::Words{at, words, 0.5, "text", false, bold});
  }
  // Beside `at`, far enough to the given side for the words not to touch the arrow.
  void arrow_label(const Vec2& at, const Vec2& side, const std::string& words) {
    const Vec2 away = side.normalized();
    label(at + Vec2(away.x() * (words_width(words) / 2 + kGap), away.y() * (kHalfLetter + kGap)),
          words);
  }
  void draw_arrow(std::vector<Vec2> curve) {
    const Vec2 end = curve.back(), along = (end - curve[curve.size() - 2]).normalized();
    const Vec2 across(-along.y(), along.x()), neck = end - kTip * along;
    curve.back() = neck;
    out_.marks.push_back(Drawing::Path{std::move(curve), {"axis", "", 1.5}, false, true});
    out_.marks.push_back(Drawing::Path{
        {end, neck + kHalfTip * across, neck - kHalfTip * across}, {"", "axis"}, true});
  }

  // From rim to rim, bent to its left so that the way back does not cover it.
  void bend(const StateGraph::Arrow& arrow) {
    const Vec2 from = place(arrow.from), to = place(arrow.to), along = to - from;
    const Vec2 middle = 0.5 * (from + to) + kBend * Vec2(along.y(), -along.x());
    const Vec2 out = from + radius_ * (middle - from).normalized();
    const Vec2 in = to + radius_ * (middle - to).normalized();
    draw_arrow({out, middle, in});
    const double t = kLabelPlace, s = 1 - t;
    arrow_label(s * s * out + 2 * s * t * middle + t * t * in, Vec2(along.y(), -along.x()),
                arrow.label);
  }

  // Away from the ring's centre.
  void loop(const StateGraph::Arrow& arrow) {
    const double outward = angle(arrow.from);
    const Vec2 centre = place(arrow.from);
    const Vec2 left = turned(outward - kLoopSpread), right = turned(outward + kLoopSpread);
    const double reach = radius_ + kLoopHeight;
    draw_arrow({centre + radius_ * left, centre + reach * left, centre + reach * right,
                centre + radius_ * right});
    // A cubic reaches three quarters of the way to its handles.
    arrow_label(centre + (radius_ + 0.75 * kLoopHeight) * turned(outward), turned(outward),
                arrow.label);
  }

  const StateGraph& graph_;
  double radius_ = 0, ring_ = 0;
  Vec2 centre_{0, 0};
  Bounds box_;  // of what is drawn
  Drawing out_;
};

}  // namespace

Drawing drawing_of(const StateGraph& graph) { return GraphDrawing(graph).drawing(); }

}  // namespace flatray
