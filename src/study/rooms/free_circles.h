#pragma once
#include "study/rooms/room.h"

namespace flatray {

/// Area of the places about which a circle lies in the free part of a closed chamber and meets no
/// wall: the centres of the flights that circle freely in a magnetic field.
///
/// Error   of a sum over 16384 rows in doubles: under most_off_of_free_centres(), where no two passages are both
///         lower than a row.
/// Cost    some 0.1 us for a row and a pair of walls.
double area_of_free_centres(const Room& room, double radius);
/// 1e-4 of the box around all walls.
double most_off_of_free_centres(const Room& room);

}  // namespace flatray
