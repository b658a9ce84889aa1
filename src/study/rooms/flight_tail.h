#pragma once
#include "study/rooms/room.h"
#include "study/statistics/blocks.h"

namespace flatray {

/// How the longest of many flights are spread: like a power where nothing bounds them, as between
/// periodic walls. What averages them then may have no variance, and no standard error.
class FlightTail {
 public:
  /// Puts the longest flights of orbits in that have `flights` each: of some together where those
  /// are few.
  void add(std::span<const double> longest, std::uint64_t flights);

  /// Of flights longer than t there are about t^-index: that of longest ones in groups (Gumbel
  /// 1958), 0 where there are too few groups to say.
  double index() const;

  void append_to(SumList& list) { list.insert(list.end(), {&groups_, &logs_, &squares_}); }

 private:
  double groups_ = 0, logs_ = 0, squares_ = 0;
};

/// Why means of the lengths of flights have no error in a room, "" where they have one: without
/// periodic walls no flight is longer than the room.
std::string no_error_of_flights(const Room& room, const FlightTail& tail);
/// Takes the error from such a mean where it has none, and remarks why.
void withhold_error_of_flights(Measure& mean, const Room& room, const FlightTail& tail);

}  // namespace flatray
