#include "scene/motion_keys.h"

#include <algorithm>
#include <cmath>

#include "scene/corner_limit.h"

namespace flatray {
namespace {

constexpr Word<Curve::Ease> kEases[] = {{"linear", Curve::Ease::linear},
                                        {"smooth", Curve::Ease::smooth}};

// `{ keys = [[t, v], ...] }` with values of one or two numbers.
struct CurveWords {
  Curve::Ease ease = Curve::Ease::linear;
  const Value* keys = nullptr;
};

void keep_keys(Builder&, const Field& field, CurveWords& words) { words.keys = &field.value; }

constexpr Key<CurveWords> kCurveKeys[] = {
    {{"keys", "[[t, v or [x, y]], ...]", kRequired}, &keep_keys},
    {{"ease", R"("linear" or "smooth")", R"("linear")"}, &set_word<&CurveWords::ease, kEases>},
};

// Steeper than this, and a slope in between could be beyond the doubles.
bool too_steep(const Curve& curve, std::size_t i) {
  const double rise = curve.values[i] - curve.values[i - 1];
  return std::abs(rise / (curve.times[i] - curve.times[i - 1])) > kFarthest;
}

class CurveReader {
 public:
  CurveReader(Builder& builder, const Field& field) : builder_(builder), field_(field) {}

  // One curve for each number of a value; nullopt where the text is wrong.
  std::optional<std::vector<Curve>> read(std::size_t numbers) {
    const std::size_t problems = builder_.in.problems.size();
    CurveWords words;
    read_keys<CurveWords>(builder_, field_.value, "curve", kCurveKeys, words);
    if (words.keys == nullptr) return std::nullopt;
    const Field keys{field_.name + ".keys", *words.keys,
                     numbers == 1 ? "[[t, v], ...]" : "[[t, [x, y]], ...]"};
    if (!builder_.in.is(keys, Value::Kind::array, "a list of keys")) return std::nullopt;
    if (keys.value.items.empty())
      builder_.in.problem(keys.value.where, keys.name + " is empty", "write at least one [t, v]");
    curves_.assign(numbers, {words.ease, {}, {}});
    for (std::size_t i = 0; i < keys.value.items.size(); ++i) add(keys.item(i));
    if (builder_.in.problems.size() > problems) return std::nullopt;
    return std::move(curves_);
  }

 private:
  void add(const Field& key) {
    if (key.value.kind != Value::Kind::array || key.value.items.size() != 2)
      return builder_.in.mismatch(key, "a time and a value");
    const auto time = builder_.in.number(key.item(0));
    std::optional<Vec2> value;
    if (curves_.size() == 2)
      value = builder_.in.point(key.item(1));
    else if (const auto number = builder_.in.number(key.item(1)))
      value = Vec2(*number, 0);
    if (!time || !value) return;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      curves_[i].times.push_back(*time);
      curves_[i].values.push_back((*value)[static_cast<Eigen::Index>(i)]);
    }
    check_last(key);
  }

  void check_last(const Field& key) {
    const std::vector<double>& times = curves_.front().times;
    const std::size_t last = times.size() - 1;
    if (std::abs(times[last]) > kFarthest || std::abs(curves_.front().values[last]) > kFarthest)
      return builder_.in.problem(key.value.where, key.name + " lies beyond 1e300",
                                 "write numbers between -1e300 and 1e300");
    if (last == 0) return;
    if (!(times[last] > times[last - 1]))
      return builder_.in.problem(key.value.where, key.name + " is not later than the key before it",
                                 "write the keys in the order of their times, in seconds");
    for (const Curve& curve : curves_)
      if (too_steep(curve, last))
        return builder_.in.problem(key.value.where, key.name + " is too near to the key before it",
                                   "part their times");
  }

