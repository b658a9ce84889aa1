#pragma once
#include <gtest/gtest.h>

#include "trace/exact_nearest.h"
#include "trace/many_rays.h"
#include "trace/random_rays.h"
#include "trace/tracer.h"

namespace flatray {

inline std::vector<const Tracer*> exact_tracers() {
  std::vector<const Tracer*> exact;
  for (const Tracer* tracer : tracers())
    if (tracer->exact) exact.push_back(tracer);
  return exact;
}

struct Case {
  Surfaces walls;
  RayBatch rays;
};

inline NearestHit exact_hit_of(const Case& c, std::size_t ray) {
  ExactNearest search(c.walls, c.rays.ray(ray), c.rays.departed[ray], c.rays.tangents);
  search.offer_all();
  return search.hit();
}

inline void expect_hits(const std::vector<NearestHit>& truth, const std::vector<NearestHit>& hits,
                        const Case& c, const std::string& by) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Ray ray = c.rays.ray(i);
    ASSERT_EQ(hits[i], truth[i]) << by << ", ray " << i << " from " << ray.origin.transpose()
                                 << " along " << ray.direction.transpose() << ": wall "
                                 << hits[i].surface << " at " << hits[i].t << ", exactly "
                                 << truth[i].surface << " at " << truth[i].t;
  }
}

/// Every tracer in every tier against the exact code for every wall, bit for bit: in one call of the
/// rays as they are, by lanes, whose calls need many rays, and one by one. `exact`, which has no
/// lanes, in one tier.
inline void expect_all_tiers_exact(const Case& c) {
  const std::size_t count = c.rays.size();
  const Case many{c.walls, many_of(c.rays)};
  std::vector<NearestHit> truth, hits(count), copies(many.rays.size());
  for (std::size_t i = 0; i < copies.size(); ++i)
    truth.push_back(i < count ? exact_hit_of(c, i) : truth[i - count]);
  for (const Tracer* tracer : exact_tracers())
    for (const Isa isa : available_isas()) {
      if (tracer->name == std::string("exact") && isa != Isa::portable) continue;
      const auto walls = tracer->build(c.walls, isa);
      walls->nearest(c.rays, hits);
      expect_hits(truth, hits, c, std::string(tracer->name) + ", " + isa_name(isa));
      if (copies.size() > count) {
        walls->nearest(many.rays, copies);
        expect_hits(truth, copies, many, std::string(tracer->name) + ", lanes, " + isa_name(isa));
      }
      for (std::size_t i = 0; i < hits.size(); ++i)
        hits[i] = walls->nearest_of_one(c.rays.ray(i), c.rays.departed[i], c.rays.tangents);
      expect_hits(truth, hits, c, std::string(tracer->name) + ", one by one, " + isa_name(isa));
    }
}

}  // namespace flatray
