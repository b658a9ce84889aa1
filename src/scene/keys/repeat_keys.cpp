#include "geom/turn.h"
#include "scene/keys/keys.h"
#include "scene/repeat.h"

namespace flatray {
namespace {

// More of them is refused for what they add up to.
constexpr std::int64_t kMostCopies = std::int64_t{1} << 40;

void read_counts(Builder& builder, const Field& field, Grid& grid) {
  if (!builder.in.is_pair(field, "two whole numbers")) return;
  const auto columns = builder.in.integer(field.item(0), 1, kMostCopies);
  const auto rows = builder.in.integer(field.item(1), 1, kMostCopies);
  if (!columns || !rows) return;
  grid.columns = static_cast<std::uint64_t>(*columns);
  grid.rows = static_cast<std::uint64_t>(*rows);
}

template <class T>
constexpr Key<T> kCountKey = {{"count", "whole number", kRequired},
                              &set_integer<&T::count, 1, kMostCopies>};

constexpr Key<Grid> kGridKeys[] = {
    {{"count", "[nx, ny]", kRequired}, &read_counts},
    {{"step", "[dx, dy]", kRequired}, &set<&Grid::step>},
};
constexpr Key<Ring> kRingKeys[] = {
    kCountKey<Ring>,
    {{"radius", "number", kRequired}, &set<&Ring::radius>},
    {{"start", "degrees", "0"}, &set<&Ring::start>},
    {{"step", "degrees", "360 / count"}, &set<&Ring::step>},
    {{"turn", "true or false", "false"}, &set<&Ring::turn>},
};
constexpr Key<Scatter> kScatterKeys[] = {
    kCountKey<Scatter>,
    {{"in", "[[x0, y0], [x1, y1]]", kRequired}, &set<&Scatter::in>},
};

template <class T, const auto& keys>
void read_kind(Builder& builder, const Field& field, std::optional<Repeat>& chosen) {
  T repeat;
  read_keys(builder, field.value, field.name, keys, repeat);
  chosen = repeat;
}

constexpr Key<std::optional<Repeat>> kRepeatKeys[] = {
    {{"grid", "{ count = [nx, ny], step = [dx, dy] }", "none"}, &read_kind<Grid, kGridKeys>},
    {{"ring", "{ count = n, radius = r }", "none"}, &read_kind<Ring, kRingKeys>},
    {{"scatter", "{ count = n, in = [[x0, y0], [x1, y1]] }", "none"},
     &read_kind<Scatter, kScatterKeys>},
};

Copy place(const Grid& grid, std::uint64_t number, const Draws&) {
  const auto column = static_cast<double>(number % grid.columns);
  const auto row = static_cast<double>(number / grid.columns);
  return {{column * grid.step.x(), row * grid.step.y()}, 0};
}

Copy place(const Ring& ring, std::uint64_t number, const Draws&) {
  const double k = static_cast<double>(number), count = static_cast<double>(ring.count);
  const double angle = radians(ring.start + (ring.step ? k * *ring.step : k * 360 / count));
  const Turn out = turn(angle);
  return {{ring.radius * out.cos, ring.radius * out.sin}, ring.turn ? angle : 0};
}

Copy place(const Scatter& scatter, std::uint64_t, const Draws& draws) {
  const auto [u, v] = draws.place();
  const Vec2 size = scatter.in.size();
  return {scatter.in.low + Vec2(u * size.x(), v * size.y()), 0};
}

// The largest coordinate of a copy's place.
double farthest(const Grid& grid) {
  const Vec2 most(static_cast<double>(grid.columns - 1), static_cast<double>(grid.rows - 1));
  return most.cwiseProduct(grid.step).cwiseAbs().maxCoeff();
}
double farthest(const Ring& ring) { return std::fabs(ring.radius); }
double farthest(const Scatter&) { return 0; }  // of points that were looked at

}  // namespace

std::optional<Repeat> read_repeat(Builder& builder, const Field& field) {
  std::optional<Repeat> repeat;
  if (!read_keys(builder, field.value, "repeat", kRepeatKeys, repeat)) return std::nullopt;
  if (repeat && std::visit([](const auto& kind) { return farthest(kind); }, *repeat) > kFarthest)
    return builder.in.refuse(field, "has copies beyond 1e300",
                             "write numbers that keep them between -1e300 and 1e300");
  if (field.value.members.size() == 1) return repeat;
  return builder.in.refuse(field, fmt::format("has {} kinds, not one", field.value.members.size()),
                           "write one of grid, ring, scatter; a group repeats what repeats");
}

std::uint64_t copy_count(const Repeat& repeat) {
  if (const auto* grid = std::get_if<Grid>(&repeat))
    return saturating_product(grid->columns, grid->rows);
  if (const auto* ring = std::get_if<Ring>(&repeat)) return ring->count;
  return std::get<Scatter>(repeat).count;
}

Copy copy_of(const Repeat& repeat, std::uint64_t number, const Draws& draws) {
  return std::visit([&](const auto& kind) { return place(kind, number, draws); }, repeat);
}

std::vector<TableInfo> repeat_tables() {
  return {{"repeat", key_infos<std::optional<Repeat>>(kRepeatKeys)},
          {"repeat.grid", key_infos<Grid>(kGridKeys)},
          {"repeat.ring", key_infos<Ring>(kRingKeys)},
          {"repeat.scatter", key_infos<Scatter>(kScatterKeys)}};
}

}  // namespace flatray
