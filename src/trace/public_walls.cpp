#include <utility>

#include "geom/predicates.h"
#include "trace/plain_arrays.h"
#include "trace/walls_data.h"

namespace flatray::api {
namespace {

Status check_radii(Column radius) {
  for (std::size_t i = 0; i < radius.size(); ++i)
    if (radius[i] < 0) return {Fault::radius, i};
  return {};
}

// Puts `make(i)` for every entry at the end of the walls, where there are numbers for all.
template <class Make>
Status add_all(Surfaces& walls, std::size_t count, const Make& make) {
  if (count > kNoWall - walls.size()) return {Fault::full, 0};
  for (std::size_t i = 0; i < count; ++i) walls.add(make(i));
  return {};
}

}  // namespace

Walls::Walls() = default;
Walls::Walls(const Walls& other) : data_(new Data(other.data())) {}
Walls::Walls(Walls&& other) noexcept = default;
Walls& Walls::operator=(Walls other) noexcept {
  data_ = std::move(other.data_);
  return *this;
}
Walls::~Walls() = default;

Walls::Data& Walls::data() {
  if (!data_) data_ = Owned<Data>(new Data);
  return *data_;
}

const Walls::Data& Walls::data() const {
  static const Data kNone;
  return data_ ? *data_ : kNone;
}

std::size_t Walls::size() const { return data().surfaces.size(); }

Status Walls::add_segments(Column ax, Column ay, Column bx, Column by) {
  if (const Status fault = check_columns({ax, ay, bx, by}); !fault) return fault;
  return add_all(data().surfaces, ax.size(), [&](std::size_t i) {
    return Segment{{ax[i], ay[i]}, {bx[i], by[i]}};
  });
}

Status Walls::add_ring(Column x, Column y) {
  if (const Status fault = check_columns({x, y}); !fault) return fault;
  if (x.empty()) return {Fault::empty, 0};
  return add_all(data().surfaces, x.size(), [&](std::size_t i) {
    const std::size_t next = i + 1 == x.size() ? 0 : i + 1;
    return Segment{{x[i], y[i]}, {x[next], y[next]}};
  });
}

Status Walls::add_circles(Column x, Column y, Column radius) {
  if (const Status fault = check_columns({x, y, radius}); !fault) return fault;
  if (const Status fault = check_radii(radius); !fault) return fault;
  return add_all(data().surfaces, x.size(), [&](std::size_t i) {
    return Circle{{x[i], y[i]}, radius[i]};
  });
}

Status Walls::add_ellipses(Column x, Column y, Column ux, Column uy, Column vx, Column vy) {
  if (const Status fault = check_columns({x, y, ux, uy, vx, vy}); !fault) return fault;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (cross_sign({ux[i], uy[i]}, {vx[i], vy[i]}) == Sign::zero) return {Fault::degenerate, i};
  return add_all(data().surfaces, x.size(), [&](std::size_t i) {
    const Ellipse curve({x[i], y[i]}, {ux[i], uy[i]}, {vx[i], vy[i]});
    return Arc{curve, Arc::Extent::whole, {0, 0}, {0, 0}};
  });
}

Status Walls::add_arcs(Column x, Column y, Column radius, Column from_x, Column from_y, Column to_x,
                       Column to_y) {
  if (const Status fault = check_columns({x, y, radius, from_x, from_y, to_x, to_y}); !fault)
    return fault;
  if (const Status fault = check_radii(radius); !fault) return fault;
  const auto arc = [&](std::size_t i) {
    return Arc{Circle{{x[i], y[i]}, radius[i]},
               Arc::Extent::between,
               {from_x[i], from_y[i]},
               {to_x[i], to_y[i]}};
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Arc one = arc(i);
    const Vec2& centre = one.curve.centre;
    if (radius[i] == 0 || lie_in_one_direction(centre, one.from, one.to))
      return {Fault::degenerate, i};
  }
  return add_all(data().surfaces, x.size(), arc);
}

Status Walls::add_beziers(int degree, Column x, Column y) {
  if (const Status fault = check_columns({x, y}); !fault) return fault;
  if (degree != 2 && degree != 3) return {Fault::sizes, 0};
  const auto each = static_cast<std::size_t>(degree) + 1;
  if (x.size() % each != 0) return {Fault::sizes, 0};
  const std::vector<Vec2> points = points_of(x, y);
  const auto curve = [&](std::size_t i) {
    return Bezier(std::span(points).subspan(each * i, each));
  };
  const std::size_t count = x.size() / each;
  for (std::size_t i = 0; i < count; ++i)
    if (is_on_one_line(curve(i))) return {Fault::degenerate, i};
  return add_all(data().surfaces, count, curve);
}

Status Walls::add_conics(Column x, Column y, Column weight) {
  if (const Status fault = check_columns({x, y}); !fault) return fault;
  if (const Status fault = check_columns({weight}); !fault) return fault;
  if (x.size() != 3 * weight.size()) return {Fault::sizes, 0};
  const std::vector<Vec2> p = points_of(x, y);
  const auto curve = [&](std::size_t i) {
    return Bezier(p[3 * i], p[3 * i + 1], p[3 * i + 2], weight[i]);
  };
  for (std::size_t i = 0; i < weight.size(); ++i)
    if (!Bezier::is_in_range(weight[i]) || is_on_one_line(curve(i))) return {Fault::degenerate, i};
  return add_all(data().surfaces, weight.size(), curve);
}

}  // namespace flatray::api
