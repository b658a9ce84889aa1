#pragma once
#include <functional>
#include <optional>

#include "study/rooms/room.h"

namespace flatray {

/// A sink that tells `see` of each bounce, with the number of its orbit, and of nothing else.
template <class See>
class BounceSink : public OrbitSink {
 public:
  explicit BounceSink(See see) : see_(std::move(see)) {}
  void bounce(std::size_t number, const Bounce& bounce) override { see_(number, bounce); }

 private:
  See see_;
};

/// Follows orbits in the precision of the context: fast or exact as the room's own tracers do, or
/// certified, every one as far as it is proven. In a magnetic field all are exact.
///
/// Needs   starts in the room; can_certify() and no field where the precision is certified.
void follow_starts(const ExperimentContext& context, const Room& room,
                   std::span<const OrbitStart> starts, std::uint64_t bounces, OrbitSink& sink);

/// The same of the orbits [begin, end) of starts drawn as the context has it.
void follow_drawn(const ExperimentContext& context, const Room& room, std::uint64_t begin,
                  std::uint64_t end, std::uint64_t bounces, OrbitSink& sink);

/// Some of many starts, evenly over them, for an audit: of those that `start` has. None where the
/// context's precision is not fast.
std::vector<OrbitStart> audited_starts(
    const ExperimentContext& context, std::uint64_t orbits,
    const std::function<std::optional<OrbitStart>(std::uint64_t)>& start);

/// What fast orbits are worth: some starts followed fast, in exact decisions, and certified, as far
/// as the latter two can tell. Nothing where the context's precision is not fast.
///
/// Gives   bounces until fast and exact orbits are 1 % of the room off, or on another wall, which
///         is when rounding has grown to the size of the room; how many did so before (must be 0);
///         by how much first flights differ, in 2^-53 of the room. Why the room is followed
///         exactly, where it is.
std::vector<Measure> audit(const ExperimentContext& context, const Room& room,
                           std::span<const OrbitStart> starts, std::uint64_t bounces);
/// The same of a plan's orbits, drawn as the context has it.
std::vector<Measure> audit(const ExperimentContext& context, const Room& room,
                           const OrbitPlan& plan);
/// The same of any fast orbits, beside exact and certified ones of the room.
std::vector<Measure> audit_of(const FastOrbits& orbits, const ExperimentContext& context,
                              const Room& room, std::span<const OrbitStart> starts,
                              std::uint64_t bounces);

}  // namespace flatray
