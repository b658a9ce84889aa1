// Rays under way, one in each lane of a group. Bounds: walk.h.

// Groups of lanes are under way together, phase by phase, so that one computes while another waits
// for memory.
constexpr int kGroups = FLATRAY_LANES == 1 ? 1 : 4;
constexpr int kRefill = kLanes / 4 + 1;  // lanes that wait before new rays are put into them
constexpr unsigned kEveryLane = (1U << kLanes) - 1;
constexpr float kFar = 1e30F, kEndless = __builtin_inff();

struct Constants {
  Float side, time, near, curve, part, stride, first;
};

// A ray in every lane, and what is known of its first wall.
struct Asked {
  Float ox, oy, dx, dy;
  Float end_low, end_high;  // of rays that end
  Int record, best;         // tested now, or negative; the best sure hit
  Float low, high, other;   // of that; least t any other wall not ruled out could have
  Float limit;              // hits later than this wait
};

// Rays that walk on their own.
struct Group : Asked {
  // Turned so that it goes up and to the right: cells are entered in rising order.
  Float from_x, from_y, step_x, step_y, inverse_x, inverse_y;
  Float turn_x, turn_y, first;  // cell of corner (x, y), turned: first + turn_x x + turn_y y
  Float departed_ax, departed_ay, departed_bx;
  Float ray;              // its number
  Int quadrant;           // shift of the word of an empty cell
  Float x, y;             // where a cell is entered, then its corner, turned
  Float exit_x, exit_y;   // planes by which its box is left
  Float exit;             // t there
  Mask live, done;        // under way; finished and not yet written
  Mask moving, across_x;  // between two cells; by a change of x
};

inline Constants constants_of(const Grid& grid) {
  return {all(kSide * grid.unit),  all(kTime * grid.unit), all(kNear * grid.unit),
          all(kCurve * grid.unit), all(kPart * grid.unit), all(grid.stride),
          all(grid.first)};
}

// A record for all rays, and whether it is the last of its list.
inline Record spread_record(const float* at) {
  return {all(at[0]), all(at[1]), all(at[2]), all(at[3])};
}
inline bool is_last(const float* at) { return (__builtin_bit_cast(unsigned, at[3]) & 1U) != 0; }

// `other` begins as where a ray ends, at the latest, so that it stops there.
inline Int verdict(const Asked& g, const Walking& rays) {
  if (rays.up_to != nullptr) {
    const Mask open = less(smaller(g.low, g.other), g.end_high);
    const Float latest = rays.is_first ? smaller(g.end_low, g.other) : g.end_low;
    return choose(less(g.high, latest), g.best, choose(open, all(kDoubt), all(kNoRecord)));
  }
  const Int unsure = choose(less(g.other, all(kFar)), all(kDoubt), all(kNoRecord));
  return choose(less(g.high, g.other), g.best, unsure);
}

// Takes the rays of a vector, one for each lane, but for what the walk needs of them.
inline void load_rays(const Walking& rays, int at, Asked& g) {
  g.ox = load(rays.ox + at);
  g.oy = load(rays.oy + at);
  g.dx = load(rays.dx + at);
  g.dy = load(rays.dy + at);
  g.limit = all(kEndless);
  g.low = g.high = g.other = all(kFar);
  if (rays.up_to != nullptr) {
    g.end_low = load(rays.end_low + at);
    g.other = g.end_high = smaller(load(rays.end_high + at), g.other);
  }
  g.best = all(kNoRecord);
}

inline void write_verdicts(const Asked& g, const Walking& rays, int* found) {
  alignas(64) unsigned met[kLanes];
  store(met, verdict(g, rays));
  __builtin_memcpy(found, met, sizeof met);
}
