#pragma once
#include <span>
#include <vector>

#include "base/result.h"
#include "oracle/catalogue.h"
#include "trace/tracer.h"

namespace flatray {

/// How often each batch of a case is timed, one that takes long but once; the least counts.
inline constexpr int kTimesOfACase = 3;
/// Seconds that the clock of a thread tells well.
inline constexpr double kTold = 2e-5;

/// How a tracer does on one stiff case: every ray and orbit is asked twice, among so few that they
/// go one by one, and among so many, of copies where it takes them, that they go through the lanes.
struct CatalogueTally {
  std::uint64_t queries = 0;  ///< answers compared: of rays and orbits both ways, and of legs
  std::uint64_t wrong = 0;  ///< of wall, or of whether there is one; orbits that meet other walls,
                            ///< end otherwise, or have another number of bounces
  std::uint64_t leaks = 0;  ///< orbits that come out of where they are
  std::uint64_t apart = 0;  ///< answers among many that are not those among few, bit for bit
  std::vector<double>
      ulps{};  ///< by which t is off, of every answer whose wall is right, ascending

  std::uint64_t in_batches = 0;  ///< rays in the batches that were timed
  std::uint64_t one_by_one = 0;  ///< of those, that no lanes were certain of
  double seconds = 0;            ///< for them, of processor time: see kTimesOfACase
  std::uint64_t objects = 0;     ///< walls, each time they were made ready
  std::uint64_t bytes = 0;       ///< that took beside the walls themselves

  bool right() const { return wrong + leaks + apart == 0 && worst_ulps() <= 1; }
  double worst_ulps() const { return ulps.empty() ? 0 : ulps.back(); }
  /// The least that no more than one answer in a thousand exceeds.
  double most_ulps() const;
  void add(const CatalogueTally& other);
};

/// Needs   tracers that are not missing.
/// Gives   a tally for each; all but `seconds` the same every time.
/// Source  walls by oracle/nearest and oracle/long_orbit, t by the catalogue; of the legs of
///         orbits, each from one bounce to the next, t by oracle/nearest for the wall they meet.
/// Cost    mostly under 0.1 s a tracer, up to 0.7 s (A13).
std::vector<CatalogueTally> check_case(const oracle::StiffCase& stiff,
                                       std::span<const Tracer* const> tracers);

/// The same of contacts, which no tracer has a part in: each asked alone, and among many of its
/// kind so that it goes through the lanes. `wrong` is of class and start, `in_batches` and
/// `seconds` of contacts.
///
/// Source  class and t by the catalogue, class and start by oracle/contact.
/// Cost    under 0.1 s.
CatalogueTally check_contacts(const oracle::StiffCase& stiff);

/// The same of certified orbits, which no tracer has a part in: the walls of the first bounces,
/// ends, and none that escapes. `in_batches` and `seconds` are of bounces, each orbit timed
/// once; there is no t.
///
/// Error   that of can_certify().
/// Cost    up to half a second (C15).
Result<CatalogueTally> check_certified(const oracle::StiffCase& stiff);

}  // namespace flatray
