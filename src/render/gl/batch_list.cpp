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

void append(const Batches& more, Batches& to) {
  const auto first = static_cast<std::uint32_t>(to.vertices.size());
  for (FlatrayGlBatch batch : more.batches) {
    batch.first += first;
    to.batches.push_back(batch);
  }
  to.vertices.insert(to.vertices.end(), more.vertices.begin(), more.vertices.end());
}

}  // namespace

void CellBox::add(const CellBox& more) {
  x0 = std::min(x0, more.x0), y0 = std::min(y0, more.y0);
  x1 = std::max(x1, more.x1), y1 = std::max(y1, more.y1);
}

std::uint64_t BatchList::Occupied::columns(const CellBox& box) {
  const int first = box.x0 >> kCell, last = (box.x1 - 1) >> kCell;
  return (~std::uint64_t{0} >> (kCells - 1 - last)) & (~std::uint64_t{0} << first);
}

bool BatchList::Occupied::any(const CellBox& box) const {
  const std::uint64_t mask = columns(box);
  const auto first = rows_.begin() + (box.y0 >> kCell),
             end = rows_.begin() + ((box.y1 - 1) >> kCell) + 1;
  return std::any_of(first, end, [mask](std::uint64_t row) { return (row & mask) != 0; });
}

void BatchList::Occupied::add(const CellBox& box) {
  const std::uint64_t mask = columns(box);
  for (int row = box.y0 >> kCell; row <= (box.y1 - 1) >> kCell; ++row)
    rows_[static_cast<std::size_t>(row)] |= mask;
}

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

void BatchList::add_fan(std::span<const GridPoint> corners, const VertexPaint& paint,
                        std::vector<FlatrayGlVertex>& to) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    if (area(corners[0], corners[i], corners[i + 1]) == 0) continue;
    to.push_back(vertex(corners[0], paint));
    to.push_back(vertex(corners[i], paint));
    to.push_back(vertex(corners[i + 1], paint));
  }
}

void BatchList::add_box(const CellBox& box, const VertexPaint& paint,
                        std::vector<FlatrayGlVertex>& to) {
  const auto corner = [](int x, int y) { return on_grid({x, y}); };
  const std::array<GridPoint, 4> all = {corner(box.x0, box.y0), corner(box.x1, box.y0),
                                        corner(box.x1, box.y1), corner(box.x0, box.y1)};
  add_fan(all, paint, to);
}

// `others`: what of the group must not lie where the item does.
void BatchList::begin_item(const VertexPaint& paint, const Occupied& others, const CellBox& box) {
  if (others.any(box) || layered_.any(box) || paint.gradient != gradients_) flush();
  gradients_ = paint.gradient;
  any_.add(box);
  reach_.add(box);
}

void BatchList::paint(std::span<const GridPoint> corners, const VertexPaint& paint,
                      const CellBox& box) {
  if (box.empty()) return;
  begin_item(paint, marked_, box);
  add_fan(corners, paint, waiting_[FLATRAY_GL_PAINT]);
}

void BatchList::mark(FlatrayGlKind kind, std::span<const std::vector<GridPoint>> figures,
                     const VertexPaint& paint, const CellBox& box) {
  if (box.empty()) return;
  begin_item(paint, any_, box);
  marked_.add(box);
  for (const std::vector<GridPoint>& figure : figures)
    add_fan(figure, {}, waiting_[static_cast<std::size_t>(kind)]);
  if (kind == FLATRAY_GL_SUM) add_box(box, {}, waiting_[FLATRAY_GL_FIND]);
  add_box(box, paint, waiting_[FLATRAY_GL_COVER]);
}

void BatchList::lay(BatchList&& layer, float opacity) {
  const CellBox box = layer.reach_;
  if (box.empty()) return;
  if (layered_.any(box)) flush();
  layered_.add(box);
  reach_.add(box);
  add_box(box, {}, waiting_[FLATRAY_GL_LAYER]);
  add_box(box, {{opacity}}, waiting_[FLATRAY_GL_LAY]);
  append(std::move(layer).finish(), layers_);
}

void BatchList::push(int kind) {
  std::vector<FlatrayGlVertex>& vertices = waiting_[static_cast<std::size_t>(kind)];
  if (vertices.empty()) return;
  const auto count = static_cast<std::uint32_t>(vertices.size());
  append({std::exchange(vertices, {}), {{kind, gradients_ ? 1 : 0, 0, count}}, {}, {}}, all_);
}

void BatchList::flush() {
  for (int kind = FLATRAY_GL_PAINT; kind <= FLATRAY_GL_LAYER; ++kind) push(kind);
  append(std::exchange(layers_, {}), all_);
  push(FLATRAY_GL_LAY);
  for (Occupied* cells : {&marked_, &any_, &layered_}) cells->clear();
}

Batches BatchList::finish() && {
  flush();
  return std::move(all_);
}

}  // namespace flatray::gl
