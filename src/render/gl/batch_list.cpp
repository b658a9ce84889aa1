#include "render/gl/batch_list.h"

#include <algorithm>
#include <utility>

namespace flatray::gl {
namespace {

FlatrayGlVertex vertex(const GridPoint& point, const VertexPaint& paint) {
  const auto pixels = [](std::int64_t steps) {
    return static_cast<float>(static_cast<double>(steps) / kGridSteps);
  };
  const auto& [a, b, c, d] = paint.words;
  return {pixels(point.x), pixels(point.y), {a, b, c, d}};
}

}  // namespace

void CellBox::add(const CellBox& more) {
  x0 = std::min(x0, more.x0), y0 = std::min(y0, more.y0);
  x1 = std::max(x1, more.x1), y1 = std::max(y1, more.y1);
}

// Those a figure can touch, with a pixel around it for the shifts of its samples.
CellBox BatchList::box(std::span<const GridPoint> points) const {
  constexpr auto kStep = static_cast<std::int64_t>(kGridSteps);
  std::int64_t x0 = width_ * kStep, x1 = 0, y0 = height_ * kStep, y1 = 0;
  for (const GridPoint& p : points) {
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
  }
  const auto low = [](std::int64_t steps) {
    return static_cast<int>(std::max<std::int64_t>((steps >> 8) - 1, 0));
  };
  const auto high = [](std::int64_t steps, int limit) {
    return static_cast<int>(std::min<std::int64_t>((steps >> 8) + 2, limit));
  };
  static_assert(kStep == 1 << 8);
  return {low(x0), low(y0), high(x1, width_), high(y1, height_)};
}

// A batch of its own, unless the last is painted likewise.
void BatchList::begin(FlatrayGlKind kind, const VertexPaint& paint) {
  const std::int32_t gradients = paint.gradient ? 1 : 0;
  const bool goes_on = kind == FLATRAY_GL_PAINT && !all_.batches.empty() &&
                       all_.batches.back().kind == kind &&
                       all_.batches.back().gradients == gradients;
  if (goes_on) return;
  all_.batches.push_back({kind, gradients, static_cast<std::uint32_t>(all_.vertices.size()), 0});
}

void BatchList::add_fan(std::span<const GridPoint> corners, const VertexPaint& paint) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    if (area(corners[0], corners[i], corners[i + 1]) == 0) continue;
    for (const GridPoint& corner : {corners[0], corners[i], corners[i + 1]})
      all_.vertices.push_back(vertex(corner, paint));
    all_.batches.back().count += 3;
  }
}

void BatchList::add_box(FlatrayGlKind kind, const CellBox& box, const VertexPaint& paint) {
  begin(kind, paint);
  const auto corner = [](int x, int y) { return on_grid({x, y}); };
  add_fan(std::array{corner(box.x0, box.y0), corner(box.x1, box.y0), corner(box.x1, box.y1),
                     corner(box.x0, box.y1)},
          paint);
}

void BatchList::paint(std::span<const GridPoint> corners, const VertexPaint& paint) {
  const CellBox box = this->box(corners);
  if (box.empty()) return;
  reach_.add(box);
  begin(FLATRAY_GL_PAINT, paint);
  add_fan(corners, paint);
}

void BatchList::mark(FlatrayGlKind kind, std::span<const std::vector<GridPoint>> figures,
                     const VertexPaint& paint) {
  CellBox box;
  for (const std::vector<GridPoint>& figure : figures) box.add(this->box(figure));
  if (box.empty()) return;
  reach_.add(box);
  begin(kind, {});
  for (const std::vector<GridPoint>& figure : figures) add_fan(figure, {});
  if (kind == FLATRAY_GL_SUM) add_box(FLATRAY_GL_FIND, box, {});
  add_box(FLATRAY_GL_COVER, box, paint);
}

void BatchList::lay(const BatchList& layer, float opacity) {
  const CellBox& box = layer.reach_;
  if (box.empty()) return;
  reach_.add(box);
  add_box(FLATRAY_GL_LAYER, box, {});
  const auto first = static_cast<std::uint32_t>(all_.vertices.size());
  for (FlatrayGlBatch batch : layer.all_.batches) {
    batch.first += first;
    all_.batches.push_back(batch);
  }
  all_.vertices.insert(all_.vertices.end(), layer.all_.vertices.begin(), layer.all_.vertices.end());
  add_box(FLATRAY_GL_LAY, box, {{opacity}});
}

}  // namespace flatray::gl
