#include "app/query/query.h"
#include "collide/turning_contact.h"

namespace flatray::contact_query {
namespace {

// A ring as seen from the point it turns about.
std::vector<Vec2> from_about(const Question::Moving& body) {
  std::vector<Vec2> ring;
  for (const Vec2& p : body.polygon) ring.push_back(p - body.about);
  return ring;
}

JsonValue interval(const Range& range) { return Values{range.low, range.high}; }

Fields turning_answer(const Question::Moving& a, const Question::Moving& b) {
  const std::vector<Vec2> ring_a = from_about(a), ring_b = from_about(b);
  const TurningBody one = {ring_a, a.radius, even_motion(a.about, a.velocity, 0, a.spin)};
  const TurningBody other = {ring_b, b.radius, even_motion(b.about, b.velocity, 0, b.spin)};
  constexpr double kLength = 1, kWidth = 0x1p-40;
  const TurningContact first = turning_contact(one, other, kLength, kWidth);
  const bool meets = first.verdict == TurningContact::Verdict::meets;
  Fields fields = {
      {"class", meets                                             ? "through"
                : first.verdict == TurningContact::Verdict::apart ? "miss"
                                                                  : "undecided"},
      {"t_first", JsonValue()},
      {"t_last", JsonValue()},
      {"start", first.start == StartPlace::boundary ? "undecided" : contact_name(first.start)}};
  if (first.verdict != TurningContact::Verdict::apart) fields[1].second = interval(first.first);
  if (!meets) return fields;
  const TurningContact last = turning_contact(one, other, kLength, kWidth, true);
  if (last.verdict == TurningContact::Verdict::meets) fields[2].second = interval(last.first);
  return fields;
}

Fields answer(Question& question) {
  const Question::Moving a = question.moving("a"), b = question.moving("b");
  const Range within = question.domain("always", "future", "unit");
  const bool turning = a.spin != 0 || b.spin != 0;
  if (turning && within.high != 1)
    question.mistake("domain", "where something turns it must be \"unit\"");
  if (!question.sound()) return {};
  if (turning) return turning_answer(a, b);
  const HitInterval times =
      flatray::contact({a.polygon, a.velocity, a.radius}, {b.polygon, b.velocity, b.radius}, within)
          .times;
  Fields fields = {{"class", name(times.kind)},
                   {"t_first", interval_end(times, times.t_enter)},
                   {"t_last", interval_end(times, times.t_exit)},
                   {"start", contact_name(times.start)}};
  if (times.enter_overflows || times.exit_overflows) fields.emplace_back("overflow", true);
  return fields;
}

}  // namespace

extern const Query entry = {
    "contact", "when two moving convex polygons or discs meet, from the first instant to the last",
    &answer};

}  // namespace flatray::contact_query
