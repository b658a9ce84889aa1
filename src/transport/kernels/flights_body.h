// Flights of fast orbits, written once over `Real` and `Mask`. Each tier's file includes this with
// FLATRAY_TIER and FLATRAY_LANES set. Meaning of what is taken and given: flights.h.
#include "transport/kernels/flights.h"

namespace flatray::flights::FLATRAY_TIER {
namespace {

#include "trace/kernels/vector.h"

constexpr double kInfinite = __builtin_inf();
constexpr double kGrazing = 0x1p-32;  // square of the cosine of the incidence
constexpr double kTangent = 0x1p-30;  // of a squared radius

struct Pair {
  Real x, y;
};
Real dot(const Pair& a, const Pair& b) { return a.x * b.x + a.y * b.y; }
Real cross(const Pair& a, const Pair& b) { return a.x * b.y - a.y * b.x; }
Pair along(const Pair& from, Real t, const Pair& d) { return {from.x + t * d.x, from.y + t * d.y}; }
Pair times(Real factor, const Pair& v) { return {factor * v.x, factor * v.y}; }
Pair pair_at(const double* of) { return {all(of[0]), all(of[1])}; }

// A group of rays on its way to its walls.
struct Group {
  Pair o, d;
  Real departed, near;
  Real best = all(kInfinite), second = all(kInfinite);  // the two first walls
  Real open = all(kInfinite);                           // the first that is not decided
  Real wall = all(0);

