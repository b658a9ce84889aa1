#include <algorithm>
#include <cmath>

#include "render/film_shape.h"
#include "render/frame.h"
#include "scene/outlines/easy_font.h"
#include "study/plots/drawing.h"
#include "study/plots/palette.h"

namespace flatray {
namespace {

constexpr int kChords = 24;  // of a Bezier curve

LinearColour colour_of(const std::string& ink) {
  const LinearRgb light = light_of_hex(ink_colour(ink, false));
  return {static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b), 1};
}

// De Casteljau.
Vec2 along(std::vector<Vec2> points, double t) {
  for (; points.size() > 1; points.pop_back())
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      points[i] = (1 - t) * points[i] + t * points[i + 1];
  return points.front();
}

class Painter {
 public:
  Painter(const Drawing& drawing, double scale) : scale_(scale) {
    list_.width = static_cast<int>(std::lround(drawing.size.x() * scale));
    list_.height = static_cast<int>(std::lround(drawing.size.y() * scale));
    list_.background = colour_of("paper");
    for (const auto& mark : drawing.marks) std::visit([this](const auto& one) { add(one); }, mark);
  }

  Image image(unsigned threads) const {
    Image image = render_image(list_, {std::nullopt, threads});
    for (const Drawing::Picture* picture : pictures_) lay(*picture, image);
    return image;
  }

 private:
  void add(const Drawing::Path& path) {
    std::vector<Vec2> points;
    if (path.bezier)
      for (int i = 0; i <= kChords; ++i)
        points.push_back(scale_ * along(path.points, static_cast<double>(i) / kChords));
    else
      for (const Vec2& point : path.points) points.push_back(scale_ * point);
    FilmShape line;
    if (!path.pen.fill.empty() || path.closed) line.crossing_rings.push_back(points);
    if (!path.pen.fill.empty()) paint(fill_regions(line), path.pen.fill);
    if (!path.closed) line = FilmShape{}, line.curves.push_back({std::move(points)});
    stroke(line, path.pen);
  }
  void add(const Drawing::Disc& disc) {
    FilmShape circle;
    circle.circles.push_back({scale_ * disc.centre, scale_ * disc.radius});
    if (!disc.pen.fill.empty()) paint(fill_regions(circle), disc.pen.fill);
    stroke(circle, disc.pen);
  }
  // A pixel of the font is a unit of the drawing; the first stands on a pixel of the picture.
  void add(const Drawing::Words& words) {
    std::string shown;
    for (const char c : words.words) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= ' ' && byte <= '~')
        shown += c;
      else if ((byte & 0xC0U) != 0x80U)
        shown += '?';
    }
    const FontLine line = font_line(shown);
    const Vec2 right = words.upright ? Vec2(0, -scale_) : Vec2(scale_, 0);
    const Vec2 up = words.upright ? Vec2(-scale_, 0) : Vec2(0, -scale_);
    Vec2 start = scale_ * words.at - words.anchor * line.width * right - 0.5 * kFontCapitals * up;
    start = {std::floor(start.x() + 0.5), std::floor(start.y() + 0.5)};
    FillPath letters;
    for (const FontPixel& pixel : line.pixels) {
      const Vec2 a = start + pixel.x * right + pixel.y * up;
      const Vec2 corners[] = {a, a + right, a + right + up, a + up};
      for (std::size_t i = 0; i < 4; ++i)
        letters.edges.push_back({corners[i], corners[(i + 1) % 4]});
    }
    if (!letters.edges.empty()) paint({letters}, words.ink);
  }
  void add(const Drawing::Picture& picture) { pictures_.push_back(&picture); }

  void stroke(const FilmShape& shape, const Pen& pen) {
    if (pen.stroke.empty()) return;
    LineLook line{{0.5 * pen.width * scale_}, dashes_of(pen)};
    for (double& length : line.dashes) length *= scale_;
    if (!line.dashes.empty()) line.style.caps = LineCap::butt;
    CornerBudget budget{10'000'000};
    paint(line_regions(shape, line, budget), pen.stroke);
  }
  void paint(std::vector<Region> regions, const std::string& ink) {
    for (Region& region : regions) list_.items.push_back({std::move(region), colour_of(ink)});
  }

  void lay(const Drawing::Picture& picture, Image& onto) const {
    const auto edge = [&](double at) { return static_cast<int>(std::lround(at * scale_)); };
    const int left = edge(picture.corner.x()), top = edge(picture.corner.y());
    const int width = edge(picture.corner.x() + picture.size.x()) - left,
              height = edge(picture.corner.y() + picture.size.y()) - top;
    for (int y = std::max(0, -top); y < std::min(height, onto.height - top); ++y)
      for (int x = std::max(0, -left); x < std::min(width, onto.width - left); ++x) {
        const auto part = [](int at, int of, int size) {
          return static_cast<int>((2 * std::int64_t{at} + 1) * size / (2 * std::int64_t{of}));
        };
        const std::uint8_t* from = picture.image.at(part(x, width, picture.image.width),
                                                    part(y, height, picture.image.height));
        std::copy_n(from, 3, onto.at(left + x, top + y));
      }
  }

  double scale_;
  DrawList list_;
  std::vector<const Drawing::Picture*> pictures_;
};

}  // namespace

Image pixels(const Drawing& drawing, double scale, unsigned threads) {
  return Painter(drawing, scale).image(threads);
}

}  // namespace flatray