  Builder& builder_;
  const Field& field_;
  std::vector<Curve> curves_;
};

// Number of the first of a value's curves. Those in which nothing is drawn are shared by copies.
std::optional<CurveId> read_curves(Builder& builder, const Field& field, std::size_t numbers,
                                   double (*change)(double)) {
  const auto known = builder.fixed_curves.find(&field.value);
  if (known != builder.fixed_curves.end()) return known->second;
  std::optional<std::vector<Curve>> curves = CurveReader(builder, field).read(numbers);
  if (!curves) return std::nullopt;
  if (!take_corners(builder, numbers * curves->front().times.size(), field.value.where))
    return std::nullopt;
  const auto first = static_cast<CurveId>(builder.scene.curves.size());
  for (Curve& curve : *curves) {
    if (change != nullptr)
      for (double& value : curve.values) value = change(value);
    builder.scene.curves.push_back(std::move(curve));
  }
  if (!has_distribution(field.value)) builder.fixed_curves.emplace(&field.value, first);
  return first;
}

struct FollowWords {
  std::vector<Vec2> path;
  std::optional<double> speed, duration;
  double start = 0;
  bool closed = false, turn = false;
};

void read_path(Builder& builder, const Field& field, FollowWords& words) {
  if (!builder.in.is(field, Value::Kind::array, "a list of points")) return;
  for (std::size_t i = 0; i < field.value.items.size(); ++i)
    if (const auto point = builder.in.point(field.item(i))) words.path.push_back(*point);
}

void read_duration(Builder& builder, const Field& field, FollowWords& words) {
  words.duration = builder.in.number(field);
  if (words.duration && !(*words.duration > 0))
    builder.in.problem(field.value.where, field.name + " is not above 0",
                       "write the seconds the whole path takes");
}

constexpr Key<FollowWords> kFollowKeys[] = {
    {{"path", "[[x, y], ...]", kRequired}, &read_path},
    {{"speed", "number", "none"}, &set<&FollowWords::speed>},
    {{"duration", "seconds", "none"}, &read_duration},
    {{"start", "world units", "0"}, &set<&FollowWords::start>},
    {{"closed", "true or false", "false"}, &set<&FollowWords::closed>},
    {{"turn", "true or false", "false"}, &set<&FollowWords::turn>},
};

// Points that differ from those before them, with the way to each.
Path measured(const FollowWords& words) {
  Path path{.points = {}, .lengths = {}, .closed = words.closed};
  const auto add = [&](const Vec2& point) {
    if (path.points.empty()) {
      path.points.push_back(point);
      path.lengths.push_back(0);
      return;
    }
    const Vec2 edge = point - path.points.back();
    const double length = path.lengths.back() + std::sqrt(edge.squaredNorm());
    if (!(length > path.lengths.back())) return;
    path.points.push_back(point);
    path.lengths.push_back(length);
  };
  for (const Vec2& point : words.path) add(point);
  if (words.closed && !words.path.empty()) add(words.path.front());
  return path;
}

}  // namespace

std::optional<Moving> read_moving(Builder& builder, const Field& field, double (*change)(double)) {
  if (is_curve(field.value)) {
    const std::optional<CurveId> curve = read_curves(builder, field, 1, change);
    return curve ? std::optional(Moving{0, curve}) : std::nullopt;
  }
  const std::optional<double> number = builder.in.number(field);
  if (!number) return std::nullopt;
  return Moving{change == nullptr ? *number : change(*number), {}};
}

double lowest(const Curve& curve) {
  return *std::min_element(curve.values.begin(), curve.values.end());
}

double highest(const Curve& curve) {
  return *std::max_element(curve.values.begin(), curve.values.end());
}

std::optional<MovingPoint> read_moving_point(Builder& builder, const Field& field) {
  if (is_curve(field.value)) {
    const std::optional<CurveId> curve = read_curves(builder, field, 2, nullptr);
    return curve ? std::optional(MovingPoint{{0, 0}, *curve, *curve + 1}) : std::nullopt;
  }
  const std::vector<Value>& items = field.value.items;
  if (items.size() != 2 || !(is_curve(items[0]) || is_curve(items[1]))) {
    const std::optional<Vec2> point = builder.in.point(field);
    return point ? std::optional(MovingPoint{*point, {}, {}}) : std::nullopt;
  }
  const std::optional<Moving> x = read_moving(builder, field.item(0));
  const std::optional<Moving> y = read_moving(builder, field.item(1));
  if (!x || !y) return std::nullopt;
  const Vec2 value(x->value, y->value);
  if (value.cwiseAbs().maxCoeff() <= kFarthest) return MovingPoint{value, x->curve, y->curve};
  builder.in.problem(field.value.where, field.name + " lies beyond 1e300",
                     "write numbers between -1e300 and 1e300");
  return std::nullopt;
}

void read_follow_path(Builder& builder, const Field& field, Motion& motion) {
  const std::size_t problems = builder.in.problems.size();
  FollowWords words;
  read_keys<FollowWords>(builder, field.value, "follow", kFollowKeys, words);
  if (builder.in.problems.size() > problems) return;
  if (words.speed.has_value() == words.duration.has_value())
    return builder.in.problem(field.value.where, "follow wants either speed or duration",
                              "write one of speed = v and duration = seconds");
  auto [known, added] = builder.fixed_paths.try_emplace(field.value.find("path"));
  if (added || has_distribution(field.value)) {
    Path path = measured(words);
    if (path.points.size() < 2)
      return builder.in.problem(field.value.where, "the path of follow has no length",
                                "write two points or more that differ");
    if (!(path.lengths.back() <= kFarthest))
      return builder.in.problem(field.value.where, "the path of follow is too long",
                                "stay within 1e150 or so");
    if (!take_corners(builder, path.points.size(), field.value.where)) return;
    known->second = static_cast<std::uint32_t>(builder.scene.paths.size());
    builder.scene.paths.push_back(std::move(path));
  }
  const double length = builder.scene.paths[known->second].lengths.back();
  motion.follow = Follow{known->second, words.speed.value_or(length), words.duration.value_or(1),
                         words.start, words.turn};
}

std::vector<TableInfo> motion_tables() {
  return {{"curve", key_infos<CurveWords>(kCurveKeys), true},
          {"follow", key_infos<FollowWords>(kFollowKeys), true}};
}

}  // namespace flatray
