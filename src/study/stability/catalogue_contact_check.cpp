#include "base/processor_time.h"
#include "collide/contact_batch.h"
#include "oracle/contact.h"
#include "study/accuracy/timed.h"
#include "study/stability/catalogue_check.h"
#include "study/stability/ulps.h"

namespace flatray {
namespace {

constexpr std::size_t kTogether = 64;  // contacts of one call

void compare(const oracle::StiffContact& asked, const HitInterval& met, CatalogueTally& tally) {
  ++tally.queries;
  const oracle::ContactTruth truth =
      oracle::contact_truth({asked.a, asked.velocity_a}, {asked.b, asked.velocity_b}, asked.within);
  if (met.kind != asked.kind || met.kind != truth.kind || met.start != truth.start) {
    ++tally.wrong;
  } else if (met) {
    tally.ulps.push_back(ulps_between(met.t_enter, asked.first));
    tally.ulps.push_back(ulps_between(met.t_exit, asked.last));
  }
}

}  // namespace

CatalogueTally check_contacts(const oracle::StiffCase& stiff) {
  CatalogueTally tally;
  for (const oracle::StiffContact& asked : stiff.contacts) {
    const Contact alone =
        contact({asked.a, asked.velocity_a}, {asked.b, asked.velocity_b}, asked.within);
    BodySet shapes;
    const std::uint32_t a = shapes.add(asked.a), b = shapes.add(asked.b);
    const std::vector<MovingPair> pairs(kTogether, {a, b, asked.velocity_a, asked.velocity_b});
    std::vector<Contact> among(kTogether);
    tally.seconds +=
        seconds_of([&] { contacts(shapes, pairs, asked.within, among); }, &thread_seconds, kTold);
    tally.in_batches += kTogether;
    compare(asked, alone.times, tally);
    for (const Contact& one : among) {
      compare(asked, one.times, tally);
      if (one != alone) ++tally.apart;
    }
  }
  std::ranges::sort(tally.ulps);
  return tally;
}

}  // namespace flatray
