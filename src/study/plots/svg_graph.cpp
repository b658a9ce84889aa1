#include "study/plots/svg_graph.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "geom/vec.h"
#include "study/plots/svg_text.h"

namespace flatray {
namespace {

// Lengths in pixels of the picture.
constexpr double kFontSize = 14, kLetterWidth = 8.6, kSmallestState = 30, kGap = 5,
                 kTitleHeight = 30;
constexpr double kLoopHeight = 52,
                 kLoopSpread = 0.45;   // of a self loop: reach, half angle at the state
constexpr double kBend = 0.16;         // of an arrow: sideways, as a share of its length
constexpr double kLabelPlace = 0.42;   // along an arrow: off the middle, where others cross
constexpr double kSmallestRing = 2.6;  // in radii of a state
constexpr double kSpacing = 4.8;       // along the ring from state to state, in radii of a state
constexpr double kHalfTurn = 0x1.921fb54442d18p+1;

std::string point(const Vec2& p) { return svg_number(p.x()) + " " + svg_number(p.y()); }

Vec2 turned(double angle) { return {portable::cos(angle), portable::sin(angle)}; }

class Drawing {
 public:
  explicit Drawing(const StateGraph& graph) : graph_(graph) {
    std::size_t longest = 0;
    for (const std::string& state : graph.states) longest = std::max(longest, state.size());
    radius_ = std::max(kSmallestState, kLetterWidth * static_cast<double>(longest) / 2 + 6);
    const auto count = static_cast<double>(graph.states.size());
    ring_ = count < 2 ? 0 : radius_ * std::max(kSmallestRing, kSpacing * count / (2 * kHalfTurn));
    std::size_t widest = 0;
    for (const StateGraph::Arrow& arrow : graph.arrows)
      widest = std::max(widest, arrow.label.size());
    const double reach =
        ring_ + radius_ + kLoopHeight + kLetterWidth * static_cast<double>(widest) + kGap;
    size_ = {2 * reach, 2 * reach + kTitleHeight};
    centre_ = {reach, reach + kTitleHeight};
  }

  std::string svg() {
    open();
    for (const StateGraph::Arrow& arrow : graph_.arrows)
      arrow.from == arrow.to ? loop(arrow) : bend(arrow);
    for (std::size_t i = 0; i < graph_.states.size(); ++i) state(i);
    return text_ + "</svg>\n";
  }

 private:
  double angle(std::size_t i) const {
    return 2 * kHalfTurn * static_cast<double>(i) / static_cast<double>(graph_.states.size()) -
           kHalfTurn / 2;
  }
  Vec2 place(std::size_t i) const { return centre_ + ring_ * turned(angle(i)); }

  void open() {
    text_ = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" "
        "font-family=\"sans-serif\" font-size=\"{2}\" text-anchor=\"middle\">\n"
        "<title>{3}</title>\n"
        "<defs><marker id=\"tip\" viewBox=\"0 0 10 10\" refX=\"10\" refY=\"5\" markerWidth=\"8\" "
        "markerHeight=\"8\" orient=\"auto\"><path d=\"M0 0L10 5L0 10z\" "
        "fill=\"#444\"/></marker></defs>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        svg_number(size_.x()), svg_number(size_.y()), kFontSize, svg_text(graph_.title));
    label({centre_.x(), kTitleHeight / 2 + 4}, graph_.title, " font-weight=\"bold\"");
  }

  void label(const Vec2& at, const std::string& words, const char* style) {
    text_ += fmt::format("<text x=\"{}\" y=\"{}\" dy=\"0.35em\"{}>{}</text>\n", svg_number(at.x()),
                         svg_number(at.y()), style, svg_text(words));
  }
  // Beside `at`, far enough to the given side for the words not to touch the arrow.
  void arrow_label(const Vec2& at, const Vec2& side, const std::string& words) {
    const double half_width = kLetterWidth * static_cast<double>(words.size()) / 2;
    const Vec2 away = side.normalized();
    label(at + Vec2(away.x() * (half_width + kGap), away.y() * (kFontSize / 2 + kGap)), words,
          " fill=\"#06c\"");
  }
  void path(const std::string& way) {
    text_ += fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"#444\" stroke-width=\"1.5\" "
        "marker-end=\"url(#tip)\"/>\n",
        way);
  }

  // From rim to rim, bent to its left so that the way back does not cover it.
  void bend(const StateGraph::Arrow& arrow) {
    const Vec2 from = place(arrow.from), to = place(arrow.to), along = to - from;
    const Vec2 middle = 0.5 * (from + to) + kBend * Vec2(along.y(), -along.x());
    const Vec2 out = from + radius_ * (middle - from).normalized();
    const Vec2 in = to + radius_ * (middle - to).normalized();
    path(fmt::format("M{}Q{} {}", point(out), point(middle), point(in)));
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
    path(fmt::format("M{}C{} {} {}", point(centre + radius_ * left), point(centre + reach * left),
                     point(centre + reach * right), point(centre + radius_ * right)));
    // A cubic reaches three quarters of the way to its handles.
    arrow_label(centre + (radius_ + 0.75 * kLoopHeight) * turned(outward), turned(outward),
                arrow.label);
  }

  void state(std::size_t i) {
    const Vec2 at = place(i);
    text_ += fmt::format(
        "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#eef4ff\" stroke=\"#222\" "
        "stroke-width=\"1.5\"/>\n",
        svg_number(at.x()), svg_number(at.y()), svg_number(radius_));
    label(at, graph_.states[i], "");
  }

  const StateGraph& graph_;
  double radius_ = 0, ring_ = 0;
  Vec2 size_{0, 0}, centre_{0, 0};
  std::string text_;
};

}  // namespace

std::string svg(const StateGraph& graph) { return Drawing(graph).svg(); }

}  // namespace flatray
