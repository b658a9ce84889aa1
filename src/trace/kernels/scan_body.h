// Every wall against every ray, by the judge of judge_body.h.

// Whether the rays of most of some vectors are less than `most_apart` cells apart, some cells from where they
// start.
inline bool go_together(const Walking& rays, float most_apart) {
  constexpr int kSampled = 8;
  constexpr float kWay = 8;
  const int vectors = rays.count / kLanes;
  if (kLanes == 1 || vectors < kSampled) return false;
  int together = 0;
  for (int k = 0; k < kSampled; ++k) {
    const int i = (vectors * k + vectors / 2) / kSampled * kLanes;
    const auto spread_of = [&](const float* from) {
      return most(load(from + i)) - least(load(from + i));
    };
    const float apart =
        spread_of(rays.ox) + spread_of(rays.oy) + kWay * (spread_of(rays.dx) + spread_of(rays.dy));
    together += apart < most_apart ? 1 : 0;
  }
  return together >= kSampled - 1;
}

// Every record against the next rays, lane by lane: `test_of(i)` tests one, given with its slot, for the vector of
// rays from i.
template <class TestOf>
void scan_all(const Grid& grid, const Walking& rays, int* found, const TestOf& test_of) {
  const Constants c = constants_of(grid);
  const Float edge = all(static_cast<float>(0 - grid.half_x));
  for (int i = 0; i < rays.count; i += kLanes) {
    Asked g;
    load_rays(rays, i, g);
    const Mask in_ring = less(g.ox, edge);
    const auto test_one = test_of(i);
    const unsigned* slot = grid.slots;
    for (const float* record = grid.records;; record += 4, ++slot) {
      g.record = all(static_cast<int>(*slot));
      test_one(c, spread_record(record), *slot, in_ring, g);
      if (is_last(record)) break;
    }
    write_verdicts(g, rays, found + i);
  }
}

template <bool some_departed, bool together>
void scan_segments(const Grid& grid, const Walking& rays, int* found) {
  scan_all(grid, rays, found, [&](int i) {
    const Int departed = some_departed ? load(rays.departed + i) : all(kNoRecord);
    return [departed](const Constants& c, const Record& r, unsigned, Mask in_ring, Asked& g) {
      judge<together>(c, r, some_departed ? either(in_ring, equal(departed, g.record)) : in_ring,
                      g);
    };
  });
}

template <bool some_departed>
void scan_curves(const Grid& grid, const Walking& rays, int* found) {
  scan_all(grid, rays, found, [&](int i) {
    return [&grid, &rays, i](const Constants& c, const Record& r, unsigned slot, Mask in_ring,
                             Asked& g) {
      const Left left = some_departed
                            ? left_of(load(rays.departed + i), load(rays.roots + i), g.record)
                            : Left{none(), none()};
      judge_curve(
          c, r, [&] { return spread_curve(grid.curves[slot]); }, in_ring, left, g);
    };
  });
}

[[maybe_unused]] void scan(const Grid& grid, const Walking& rays, int* found) {
  if (grid.curves != nullptr)
    return (rays.departed != nullptr ? scan_curves<true> : scan_curves<false>)(grid, rays, found);
  const bool together = go_together(rays, 0.5F);
  if (rays.departed != nullptr)
    (together ? scan_segments<true, true> : scan_segments<true, false>)(grid, rays, found);
  else
    (together ? scan_segments<false, true> : scan_segments<false, false>)(grid, rays, found);
}
