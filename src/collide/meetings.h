#pragma once
#include <map>
#include <vector>

#include "anim/timeline.h"
#include "base/result.h"
#include "collide/carried_contact.h"

namespace flatray {

/// A while in which two entities meet.
struct Meeting {
  std::uint32_t a, b;  ///< entities, a < b
  MeetingPart part;    ///< times in seconds from frame 1; `start`: of the frame it was found in
  bool straight;       ///< both keep their velocity: exact
};

/// By first time, then by entity; `straight` is told of entities.
std::vector<Meeting> in_order(const std::map<IndexPair, std::vector<MeetingPart>>& parts,
                              const std::vector<bool>& straight);

/// Whether an entity keeps one velocity and its looks as long as the scene goes.
bool keeps_velocity(const Scene& scene, std::uint32_t entity);

/// Whether its shape, or the scale of a group it stands in, is a curve.
bool changes_size(const Scene& scene, std::uint32_t entity);

/// Why find_meetings() cannot be asked: an entity for each that changes its size, or passes too many
/// corners of a path in one frame; of boxes also one that turns and has curves other than circles and capsules.
std::optional<Diagnostics> refused_meetings(const Scene& scene, Outline outline = Outline::own);

/// Whether parts of an entity are left out of its meetings: open and other arcs, crossing outlines.
bool is_left_out(const Scene& scene, std::uint32_t entity);

/// Whether an entity never changes its place.
bool rests(const Scene& scene, std::uint32_t entity);

/// Pairs of entities whose boxes meet in one frame, and meetings in all, up to which they are found: more
/// than can be read, and a gigabyte or two of memory as a table.
struct MeetingLimits {
  std::uint64_t pairs = std::uint64_t{1} << 26;
  std::size_t meetings = std::size_t{1} << 20;
};
/// What is told of an entity where there are more; `what`: pairs or meetings.
Diagnostic too_many_meetings(const Scene& scene, std::uint32_t entity, std::string what);

/// All meetings of the entities of a scene between frame 1 and `last_frame`, by first time, then
/// by entity.
///
/// Needs   last_frame as the timeline has it, and that without responses; refused_meetings() has none.
/// Gives   no pair of which neither ever moves. Nothing goes through another unseen, however fast: all
///         times between frames count, and whatever carries an entity, groups in groups, keys and paths,
///         counts as it is at each of them. What a path turns is turned at once at its corners; looks
///         of states are held as in the frame. What parts and meets again while it turns meets twice.
/// Error   pairs that keep their velocities, in the world or in one group: exact verdicts, times the nearest
///         doubles. Others that go straight as seen from what carries both: so for the doubles at frames,
///         keys and corners. Else proven, as turning_contact(). Ellipses: proven, too. More pairs or
///         meetings than the limits above, at one that has to do with them: of pairs, before any is looked at.
/// Cost    a sweep over boxes, n log n and the pairs, for scenes where all keep their velocity once, else
///         once a frame; of what does not go straight some ten us a frame for each pair that comes
///         near. Memory for the entities and what is found.
Result<std::vector<Meeting>> find_meetings(const Timeline& timeline, unsigned last_frame,
                                           Outline outline = Outline::own, unsigned threads = 1,
                                           MeetingLimits limits = {});

}  // namespace flatray
