#include <algorithm>
#include <tuple>

#include "geom/predicates.h"
#include "scene/imports/hqz_scene.h"

namespace flatray {
namespace {

// A wall that stays where it is, and its line but for rounding: those of walls on one line differ by
// some ulps.
struct Wall {
  std::size_t object;
  Vec2 from, to;
  double slope = 0, offset = 0;
  bool steep = false;
};

std::optional<Wall> wall_of(const std::vector<HqzObject>& objects, std::size_t i) {
  const HqzObject& object = objects[i];
  if (object.normal || !object.x.is_number() || !object.y.is_number() || !object.dx.is_number() ||
      !object.dy.is_number())
    return std::nullopt;
  Wall wall{i, {object.x.low, object.y.low}, {}, 0, 0, false};
  wall.to = wall.from + Vec2(object.dx.low, object.dy.low);
  if (wall.from == wall.to) return std::nullopt;
  const Vec2 along = wall.to - wall.from;
  wall.steep = std::abs(along.y()) > std::abs(along.x());
  const int major = wall.steep ? 1 : 0;
  wall.slope = along[1 - major] / along[major];
  wall.offset = wall.from[1 - major] - wall.slope * wall.from[major];
  return wall;
}

bool on_one_line(const Wall& a, const Wall& b) {
  return orientation(a.from, a.to, b.from) == Sign::zero &&
         orientation(a.from, a.to, b.to) == Sign::zero;
}

struct Part {
  Vec2 from, to;
};

// Where walls of one line lie, by their major axis: parts in order that share ends at most.
class Covered {
 public:
  explicit Covered(int major) : major_(major) {}

  // What was left of `whole`, which is covered from now on.
  std::vector<Part> add(const Part& whole) {
    const auto at = [&](const Vec2& point) { return point[major_]; };
    const auto ends_before = [&](const Part& part) { return at(part.to) <= at(whole.from); };
    const auto first = std::partition_point(parts_.begin(), parts_.end(), ends_before);
    auto last = first;
    std::vector<Part> left;
    Part all = whole;
    Vec2 from = whole.from;
    for (; last != parts_.end() && at(last->from) < at(whole.to); ++last) {
      if (at(from) < at(last->from)) left.push_back({from, last->from});
      from = last->to;
      if (at(last->from) <= at(all.from)) all.from = last->from;
      if (at(last->to) >= at(all.to)) all.to = last->to;
    }
    if (at(from) < at(whole.to)) left.push_back({from, whole.to});
    if (first == last) {
      parts_.insert(first, all);
    } else {
      *first = all;
      parts_.erase(first + 1, last);
    }
    return left;
  }

 private:
  int major_;
  std::vector<Part> parts_;
};

void cut(const std::vector<Wall>& line, const std::vector<HqzObject>& objects,
         std::vector<std::vector<HqzObject>>& parts, Diagnostics& warnings) {
  const int major = line.front().steep ? 1 : 0;
  Covered covered(major);
  for (const Wall& wall : line) {
    Part whole{wall.from, wall.to};
    if (whole.from[major] > whole.to[major]) std::swap(whole.from, whole.to);
    const std::vector<Part> left = covered.add(whole);
    if (left.size() == 1 && left[0].from == whole.from && left[0].to == whole.to) continue;
    const HqzObject& object = objects[wall.object];
    warnings.push_back({object.where, "a part of this object lies on one before it",
                        "light meets the first alone there"});
    parts[wall.object].clear();
    for (const Part& part : left) {
      HqzObject piece = object;
      const auto fixed = [&](double v) { return HqzRange{v, v, object.where}; };
      piece.x = fixed(part.from.x()), piece.y = fixed(part.from.y());
      piece.end = part.to;
      parts[wall.object].push_back(piece);
    }
  }
}

}  // namespace

std::vector<HqzObject> without_overlaps(std::vector<HqzObject> objects, Diagnostics& warnings) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (const auto wall = wall_of(objects, i)) walls.push_back(*wall);
  // Bands of walls of nearly one slope, and in them of nearly one offset, hold all of one line.
  constexpr double kNear = 0x1p-30;  // far more than rounding; what lies on what is decided exactly
  constexpr std::ptrdiff_t kMostOnALine = 4096;
  const auto by_slope = [](const Wall& a, const Wall& b) {
    return std::tuple(a.steep, a.slope, a.object) < std::tuple(b.steep, b.slope, b.object);
  };
  const auto by_offset = [](const Wall& a, const Wall& b) {
    return std::tuple(a.offset, a.object) < std::tuple(b.offset, b.object);
  };
  const auto bands = [](auto begin, auto end, const auto& near, const auto& take) {
    while (begin != end) {
      auto last = begin + 1;
      while (last != end && near(*(last - 1), *last)) ++last;
      take(begin, last);
      begin = last;
    }
  };
  double size = 0;
  for (const Wall& wall : walls)
    size = std::max({size, wall.from.cwiseAbs().maxCoeff(), wall.to.cwiseAbs().maxCoeff()});
  std::vector<std::vector<HqzObject>> parts(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) parts[i] = {objects[i]};
  const auto cut_band = [&](auto begin, auto end) {
    if (end - begin > kMostOnALine)
      return warnings.push_back({objects[begin->object].where,
                                 "too many objects lie nearly on the line of this one",
                                 "where they lie on one another light ends"});
    std::sort(begin, end, [](const Wall& a, const Wall& b) { return a.object < b.object; });
    std::vector<Wall> rest(begin, end);
    while (rest.size() > 1) {
      const auto other = std::stable_partition(rest.begin() + 1, rest.end(), [&](const Wall& wall) {
        return on_one_line(rest[0], wall);
      });
      if (other - rest.begin() > 1)
        cut(std::vector<Wall>(rest.begin(), other), objects, parts, warnings);
      rest.erase(rest.begin(), other);
    }
  };
  std::ranges::sort(walls, by_slope);
  bands(
      walls.begin(), walls.end(),
      [&](const Wall& a, const Wall& b) {
        return a.steep == b.steep && b.slope - a.slope <= kNear;
      },
      [&](auto begin, auto end) {
        std::sort(begin, end, by_offset);
        bands(
            begin, end,
            [&](const Wall& a, const Wall& b) { return b.offset - a.offset <= kNear * size; },
            cut_band);
      });
  std::vector<HqzObject> left;
  for (std::vector<HqzObject>& one : parts)
    left.insert(left.end(), std::make_move_iterator(one.begin()),
                std::make_move_iterator(one.end()));
  return left;
}

}  // namespace flatray
