#include "scene/outlines/holes.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "geom/predicates.h"
#include "scene/outlines/outline.h"

namespace flatray {
namespace {

using Hole = WallHole;

struct Edge {
  PathWall wall;
  std::int32_t number;
  bool turned = false;

  bool is_round() const { return wall.arc && wall.arc->is_whole(); }
  Vec2 at(double share) const {
    if (share == 0) return wall.from;
    if (share == 1 && !is_round()) return wall.to;
    return wall.arc ? wall.arc->at(wall.arc->from + share * wall.arc->sweep)
                    : Vec2(wall.from + share * (wall.to - wall.from));
  }
};

// In turn, as far as the shape has them so. Of what is no line, which has no inside.
std::vector<Edge> edges_of(const Shape& shape) {
  std::vector<Edge> edges;
  for (const OutlineEdge& edge : outline(shape))
    edges.push_back({{shape.vertices[edge.from], shape.vertices[edge.to], std::nullopt},
                     edge.number,
                     edge.turned});
  for (const Circle& circle : shape.circles) {
    const EllipseArc arc{circle.centre, {circle.radius, 0}, {0, circle.radius}};
    edges.push_back({{arc.start(), arc.end(), arc}, kNoEdge});
  }
  for (const ArcPath& path : shape.arc_paths) {
    std::int32_t number = 0;
    for (PathWall& wall : walls_of(path)) edges.push_back({std::move(wall), number++});
  }
  return edges;
}

// A hole by where it is along an edge in the edge's own direction.
struct Gap {
  double from, to;
  std::uint32_t hole;
};

// Arcs are counted counter-clockwise about their centre, whichever way a path goes along them.
Gap gap_of(const Edge& edge, const Hole& hole, std::uint32_t number) {
  const auto& arc = edge.wall.arc;
  const bool backward = arc && (arc->sweep > 0) != (cross_sign(arc->u, arc->v) == Sign::positive);
  const double all = hole.to > 1 ? 2 : 1;  // over the beginning of a whole curve
  return backward ? Gap{all - hole.to, all - hole.from, number} : Gap{hole.from, hole.to, number};
}

void cut_edge(const Edge& edge, const std::vector<Gap>& gaps, std::vector<WallPiece>& parts) {
  if (gaps.empty()) {
    parts.push_back({edge.wall, edge.number, kNoEntry, edge.turned});
    return;
  }
  const double begin = edge.is_round() ? gaps.front().from : 0;
  double at = begin;
  Vec2 from = edge.at(begin);
  // Each part begins at the doubles at which the one before it ends.
  const auto cut_to = [&](double share, const Vec2& to, std::uint32_t hole) {
    std::optional<EllipseArc> arc = edge.wall.arc;
    if (arc)
      arc = EllipseArc{arc->centre, arc->u, arc->v, arc->from + at * arc->sweep,
                       (share - at) * arc->sweep};
    if (to != from || hole != kNoEntry)
      parts.push_back({{from, to, arc}, edge.number, hole, edge.turned});
    at = share;
    from = to;
  };
  for (const Gap& gap : gaps) {
    cut_to(gap.from, edge.at(gap.from), kNoEntry);
    cut_to(gap.to, edge.at(gap.to), gap.hole);
  }
  cut_to(begin + 1, edge.is_round() ? edge.at(begin) : edge.wall.to, kNoEntry);
}

// The runs of what holes leave, to be drawn as lines that go round corners.
std::vector<ArcPath> runs_of(const std::vector<WallPiece>& parts) {
  std::vector<ArcPath> runs;
  const Vec2* end = nullptr;
  for (const auto& [wall, edge, hole, turned] : parts) {
    if (hole != kNoEntry) {
      end = nullptr;
      continue;
    }
    if (end == nullptr || *end != wall.from) runs.push_back({{}, false});
    std::vector<EllipseArc>& arcs = runs.back().arcs;
    if (wall.arc) {
      arcs.push_back(*wall.arc);
    } else {
      if (arcs.empty()) arcs.push_back(corner_at(wall.from));
      arcs.push_back(corner_at(wall.to));
    }
    end = &wall.to;
  }
  if (end != nullptr && runs.size() > 1 && *end == parts.front().wall.from &&
      parts.front().hole == kNoEntry) {
    std::vector<EllipseArc>&first = runs.front().arcs, &last = runs.back().arcs;
    last.insert(last.end(), first.begin(), first.end());
    first = std::move(last);
    runs.pop_back();
  }
  return runs;
}

// The gaps of each edge, and what is wrong with the holes.
struct Fitting {
  const std::vector<Edge>& edges;
  const Chamber& chamber;
  std::vector<std::vector<Gap>> gaps = std::vector<std::vector<Gap>>(edges.size());
  std::multimap<std::int32_t, std::size_t> by_number{};  // places in `edges`
  Diagnostics problems{};

  void fit() {
    for (std::size_t k = 0; k < edges.size(); ++k)
      by_number.emplace(std::max(edges[k].number, 0), k);
    for (std::uint32_t i = 0; i < chamber.holes.size(); ++i) add(i);
    for (std::vector<Gap>& some : gaps) {
      std::ranges::sort(some, {}, &Gap::from);
      for (std::size_t i = 0; i + 1 < some.size(); ++i) check_apart(some[i], some[i + 1], 0);
      if (some.size() > 1) check_apart(some.back(), some.front(), 1);
    }
  }
  void add(std::uint32_t number) {
    const Hole& hole = chamber.holes[number];
    const auto [first, end] = by_number.equal_range(hole.edge);
    if (first == end)
      return problem(hole, fmt::format("the walls have no edge {}", hole.edge),
                     fmt::format("they are numbered from 0 to {}",
                                 by_number.empty() ? 0 : by_number.rbegin()->first));
    if (std::next(first) != end)
      return problem(hole, fmt::format("edge {} is in several parts", hole.edge),
                     "write the shape so that nothing touches this edge within");
    const Edge& edge = edges[first->second];
    if (!(hole.to <= 1) && !edge.is_round())
      return problem(hole, "the hole reaches beyond its edge", "to is at most 1");
    if (!(hole.to - hole.from < 1) && edge.is_round())
      return problem(hole, "the hole takes all of its wall", "leave a part of it");
    const Gap gap = gap_of(edge, hole, number);
    if (edge.at(gap.from) == edge.at(gap.to))
      return problem(hole, "the ends of the hole are the same doubles", "make it larger");
    gaps[first->second].push_back(gap);
  }
  void check_apart(const Gap& one, const Gap& next, double round) {
    if (one.to <= next.from + round) return;
    problem(chamber.holes[std::max(one.hole, next.hole)], "two holes of one wall overlap",
            "write them as one, or let one end where the other begins");
  }
  void problem(const Hole& hole, std::string message, std::string hint) {
    problems.push_back({hole.where, std::move(message), std::move(hint)});
  }
};

}  // namespace

Diagnostics cut_walls(const Shape& shape, Chamber& chamber) {
  const std::vector<Edge> edges = edges_of(shape);
  Fitting fitting{edges, chamber};
  fitting.fit();
  if (!fitting.problems.empty()) return std::move(fitting.problems);
  for (std::size_t k = 0; k < edges.size(); ++k) cut_edge(edges[k], fitting.gaps[k], chamber.parts);
  chamber.kept.arc_paths = runs_of(chamber.parts);
  return {};
}

}  // namespace flatray
