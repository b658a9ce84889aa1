#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "app/answers/orbit_report.h"
#include "base/number_text.h"
#include "geom/bounds.h"
#include "study/plots/svg_text.h"
#include "study/rooms/wall_places.h"

namespace flatray {
namespace {

constexpr double kPictureWidth = 800, kLine = 1.2;  // pixels of the picture
constexpr std::size_t kMostNumbers = 60;
constexpr std::array kColours = {"#b3261e", "#1f5fa8", "#2c7a3f", "#8a4fb0", "#c26a00", "#3d6f7d"};

class OrbitDrawing {
 public:
  explicit OrbitDrawing(const OrbitRoom& room)
      : room_(room), box_(room.window), scale_(kPictureWidth / box_.size().x()) {}

  void draw_walls() {
    const Surfaces& walls = room_.world.surfaces;
    for (const std::uint32_t number : walls.segment_numbers) draw_wall(walls, number);
    for (const std::uint32_t number : walls.curve_numbers)
      if (!walls.visit(number, [](const auto& wall) { return is_disc(wall); }))
        draw_wall(walls, number);
    for (const Arc& wall : walls.arcs)
      if (is_disc(wall))
        world_ += fmt::format("<circle class=\"wall\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n",
                              number_text(wall.curve.centre.x()),
                              number_text(wall.curve.centre.y()), number_text(wall.curve.u.x()));
  }

  static bool is_disc(const Arc& wall) {
    return centre_of_circle(wall) && wall.extent == Arc::Extent::whole;
  }
  template <class Wall>
  static bool is_disc(const Wall&) {
    return false;
  }

  void draw_wall(const Surfaces& walls, std::uint32_t surface) {
    std::string way;
    for (const Vec2& point : wall_outline(walls, surface))
      way += (way.empty() ? "M" : "L") + text(point);
    world_ += fmt::format("<path class=\"wall\" d=\"{}\"/>\n", way);
  }

  void draw(const OrbitReport& report, std::size_t number) {
    const Orbit& orbit = report.orbit;
    const char* colour = kColours[number % kColours.size()];
    std::vector<OrbitLine> lines = orbit_lines(orbit);
    if (leaves(orbit)) lines.back().line.b = border(lines.back().line.a, orbit.out);
    std::string way = "M" + text(orbit.start);
    Vec2 last = orbit.start;
    for (const OrbitLine& part : lines) {
      if (part.line.a != last) way += "M" + text(part.line.a);
      way += "L" + text(part.line.b);
      last = part.line.b;
    }
    world_ += fmt::format("<path class=\"ray\" stroke=\"{}\" d=\"{}\"><title>{}</title></path>\n",
                          colour, way, svg_text(report.ray));
    mark(orbit.start, colour, 3.5);
    for (std::size_t i = 0; i < std::min(orbit.bounces.size(), kMostNumbers); ++i) {
      const Vec2 at = film(orbit.bounces[i].point);
      mark(orbit.bounces[i].point, i < report.certain ? colour : "#999", 2);
      if (orbit.bounces.size() <= kMostNumbers)
        film_ += fmt::format("<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n",
                             svg_number(at.x() + 4), svg_number(at.y() - 4), colour, i + 1);
    }
  }

  std::string text() const {
    const double height = box_.size().y() * scale_;
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"sans-serif\" font-size=\"11\">\n"
        "<style>path, circle {{ fill: none }} .wall {{ stroke: #444 }} .mark {{ stroke: none }}"
        "</style>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        "<g stroke-width=\"{7}\" transform=\"matrix({2} 0 0 -{2} {3} {4})\">\n{5}</g>\n{6}</svg>\n",
        svg_number(kPictureWidth), svg_number(height), number_text(scale_),
        number_text(-box_.low.x() * scale_), number_text(box_.high.y() * scale_), world_, film_,
        number_text(kLine / scale_));
  }

 private:
  static std::string text(const Vec2& world) {
    return number_text(world.x()) + " " + number_text(world.y());
  }
  Vec2 film(const Vec2& world) const {
    return {(world.x() - box_.low.x()) * scale_, (box_.high.y() - world.y()) * scale_};
  }
  // Where a ray from inside the picture leaves it.
  Vec2 border(const Vec2& from, const Vec2& out) const {
    double t = 2 * box_.size().lpNorm<1>();
    for (int axis = 0; axis < 2; ++axis) {
      const double edge = out[axis] > 0 ? box_.high[axis] : box_.low[axis];
      if (out[axis] != 0) t = std::min(t, (edge - from[axis]) / out[axis]);
    }
    return from + std::max(t, 0.0) * out;
  }
  void mark(const Vec2& world, const char* colour, double radius) {
    const Vec2 at = film(world);
    film_ +=
        fmt::format("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"{}\" style=\"fill: {}\"/>\n",
                    svg_number(at.x()), svg_number(at.y()), radius, colour);
  }

  const OrbitRoom& room_;
  Bounds box_;
  double scale_;
  std::string world_, film_;
};

}  // namespace

std::string svg_of(const OrbitRoom& room, const std::vector<OrbitReport>& reports) {
  OrbitDrawing drawing(room);
  drawing.draw_walls();
  for (std::size_t i = 0; i < reports.size(); ++i) drawing.draw(reports[i], i);
  return drawing.text();
}

}  // namespace flatray
