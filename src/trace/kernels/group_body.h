// Rays under way, one in each lane of a group. Bounds: walk.h.

// Groups of lanes are under way together, phase by phase, so that one computes while another waits
// for memory.
constexpr int kGroups = FLATRAY_LANES == 1 ? 1 : 4;
constexpr int kRefill = kLanes / 4 + 1;  // lanes that wait before new rays are put into them
constexpr float kFar = 1e30F, kEndless = __builtin_inff();

struct Constants {
  Float side, time, near, stride, first;
};

// A ray in every lane.
struct Group {
  Float ox, oy, dx, dy;
  // Turned so that it goes up and to the right: cells are entered in rising order.
  Float from_x, from_y, step_x, step_y, inverse_x, inverse_y;
  Float turn_x, turn_y, first;  // cell of corner (x, y), turned: first + turn_x x + turn_y y
  Float left_ax, left_ay, left_bx;
  Float end_low, end_high;  // of rays that end
  Float ray;                // its number
  Int quadrant;             // shift of the word of an empty cell
  Float x, y;               // where a cell is entered, then its corner, turned
  Float exit_x, exit_y;     // planes by which its box is left
  Float exit, limit;        // t there; hits later than the limit wait
  Int record, best;         // to be tested next, or negative; of the best sure hit
  Float low, high, other;   // of that; least t any other wall not ruled out could have
  Mask live, done;          // under way; finished and not yet written
  Mask moving, across_x;    // between two cells; by a change of x
};