  void offer(Real t, Mask is_met, Mask is_open, int slot) {
    const Real met = choose(both(is_met, less(all(0) - near, t)), t, all(kInfinite));
    wall = choose(less(met, best), all(slot), wall);
    second = smaller(second, larger(met, best));
    best = smaller(met, best);
    open = smaller(open, choose(is_open, met, all(kInfinite)));
  }
};

// In a closed room nothing is left once a line is crossed that has all of the room on one side: whether
// the wall itself is met need not be asked, as another is met before where it is not. Near ends two
// walls are.
void meet_hull(Group& g, const double* wall, int slot) {
  const Pair n = pair_at(wall + kNormalX);
  const Real speed = dot(n, g.d);
  const Real t = (all(wall[kOffset]) - dot(n, g.o)) / speed;
  const Real met = choose(less(all(0), speed), t, all(kInfinite));
  g.wall = choose(less(met, g.best), all(slot), g.wall);
  g.second = smaller(g.second, larger(met, g.best));
  g.best = smaller(met, g.best);
}

void meet_segment(Group& g, const double* wall, int slot) {
  const Pair n = pair_at(wall + kNormalX), u = pair_at(wall + kAlongX);
  const Real t = (all(wall[kOffset]) - dot(n, g.o)) / dot(n, g.d);
  const Real beside = size((dot(u, g.o) - all(wall[kMiddle])) + t * dot(u, g.d));
  const Mask is_on = less(beside, all(wall[kHalf]) + g.near);
  const Mask at_end = less(all(wall[kHalf]) - g.near, beside);
  g.offer(t, but_not(is_on, equal(g.departed, all(slot))), at_end, slot);
}

// A curve in a root, at a point as seen from its centre.
void meet_root(Group& g, const double* wall, Real t, const Pair& w, int slot) {
  const Mask never = less(t, t);
  if (wall[kExtent] == kWhole) return g.offer(t, equal(t, t), never, slot);
  const Real from = dot(pair_at(wall + kFromX), w), to = dot(pair_at(wall + kToX), w);
  const Real least = all(0) - g.near;
  const Mask past_from = less(least, from), before_to = less(least, to);
  const Mask is_on =
      wall[kExtent] == kBoth ? both(past_from, before_to) : either(past_from, before_to);
  g.offer(t, is_on, either(less(size(from), g.near), less(size(to), g.near)), slot);
}

// By a t^2 + 2 b t + c = 0 of discriminant q, `scale` the largest that q can be: the root stood on is
// t = 0, so the other is known without c.
void meet_curve(Group& g, const double* wall, const Pair& w, Real a, Real b, Real q, Real scale,
                int slot) {
  const Mask outside = equal(g.departed, all(slot)), inside = equal(g.departed, all(slot + 0.5));
  const Mask stood_on = either(outside, inside);
  const Real s = root(q), never = all(kInfinite), middle = all(0) - b;
  const Real first = choose(stood_on, never, (middle - s) / a);
  const Real second = choose(outside, never, choose(inside, middle + middle, middle + s) / a);
  meet_root(g, wall, first, along(w, first, g.d), slot);
  meet_root(g, wall, second, along(w, second, g.d), slot);
  const Mask is_tangent = but_not(less(size(q), all(kTangent) * scale), stood_on);
  const Mask is_ahead = less(all(0) - g.near * a, middle);
  g.open = smaller(g.open, choose(both(is_tangent, is_ahead), middle / a, never));
}

void meet_circle(Group& g, const double* wall, int slot) {
  const Pair c = pair_at(wall + kCentreX), w{g.o.x - c.x, g.o.y - c.y};
  const Real k = cross(w, g.d), square_radius = all(wall[kSquare]);
  meet_curve(g, wall, w, all(1), dot(w, g.d), square_radius - k * k, square_radius, slot);
}

Pair form_of(const double* wall, const Pair& w) {
  return {dot(pair_at(wall + kFormXx), w), dot(pair_at(wall + kFormYx), w)};
}

void meet_ellipse(Group& g, const double* wall, int slot) {
  const Pair c = pair_at(wall + kCentreX), w{g.o.x - c.x, g.o.y - c.y};
  const Pair form = form_of(wall, w), form_d = form_of(wall, g.d);
  const Real a = dot(form_d, form_d), k = cross(form, form_d);
  meet_curve(g, wall, w, a, dot(form, form_d), a - k * k, a, slot);
}

// Where flights end: on the wall, by the direction that it is left in.
struct Arrival {
  Pair point, out, normal;
  Real departed, turned;  // -1 where the normal is away from the ray
  Real incidence;         // square of its cosine
  Real event;
};

Real sign_against(Real along_normal) { return choose(less(all(0), along_normal), all(-1), all(1)); }

Arrival reach_segment(const Group& g, const Pair& p, const double* const* from) {
  const Ends line = fetch_ends(from, kNormalX), next = fetch_ends(from, kShiftX);
  const Pair n{line.ax, line.ay};
  const Real off = line.bx - dot(n, p), speed = dot(n, g.d);
  const Pair on = along(p, off, n), out = along(g.d, all(0) - line.by * speed, n);
  return {{on.x + next.ax, on.y + next.ay},
          out,
          n,
          next.bx,
          sign_against(speed),
          speed * speed,
          next.by};
}

Arrival reach_curve(const Group& g, const Pair& p, const double* const* from) {
  const Ends centre = fetch_ends(from, kCentreX), form = fetch_ends(from, kFormXx);
  const Ends next = fetch_ends(from, kShiftX);
  Pair w{p.x - centre.ax, p.y - centre.ay};
  Pair f{form.ax * w.x + form.ay * w.y, form.bx * w.x + form.by * w.y};
  const Real onto = all(1.5) - all(0.5) * dot(f, f);  // one step of Newton's to |f| = 1
  w = times(onto, w);
  f = times(onto, f);
  const Pair n{form.ax * f.x + form.bx * f.y, form.ay * f.x + form.by * f.y};
  const Real nn = dot(n, n), speed = dot(n, g.d);
  const Pair out = along(g.d, all(0) - (speed + speed) / nn, n);
  const Real inside = choose(less(all(0), speed), all(0.5), all(0));
  return {{centre.ax + w.x, centre.ay + w.y},
          out,
          times(all(1) / root(nn), n),
          next.bx + inside,
          sign_against(speed),
          speed * speed / nn,
          next.by};
}

Pair choose_pair(Mask m, const Pair& yes, const Pair& no) {
  return {choose(m, yes.x, no.x), choose(m, yes.y, no.y)};
}

Arrival choose_arrival(Mask m, const Arrival& yes, const Arrival& no) {
  return {choose_pair(m, yes.point, no.point),   choose_pair(m, yes.out, no.out),
          choose_pair(m, yes.normal, no.normal), choose(m, yes.departed, no.departed),
          choose(m, yes.turned, no.turned),      choose(m, yes.incidence, no.incidence),
          choose(m, yes.event, no.event)};
}

Arrival reach(const Group& g, const Walls& walls, const double* const* from) {
  const Pair p = along(g.o, g.best, g.d);
  if (walls.circles + walls.ellipses == 0) return reach_segment(g, p, from);
  const Arrival on_curve = reach_curve(g, p, from);
  if (walls.segments == 0) return on_curve;
  return choose_arrival(less(g.wall, all(walls.segments)), reach_segment(g, p, from), on_curve);
}

void put(const Group& g, const Walls& walls, const Flights& flights, int i) {
  double slots[FLATRAY_LANES];
  const double* from[FLATRAY_LANES];
  store(slots, g.wall);
  for (int lane = 0; lane < FLATRAY_LANES; ++lane)
    from[lane] = walls.records + kRecord * static_cast<int>(slots[lane]);
  const Arrival at = reach(g, walls, from);
  const Real sized = all(1.5) - all(0.5) * dot(at.out, at.out);
  store(flights.to.x + i, at.point.x);
  store(flights.to.y + i, at.point.y);
  store(flights.to.dx + i, sized * at.out.x);
  store(flights.to.dy + i, sized * at.out.y);
  store(flights.to.departed + i, at.departed);
  store(flights.t + i, g.best);
  store(flights.wall + i, g.wall);
  store(flights.nx + i, at.turned * at.normal.x);
  store(flights.ny + i, at.turned * at.normal.y);
  const Mask is_met = less(g.best, all(kInfinite));
  const Mask grazes = both(is_met, less(at.incidence, all(kGrazing)));
  const Mask touches = either(less(g.best, g.near), less(g.second, g.best + g.near));
  const Mask unsure = either(either(grazes, touches), less(g.open, g.best + g.near));
  store(flights.event + i, choose(unsure, all(kUnsure), choose(is_met, at.event, all(kNothing))));
}

// Whole, so that a group stays in registers from wall to wall.
[[gnu::flatten]] void fly(const Walls& walls, const Flights& flights) {
  const Rays& from = flights.from;
  for (int i = 0; i < flights.count; i += FLATRAY_LANES) {
    Group g{{load(from.x + i), load(from.y + i)},
            {load(from.dx + i), load(from.dy + i)},
            load(from.departed + i),
            all(walls.near)};
    int slot = 0;
    const double* wall = walls.records;
    for (; slot < walls.hull; ++slot, wall += kRecord) meet_hull(g, wall, slot);
    for (; slot < walls.segments; ++slot, wall += kRecord) meet_segment(g, wall, slot);
    for (; slot < walls.segments + walls.circles; ++slot, wall += kRecord)
      meet_circle(g, wall, slot);
    for (; slot < walls.segments + walls.circles + walls.ellipses; ++slot, wall += kRecord)
      meet_ellipse(g, wall, slot);
    put(g, walls, flights, i);
  }
}

}  // namespace

const Fly kFly = &fly;

}  // namespace flatray::flights::FLATRAY_TIER
