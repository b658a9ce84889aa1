#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "scene/keys/builder.h"
#include "scene/reading/format.h"
#include "scene/reading/made_values.h"
#include "scene/reading/numbers.h"

namespace flatray::hill_format {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr const char* kHint =
    "the file reads: how many pillars, the first of them the chamber; for each: sides r g b, then "
    "x y for every vertex";

// The chamber of F. S. Hill's case study "Reflections in a chamber": convex polygons, the first of
// which holds the others.
class HillReader {
 public:
  HillReader(SourcePtr source, const LoadLimits& limits)
      : source_(std::move(source)), limits_(limits), rest_(source_->text()) {}

  Result<SceneDesc> read() {
    const Place whole{source_, 0, 1};
    FLATRAY_TRY(count, whole_number("how many pillars", 1, limits_.max_entities, "--max-entities"));
    for (int i = 0; i < *count; ++i)
      if (auto read = read_pillar(i); !read) return fail(std::move(read));
    if (const std::string_view more = next(); !more.empty())
      return fail(place(more), "more than the pillars announced", kHint);
    chamber_.push_back(member("pillars", array_value(whole, std::move(pillars_))));
    return SceneDesc{
        table_of(whole, Member{"flatray", whole, built_in_number(1)},
                 member("chamber", array_value(whole, {table_value(whole, std::move(chamber_))})),
                 member("ray", array_value(whole, {ray(whole)})))};
  }

 private:
  Place place(std::string_view part) const { return place_in(source_, part); }
  std::string_view next() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
    rest_.remove_prefix(word.size());
    return word;
  }

  struct Number {
    double value;
    Place where;
  };
  Result<Number> number(const char* what) {
    const std::string_view word = next();
    if (word.empty())
      return fail(Place{source_, source_->text().size(), 0},
                  fmt::format("the file ends where {} should stand", what), kHint);
    const auto literal = parse_literal(word);
    if (!literal)
      return fail(place(word),
                  fmt::format("'{}' is not a finite number: {}", word.substr(0, 40), what), kHint);
    return Number{literal->value, place(word)};
  }
  // `raise` moves the most there may be, which fits into an int.
  Result<int> whole_number(const char* what, int low, std::uint64_t high, const char* raise) {
    constexpr std::uint64_t kMost = std::numeric_limits<int>::max();
    const std::uint64_t most = std::min(high, kMost);
    FLATRAY_TRY(found, number(what));
    if (!(found->value >= low) || found->value != std::floor(found->value))
      return fail(found->where, fmt::format("{} must be a whole number, {} or more", what, low),
                  kHint);
    if (found->value > static_cast<double>(most))
      return fail(found->where, fmt::format("{}: more than {}", what, most),
                  fmt::format("{} raises the limit", raise));
    return static_cast<int>(found->value);
  }

  // Parts of 1, as the book's programs give them to OpenGL.
  Result<Value> colour() {
    std::string text = "#";
    Place where;
    for (const char* part : {"red", "green", "blue"}) {
      FLATRAY_TRY(found, number(part));
      if (!(found->value >= 0 && found->value <= 1))
        return fail(found->where, fmt::format("{} must be from 0 to 1", part), kHint);
      text += fmt::format("{:02x}", static_cast<int>(found->value * 255 + 0.5));
      where = found->where;
    }
    return string_value(where, text);
  }

  Result<void> read_pillar(int index) {
    FLATRAY_TRY(sides, whole_number("sides", 3, limits_.max_corners, "--max-corners"));
    FLATRAY_TRY(paint, colour());
    const Place where = paint->where;
    std::vector<Value> points;
    for (int i = 0; i < *sides; ++i) {
      std::vector<Value> pair;
      for (const char* axis : {"x", "y"}) {
        FLATRAY_TRY(found, number(axis));
        pair.push_back({Value::Kind::number, found->where, {}, {}, {}});
        if (index == 0) middle_[axis[0] == 'x' ? 0 : 1] += found->value / *sides;
      }
      const Place at = pair.front().where;
      points.push_back(array_value(at, std::move(pair)));
    }
    Value ring = table_of(where, member("points", array_value(where, std::move(points))));
    add(index, table_of(where, member("convex", std::move(ring))), std::move(*paint));
    return {};
  }

  void add(int index, Value shape, Value paint) {
    const Place where = paint.where;
    if (index == 0) {
      chamber_.push_back(member("name", string_value(where, "chamber")));
      chamber_.push_back(member("shape", std::move(shape)));
      chamber_.push_back(member("stroke", table_of(where, member("width_px", built_in_number(2)),
                                                   member("colour", std::move(paint)))));
      return;
    }
    pillars_.push_back(
        table_of(where, member("name", string_value(where, fmt::format("pillar {}", index))),
                 member("shape", std::move(shape)), member("fill", std::move(paint))));
  }

  // The file has none: a start to be changed with -D.
  Value ray(const Place& where) const {
    const auto pair = [&](double x, double y) {
      return array_value(where, {built_in_number(x), built_in_number(y)});
    };
    return table_of(where, member("name", string_value(where, "start")),
                    member("at", pair(middle_[0], middle_[1])), member("direction", pair(1, 0.375)),
                    member("bounces", built_in_number(30)));
  }

  SourcePtr source_;
  const LoadLimits& limits_;
  std::string_view rest_;
  std::vector<Member> chamber_;
  std::vector<Value> pillars_;
  double middle_[2] = {0, 0};
};

Result<SceneDesc> read(const SourcePtr& source, const LoadLimits& limits) {
  return HillReader(source, limits).read();
}

// A whole number, then four numbers: sides and a colour.
bool recognises(std::string_view text) {
  const std::string_view line = first_line(text);
  return !line.empty() && line.find_first_not_of("0123456789") == std::string_view::npos;
}

constexpr std::string_view kExtensions[] = {"chamber"};

}  // namespace

extern const Format entry = {
    "hill",      "Hill's chamber: a count, then for each pillar sides r g b and its vertices",
    kExtensions, &recognises,
    &read,       nullptr};

}  // namespace flatray::hill_format
