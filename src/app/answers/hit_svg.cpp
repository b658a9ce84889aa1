#include "app/answers/hit_svg.h"

#include <fmt/core.h>

#include "base/number_text.h"
#include "geom/bounds.h"
#include "geom/cyrus_beck.h"
#include "scene/outlines/outline.h"
#include "study/plots/svg_text.h"

namespace flatray {
namespace {

constexpr double kWidth = 640, kMargin = 0.08;

Vec2 at(const Ray& ray, double t) { return ray.origin + t * ray.direction; }

class Diagram {
 public:
  Diagram(const Scene& scene, const FrameState& state) : scene_(scene), state_(state) {}

  void see(std::uint32_t entity) {
    const Shape& shape = shape_of(scene_, state_, entity);
    const Pose place = entity_pose(state_, entity);
    for (const Vec2& vertex : shape.vertices) box_.add(place(vertex));
    for (const Segment& segment : shape.segments) {
      box_.add(place(segment.a));
      box_.add(place(segment.b));
    }
    for (const Circle& circle : shape.circles) {
      const Circle there = posed(circle, place);
      for (const double side : {-1.0, 1.0})
        box_.add(there.centre + Vec2::Constant(side * there.radius));
    }
  }
  void see(const HitReport& report) {
    box_.add(report.ray.ray.origin);
    if (std::isfinite(report.within.high)) box_.add(at(report.ray.ray, report.within.high));
  }
  // All has been seen that the picture must hold.
  void frame() {
    const Vec2 size = box_.size();
    const double margin = kMargin * std::max({size.x(), size.y(), 1e-300});
    box_.low -= Vec2::Constant(margin);
    box_.high += Vec2::Constant(margin);
    scale_ = kWidth / box_.size().x();
  }

  void draw(std::uint32_t entity) {
    const Shape& shape = shape_of(scene_, state_, entity);
    const Pose place = entity_pose(state_, entity);
    for (const OutlineEdge& edge : outline(shape))
      line(place(shape.vertices[edge.from]), place(shape.vertices[edge.to]), "wall");
    for (const Segment& segment : shape.segments) line(place(segment.a), place(segment.b), "wall");
    for (const Circle& circle : shape.circles) {
      const Circle there = posed(circle, place);
      const Vec2 centre = film(there.centre);
      body_ += fmt::format("<circle class=\"wall\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n",
                           svg_number(centre.x()), svg_number(centre.y()),
                           svg_number(there.radius * scale_));
    }
  }
  void draw_ray(const HitReport& report) {
    const Ray& ray = report.ray.ray;
    const Range shown = shown_part(ray, report.within);
    if (shown.low <= shown.high) line(at(ray, shown.low), at(ray, shown.high), "ray");
    mark(ray.origin, "origin", report.ray.name);
  }
  void draw_inside(const HitReport& report) {
    if (!report.hit) return;
    const Ray& ray = report.ray.ray;
    const Range shown = shown_part(ray, report.within);
    const double enter = std::max(report.hit.t_enter, shown.low);
    const double exit = std::min(report.hit.t_exit, shown.high);
    line(at(ray, enter), at(ray, exit), "inside");
    for (const double t : {report.hit.t_enter, report.hit.t_exit})
      if (std::isfinite(t)) mark(at(ray, t), "end", "t = " + number_text(t));
  }

  std::string text() const {
    const double height = box_.size().y() * scale_;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
               "height=\"{1}\" font-family=\"sans-serif\" font-size=\"11\">\n"
               "<style>.wall {{ stroke: #444; fill: none }} .ray {{ stroke: #2f5fb3 }} "
               ".inside {{ stroke: #d0471f; stroke-width: 4; stroke-linecap: round }} "
               ".origin {{ fill: #2f5fb3 }} .end {{ fill: #d0471f }}</style>\n"
               "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
               svg_number(kWidth), svg_number(height)) +
           body_ + "</svg>\n";
  }

 private:
  Vec2 film(const Vec2& world) const {
    return {(world.x() - box_.low.x()) * scale_, (box_.high.y() - world.y()) * scale_};
  }
  // What of a ray lies in the picture.
  Range shown_part(const Ray& ray, Range within) const {
    const std::array<Vec2, 4> corners = {
        box_.low, {box_.high.x(), box_.low.y()}, box_.high, {box_.low.x(), box_.high.y()}};
    const HitInterval part = clip_convex(ray, corners, within);
    return {std::max(part.t_enter, -1e300), std::min(part.t_exit, 1e300)};
  }
  void line(const Vec2& from, const Vec2& to, const char* kind) {
    const Vec2 a = film(from), b = film(to);
    body_ +=
        fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", kind,
                    svg_number(a.x()), svg_number(a.y()), svg_number(b.x()), svg_number(b.y()));
  }
  void mark(const Vec2& place, const char* kind, const std::string& label) {
    const Vec2 p = film(place);
    body_ += fmt::format(
        "<circle class=\"{0}\" cx=\"{1}\" cy=\"{2}\" r=\"3\"/>\n"
        "<text class=\"{0}\" x=\"{3}\" y=\"{4}\">{5}</text>\n",
        kind, svg_number(p.x()), svg_number(p.y()), svg_number(p.x() + 5), svg_number(p.y() - 5),
        svg_text(label));
  }

  const Scene& scene_;
  const FrameState& state_;
  Bounds box_;
  double scale_ = 1;
  std::string body_;
};

}  // namespace

std::string svg_of(const Scene& scene, const FrameState& state,
                   std::span<const std::uint32_t> entities, std::span<const HitReport> reports) {
  Diagram diagram(scene, state);
  for (const std::uint32_t entity : entities) diagram.see(entity);
  for (const HitReport& report : reports) diagram.see(report);
  diagram.frame();
  for (const std::uint32_t entity : entities) diagram.draw(entity);
  for (const HitReport& report : reports) diagram.draw_ray(report);
  for (const HitReport& report : reports) diagram.draw_inside(report);
  return diagram.text();
}

}  // namespace flatray
