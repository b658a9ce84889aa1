// What <flatray/collide.h> gives is what contact() gives, bit for bit.
#include <gtest/gtest.h>

#include <limits>

#include "collide/contact.h"
#include "flatray/collide.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using Numbers = std::vector<double>;
using oracle::Draw;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void expect_fault(api::Status status, api::Fault fault, std::size_t entry = 0) {
  EXPECT_EQ(status.fault, fault) << api::words(status.fault);
  EXPECT_EQ(status.entry, entry);
}

struct Grown {
  std::vector<Vec2> ring;
  double radius;
};

// Boxes, slanted ones, segments and points of whole numbers, a third of them grown by a radius.
Grown any_shape(Draw& draw) {
  const double x = draw.below(30), y = draw.below(30), w = draw.below(4), h = draw.below(4),
               shear = draw.below(3);
  const Vec2 at(x, y);
  Grown body{{at}, draw.below(3) == 0 ? 0.5 * draw.below(4) : 0};
  if (draw.below(4) > 0)
    body.ring = {at, at + Vec2(w, 0), at + Vec2(w + shear, h), at + Vec2(shear, h)};
  return body;
}

bool same(const api::ContactFeature& a, const ContactFeature& b) {
  if (b.edge == kNoEdge) return a == api::ContactFeature{};
  return a.edge_of_a == b.edge_of_a && a.edge == b.edge && a.vertex == b.vertex;
}

bool same(const api::Contact& a, const HitInterval& b) {
  return a.first == b.t_enter && a.last == b.t_exit &&
         a.kind == static_cast<api::HitClass>(b.kind) &&
         a.start == static_cast<api::StartPlace>(b.start) &&
         a.first_overflows == b.enter_overflows && a.last_overflows == b.exit_overflows;
}

TEST(PublicCollide, ContactsAreThoseOfTheModule) {
  Draw draw(17, 45, 0);
  std::vector<Grown> bodies;
  api::Bodies set;
  for (int i = 0; i < 200; ++i) {
    const Grown body = any_shape(draw);
    bodies.push_back(body);
    Numbers x, y;
    for (const Vec2& p : body.ring) x.push_back(p.x()), y.push_back(p.y());
    if (body.ring.size() == 1)
      ASSERT_TRUE(set.add_discs(x, y, Numbers{body.radius}));
    else
      ASSERT_TRUE(set.add_polygon(x, y, body.radius));
  }
  std::vector<api::MovingPair> pairs;
  const auto speed = [&] { return static_cast<double>(draw.below(9)) - 4; };
  for (int i = 0; i < 20000; ++i)
    pairs.push_back({static_cast<std::uint32_t>(draw.below(200)),
                     static_cast<std::uint32_t>(draw.below(200)), speed(), speed(), speed(),
                     speed()});
  for (const api::Range within : {api::kRay, api::kSegment, api::kLine}) {
    std::vector<api::Contact> contacts(pairs.size());
    ASSERT_TRUE(set.contacts(pairs, within, contacts));
    int met = 0, round = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const api::MovingPair& pair = pairs[i];
      const Grown &a = bodies[pair.a], &b = bodies[pair.b];
      const MovingBody one{a.ring, {pair.velocity_ax, pair.velocity_ay}, a.radius},
          other{b.ring, {pair.velocity_bx, pair.velocity_by}, b.radius};
      const Range range{within.low, within.high};
      met += contacts[i].kind == api::HitClass::none ? 0 : 1;
      round += a.radius > 0 || b.radius > 0 ? 1 : 0;
      const Contact wanted = contact(one, other, range);
      ASSERT_TRUE(same(contacts[i], wanted.times)) << i;
      ASSERT_TRUE(same(contacts[i].at_first, wanted.first)) << i;
      ASSERT_TRUE(same(contacts[i].at_last, wanted.last)) << i;
    }
    EXPECT_GT(met, 500);
    EXPECT_GT(round, 1000);
  }
}

TEST(PublicCollide, MistakesAreToldAndChangeNothing) {
  using api::Fault;
  api::Bodies bodies;
  std::vector<api::Contact> one(1);
  expect_fault(bodies.contacts(std::vector<api::MovingPair>(1), api::kRay, one), Fault::no_such);
  const Numbers x = {0, 1, 1, 0}, y = {0, 0, 1, 1}, two = {0, 1};
  expect_fault(bodies.add_polygon(x, two), Fault::sizes);
  expect_fault(bodies.add_polygon(Numbers{}, Numbers{}), Fault::empty);
  expect_fault(bodies.add_polygon(two, Numbers{0, kNaN}), Fault::not_finite, 1);
  expect_fault(bodies.add_polygon(Numbers{0, 4, 1, 0}, Numbers{0, 0, 1, 4}), Fault::not_convex, 2);
  expect_fault(bodies.add_polygon(x, y, -1), Fault::radius);
  expect_fault(bodies.add_polygon(x, y, kNaN), Fault::not_finite);
  expect_fault(bodies.add_discs(two, two, Numbers{1, -1}), Fault::radius, 1);
  expect_fault(bodies.add_discs(two, two, Numbers{1}), Fault::sizes);
  EXPECT_EQ(bodies.size(), 0U);
  ASSERT_TRUE(bodies.add_polygon(x, y));
  ASSERT_TRUE(bodies.add_discs(Numbers{4}, Numbers{0.5}, Numbers{1}));

  const api::Contact kept{2, 3};
  std::vector<api::Contact> contacts(2, kept);
  std::vector<api::MovingPair> pairs = {{0, 1, 1, 0, 0, 0}, {0, 1, 1, 0, kInfinity, 0}};
  expect_fault(bodies.contacts(pairs, api::kRay, contacts), Fault::not_finite, 1);
  pairs[1] = {0, 2, 1, 0, 0, 0};
  expect_fault(bodies.contacts(pairs, api::kRay, contacts), Fault::no_such, 1);
  expect_fault(bodies.contacts(pairs, api::kRay, one), Fault::sizes);
  pairs[1].b = 0;
  expect_fault(bodies.contacts(pairs, {0, kNaN}, contacts), Fault::not_finite);
  EXPECT_EQ(contacts, std::vector<api::Contact>(2, kept));

  const api::Bodies taken = std::move(bodies);
  EXPECT_EQ(bodies.size(), 0U);  // NOLINT(bugprone-use-after-move)
  EXPECT_TRUE(bodies.contacts({}, api::kRay, {}));
  ASSERT_TRUE(taken.contacts(pairs, api::kRay, contacts));
  EXPECT_EQ(contacts[0].first, 2);  // the box ends at 1 + t, the disc begins at 3
}

}  // namespace
}  // namespace flatray
