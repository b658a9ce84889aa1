#include "app/query/query.h"
#include "collide/round_contact.h"

namespace flatray::queries {
namespace {

Fields answer(Question& question) {
  const Question::Moving a = question.moving("a"), b = question.moving("b");
  const Range within = question.domain("always", "future", "unit");
  if (!question.sound()) return {};
  const HitInterval times = round_contact({{a.polygon, a.velocity}, a.radius},
                                          {{b.polygon, b.velocity}, b.radius}, within)
                                .times;
  Fields fields = {{"class", name(times.kind)},
                   {"t_first", interval_end(times, times.t_enter)},
                   {"t_last", interval_end(times, times.t_exit)},
                   {"start", contact_name(times.start)}};
  if (times.enter_overflows || times.exit_overflows) fields.emplace_back("overflow", true);
  return fields;
}

}  // namespace

extern const Query contact = {
    "contact", "when two moving convex polygons or discs meet, from the first instant to the last",
    &answer};

}  // namespace flatray::queries
