#pragma once
#include <vector>

#include "anim/timeline.h"
#include "base/result.h"
#include "collide/outline_contact.h"

namespace flatray {

/// A while in which two entities meet.
struct Meeting {
  std::uint32_t a, b;  ///< entities, a < b
  MeetingPart part;    ///< times in seconds from frame 1; `start`: of the frame it was found in
  bool straight;  ///< both keep their velocity: exact. Else motion is straight from frame to frame
};

/// What stands for an entity: its own outline, or the box around it in each frame.
enum class Outline : std::uint8_t { own, box };

/// Whether an entity keeps one velocity and its looks as long as the scene goes.
bool keeps_velocity(const Scene& scene, std::uint32_t entity);

/// Radians from one angle of an entity to the next as find_meetings() has it turn: directions of a
/// path know no whole turns, there it is the shorter way round.
double turn_between(const Scene& scene, std::uint32_t entity, double from, double to);

/// Whether its shape, or the scale of a group it stands in, is a curve.
bool changes_size(const Scene& scene, std::uint32_t entity);

/// Why find_meetings() cannot be asked: an entity for each that changes its size.
std::optional<Diagnostics> refused_meetings(const Scene& scene);

/// Whether parts of an entity are left out of its meetings: open and other arcs, crossing outlines, and
/// ellipses that turn.
bool is_left_out(const Scene& scene, std::uint32_t entity);

/// Whether an entity never changes its place.
bool rests(const Scene& scene, std::uint32_t entity);

/// All meetings of the entities of a scene between frame 1 and `last_frame`, by first time, then
/// by entity.
///
/// Needs   last_frame as the timeline has it; nothing that changes its size: refused_meetings().
/// Gives   no pair of which neither ever moves. Nothing in straight motion goes through another unseen,
///         however fast: times between frames count. What turns or follows curves moves straight and turns evenly
///         from its place in one frame to that in the next, also what a group carries round; looks
///         are held as in the frame. What parts and meets again within a frame while it
///         turns meets twice.
/// Error   pairs that keep their velocities: exact verdicts, times within 1 ulp. What turns: proven,
///         as turning_contact(). Ellipses: proven, as curved_contact().
/// Cost    a sweep over boxes, for scenes where all keep their velocity once, else once a frame.
std::vector<Meeting> find_meetings(const Timeline& timeline, unsigned last_frame,
                                   Outline outline = Outline::own, unsigned threads = 1);

}  // namespace flatray
