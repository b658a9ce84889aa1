#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/options/tracer_choice.h"
#include "base/json.h"
#include "geom/ray.h"
#include "trace/surfaces.h"

namespace flatray {

struct QuestionPart;

/// The fields of one question, read by name. A field that is absent or wrong gives a value of no
/// meaning and a mistake that names it; answers are not to be used where there are mistakes.
class Question {
 public:
  /// Needs   an object that outlives it.
  explicit Question(const JsonValue& whole, const Precision& precision = {})
      : whole_(whole), precision_(precision) {}

  const Precision& precision() const { return precision_; }

  bool has(std::string_view name) const;
  Vec2 point(std::string_view name);
  std::string word(std::string_view name);
  /// A whole number that is not negative.
  std::uint64_t whole(std::string_view name);
  /// origin, direction.
  Ray ray();
  /// One of three words of `domain`, which stand for all t, t >= 0 (also where it is absent) and
  /// 0 <= t <= 1.
  Range domain(const char* line, const char* ray, const char* segment);
  /// Corners of a convex polygon, at least one.
  std::vector<Vec2> polygon(std::string_view name);
  /// {"polygon":[[x,y],...],"velocity":[vx,vy]}, also with a "radius" that is laid round it, or
  /// with "disc":{"center":[x,y],"radius":r} in place of the polygon; with a "spin" in degrees a
  /// unit of t it turns about the point "about", [0, 0] where that is not said.
  struct Moving {
    std::vector<Vec2> polygon;
    Vec2 velocity{0, 0};
    double radius = 0;
    double spin = 0;  ///< radians
    Vec2 about{0, 0};
  };
  Moving moving(std::string_view name);
  /// {"center":[x,y],"radius":r}
  Circle disc(std::string_view name);
  /// [{"segment":[[x1,y1],[x2,y2]]}, {"circle":{"center":[x,y],"radius":r}},
  /// {"arc":{"center":[x,y],"radius":r,"towards":[hx,hy]}}, {"arc":{...,"from":deg,"to":deg}},
  /// {"ellipse":{"center":[x,y],"u":[ux,uy],"v":[vx,vy]}}, {"bezier":[[x,y],...]},
  /// {"conic":{"points":[[x,y],...],"weight":w}}, ...], numbered in this order.
  Surfaces walls(std::string_view name);

  /// Says what is wrong, and where: "direction: is missing".
  void mistake(std::string_view where, std::string_view what);
  /// Whether nothing was wrong with the fields read so far.
  bool sound() const { return mistakes_.empty(); }
  /// All mistakes, those of fields that nobody asked for among them; "" for none.
  std::string mistakes();

 private:
  // The field of that name, with a mistake where it is missing.
  QuestionPart find(std::string_view name);

  const JsonValue& whole_;
  const Precision precision_;
  std::vector<std::string> asked_;
  std::string mistakes_;
  std::size_t mistake_count_ = 0;
};

}  // namespace flatray
