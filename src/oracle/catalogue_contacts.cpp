#include "oracle/catalogue_parts.h"

namespace flatray::oracle {
namespace {

using Contacts = std::vector<StiffContact>;

constexpr HitClass kMiss = HitClass::miss, kTouch = HitClass::touch, kAlong = HitClass::along,
                   kThrough = HitClass::through;
constexpr double kFirst = 571.0 / 635, kLast = 699.0 / 635;  // of the paper's boxes

Ring moved(Ring ring, const Vec2& by) {
  for (Vec2& p : ring) p += by;
  return ring;
}

StiffContact paper_boxes(const Vec2& by = {0, 0}) {
  const Ring a = moved(box(250, 200, 314, 328), by), b = moved(box(885, 378, 949, 506), by);
  return {a, {635, 178}, b, {0, 0}, kThrough, kFirst, kLast};
}

// As a whole, and frame by frame from 24 to 10^9 frames a second: in that of the hit, and not before.
Contacts bullet() {
  const double h = 0x1p-10, first = (1 - h) / 3e8, last = (1 + 0x1p-40 + h) / 3e8;
  const StiffContact whole = {
      box(-h, -h, h, h), {3e8, 0}, box(1, -8, 1 + 0x1p-40, 8), {0, 0}, kThrough, first, last};
  Contacts all = {whole};
  for (const double fps : {24.0, 1000.0, 1e9})
    for (int frame = 0; frame < 8; ++frame) {
      StiffContact one = whole;
      one.within = {frame / fps, (frame + 1) / fps};
      one.first = std::max(first, one.within.low);
      one.last = std::min(last, one.within.high);
      if (one.first > one.last) one.kind = kMiss;
      all.push_back(one);
    }
  return all;
}

Contacts corners() {
  return {{kSquare, {1, 1}, box(2, 2, 3, 3), {0, 0}, kThrough, 1, 3},
          {kSquare, {1, 1}, box(2, 0, 3, 1), {0, 0}, kTouch, 1, 1}};
}

Contacts slides() {
  return {{kSquare, {1, 0}, box(2, 1, 3, 2), {0, 0}, kAlong, 1, 3},
          {kSquare, {1, 0}, box(2, 1 - 0x1p-53, 3, 2), {0, 0}, kThrough, 1, 3},
          {kSquare, {1, 0}, box(2, 1 + 0x1p-52, 3, 2), {0, 0}, kMiss}};
}

Contacts still() {
  const Vec2 v(0.1, -7e200);
  const auto for_ever = [&](const Ring& other, HitClass kind) {
    return StiffContact{kSquare, v, other, v, kind, -kInfinity, kInfinity, kLine};
  };
  return {for_ever(box(2, 0, 3, 1), kMiss), for_ever(box(1, 0, 3, 1), kTouch),
          for_ever(box(0.5, 0, 3, 1), kThrough)};
}

// It leaves where its near side reaches the far one of the box around it.
Contacts containment() {
  const Ring around = box(-1, -1, 2, 2);
  return {{kSquare, {0, 0}, around, {0, 0}, kThrough, 0, kInfinity},
          {kSquare, {1, 2}, around, {0, 0}, kThrough, 0, 1},
          {kSquare, {-3e8, 1}, around, {0, 0}, kThrough, 0, 2 / 3e8}};
}

// Each as given, exchanged, and all of it carried along.
Contacts both_ways(const Contacts& given) {
  const Vec2 common(8, -16);
  Contacts all;
  for (const StiffContact& one : given) {
    StiffContact other = one, carried = one;
    std::swap(other.a, other.b);
    std::swap(other.velocity_a, other.velocity_b);
    carried.velocity_a += common;
    carried.velocity_b += common;
    all.insert(all.end(), {one, other, carried});
  }
  return all;
}

Contacts degenerate() {
  const Ring point = {{0.5, -1}}, segment = {{0, 0}, {1, 0}}, level = {{3, 0}, {4, 0}};
  return {{point, {0, 1}, segment, {0, 0}, kTouch, 1, 1},
          {segment, {1, 0}, level, {0, 0}, kAlong, 2, 4},
          {point, {0, 1}, point, {0, 1}, kTouch, 0, kInfinity},
          {point, {0, 1}, point, {0, 2}, kTouch, 0, 0},
          {{{0, 0}}, {1, 1}, {{3, 3}}, {0, 0}, kTouch, 3, 3},
          {{{0, 0}}, {1, 1}, {{3, 4}}, {0, 0}, kMiss},
          {segment, {0, 1}, {{0.5, 1}, {0.5, 3}}, {0, 0}, kThrough, 1, 3}};
}

}  // namespace

std::vector<StiffCase> stiff_contacts() {
  return {
      of("D1", "paper boxes", "collide.StiffCases.D1ThePapersBoxesMeetToTheLastBit",
         {paper_boxes()}),
      of("D2", "bullet", "collide.StiffCases.D2ABulletMeetsAThinWallAtEveryFrameRate", bullet()),
      of("D3", "corner to corner", "collide.StiffCases.D3CornerToCorner", corners()),
      of("D4", "slide", "collide.StiffCases.D4SlidingIsAlongAndOneUlpDecides", slides()),
      of("D5", "still", "collide.StiffCases.D5WithoutRelativeMotionTheStartDecidesForAllTime",
         still()),
      of("D6", "containment", "collide.StiffCases.D6ContainmentIsOverlapFromTheStart",
         containment()),
      of("D7", "far", "collide.StiffCases.D7FarAwayIsTheSame", {paper_boxes({0x1p50, -0x1p49})}),
      of("D8", "symmetric", "collide.StiffCases.D8ExchangedOrCarriedAlongTheTimesAreTheSame",
         both_ways(Contacts{paper_boxes()} + corners() + slides())),
      of("D9", "degenerate", "collide.StiffCases.D9SegmentsAndPointsMeetAsClosedSets",
         degenerate()),
  };
}

}  // namespace flatray::oracle
