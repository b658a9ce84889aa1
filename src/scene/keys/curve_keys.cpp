#include "scene/keys/curve_keys.h"

#include <cmath>

#include "base/light.h"
#include "scene/keys/corner_limit.h"
#include "scene/keys/keys.h"

namespace flatray {
namespace {

constexpr Word<Curve::Ease> kEases[] = {
    {"linear", Curve::Ease::linear}, {"smooth", Curve::Ease::smooth}, {"step", Curve::Ease::step}};

// What the values of a curve are.
struct CurveOf {
  std::size_t numbers;  // of each
  const char* takes;
};
constexpr CurveOf kNumbers{1, "[[t, v], ...]"}, kPoints{2, "[[t, [x, y]], ...]"},
    kColours{4, R"([[t, "#rrggbb"], ...])"};

// `{ keys = [[t, v], ...] }`.
struct CurveWords {
  Curve::Ease ease = Curve::Ease::linear;
  const Value* keys = nullptr;
};

void keep_keys(Builder&, const Field& field, CurveWords& words) { words.keys = &field.value; }

constexpr Key<CurveWords> kCurveKeys[] = {
    {{"keys", R"([[t, v or [x, y] or "#rrggbb"], ...])", kRequired}, &keep_keys},
    {{"ease", R"("linear", "smooth" or "step")", R"("linear")"},
     &set_word<&CurveWords::ease, kEases>},
};

// Steeper than this, and a slope in between could be beyond the doubles; steps have none.
bool too_steep(const Curve& curve, std::size_t i) {
  if (curve.ease == Curve::Ease::step) return false;
  const double rise = curve.values[i] - curve.values[i - 1];
  return std::abs(rise / (curve.times[i] - curve.times[i - 1])) > kFarthest;
}

class CurveReader {
 public:
  CurveReader(Builder& builder, const Field& field, const CurveOf& what)
      : builder_(builder), field_(field), what_(what) {}

  // One curve for each number of a value; nullopt where the text is wrong.
  std::optional<std::vector<Curve>> read() {
    const std::size_t problems = builder_.in.problems.size();
    CurveWords words;
    read_keys(builder_, field_.value, "curve", kCurveKeys, words);
    if (words.keys == nullptr) return std::nullopt;
    const Field keys{field_.name + ".keys", *words.keys, what_.takes};
    if (!builder_.in.is(keys, Value::Kind::array, "a list of keys")) return std::nullopt;
    if (keys.value.items.empty())
      builder_.in.problem(keys, "is empty", "write at least one [t, v]");
    curves_.assign(what_.numbers, {words.ease, {}, {}});
    for (std::size_t i = 0; i < keys.value.items.size(); ++i) add(keys.item(i));
    if (builder_.in.problems.size() > problems) return std::nullopt;
    return std::move(curves_);
  }

 private:
  void add(const Field& key) {
    if (!builder_.in.is_pair(key, "a time and a value")) return;
    const auto time = builder_.in.number(key.item(0));
    const std::optional<std::vector<double>> values = values_of(key.item(1));
    if (!time || !values) return;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      curves_[i].times.push_back(*time);
      curves_[i].values.push_back((*values)[i]);
    }
    check_last(key);
  }

  std::optional<std::vector<double>> values_of(const Field& field) {
    using Values = std::vector<double>;
    if (what_.numbers == kPoints.numbers) {
      const auto point = builder_.in.point(field);
      return point ? std::optional(Values{point->x(), point->y()}) : std::nullopt;
    }
    if (what_.numbers == kColours.numbers) {
      const auto colour = builder_.in.colour(field);
      return colour ? std::optional(light_values(*colour)) : std::nullopt;
    }
    const auto number = builder_.in.number(field);
    return number ? std::optional(Values{*number}) : std::nullopt;
  }

  // As blended: light of each primary times alpha, and alpha.
  static std::vector<double> light_values(const Colour& colour) {
    const double alpha = static_cast<double>(static_cast<float>(colour.a) / 255.0F);
    std::vector<double> values;
    for (const std::uint8_t primary : {colour.r, colour.g, colour.b})
      values.push_back(static_cast<double>(linear_from_srgb(primary)) * alpha);
    values.push_back(alpha);
    return values;
  }

  void check_last(const Field& key) {
    const std::vector<double>& times = curves_.front().times;
    const std::size_t last = times.size() - 1;
    if (std::abs(times[last]) > kFarthest || std::abs(curves_.front().values[last]) > kFarthest)
      return builder_.in.problem(key, "lies beyond 1e300",
                                 "write numbers between -1e300 and 1e300");
    if (last == 0) return;
    if (!(times[last] > times[last - 1]))
      return builder_.in.problem(key, "is not later than the key before it",
                                 "write the keys in the order of their times, in seconds");
    for (const Curve& curve : curves_)
      if (too_steep(curve, last))
        return builder_.in.problem(key, "is too near to the key before it", "part their times");
  }

  Builder& builder_;
  const Field& field_;
  const CurveOf& what_;
  std::vector<Curve> curves_;
};

// Number of the first of a value's curves. Those in which nothing is drawn are shared by copies.
std::optional<CurveId> read_curves(Builder& builder, const Field& field, const CurveOf& what,
                                   double (*change)(double) = nullptr) {
  const auto known = builder.fixed_curves.find(&field.value);
  if (known != builder.fixed_curves.end()) return known->second;
  std::optional<std::vector<Curve>> curves = CurveReader(builder, field, what).read();
  if (!curves) return std::nullopt;
  if (!take_corners(builder, curves->size() * curves->front().times.size(), field.value.where))
    return std::nullopt;
  const auto first = static_cast<CurveId>(builder.scene.curves.size());
  for (Curve& curve : *curves) {
    if (change != nullptr)
      for (double& value : curve.values) value = change(value);
    curve.largest = std::max(std::fabs(lowest(curve)), std::fabs(highest(curve)));
    builder.scene.curves.push_back(std::move(curve));
  }
  if (!has_distribution(field.value)) builder.fixed_curves.emplace(&field.value, first);
  return first;
}

}  // namespace

std::optional<Moving> read_moving(Builder& builder, const Field& field, double (*change)(double),
                                  bool may_be_curve) {
  if (may_be_curve && is_curve(field.value)) {
    const std::optional<CurveId> curve = read_curves(builder, field, kNumbers, change);
    return curve ? std::optional(Moving{0, curve}) : std::nullopt;
  }
  const std::optional<double> number = builder.in.number(field);
  if (!number) return std::nullopt;
  return Moving{change == nullptr ? *number : change(*number), {}};
}

double lowest(const Scene& scene, const Moving& number) {
  return number.curve ? lowest(scene.curves[*number.curve]) : number.value;
}

double highest(const Scene& scene, const Moving& number) {
  return number.curve ? highest(scene.curves[*number.curve]) : number.value;
}

bool lies_between(const Scene& scene, const Moving& number, double low, double high) {
  return lowest(scene, number) >= low && highest(scene, number) <= high;
}

std::optional<MovingPoint> read_moving_point(Builder& builder, const Field& field,
                                             bool may_be_curve) {
  if (may_be_curve && is_curve(field.value)) {
    const std::optional<CurveId> curve = read_curves(builder, field, kPoints);
    return curve ? std::optional(MovingPoint{{0, 0}, *curve, *curve + 1}) : std::nullopt;
  }
  const std::vector<Value>& items = field.value.items;
  if (!may_be_curve || items.size() != 2 || !(is_curve(items[0]) || is_curve(items[1]))) {
    const std::optional<Vec2> point = builder.in.point(field);
    return point ? std::optional(MovingPoint{*point, {}, {}}) : std::nullopt;
  }
  const std::optional<Moving> x = read_moving(builder, field.item(0));
  const std::optional<Moving> y = read_moving(builder, field.item(1));
  if (!x || !y) return std::nullopt;
  const Vec2 value(x->value, y->value);
  if (value.cwiseAbs().maxCoeff() <= kFarthest) return MovingPoint{value, x->curve, y->curve};
  return builder.in.refuse(field, "lies beyond 1e300", "write numbers between -1e300 and 1e300");
}

std::optional<Paint> read_moving_colour(Builder& builder, const Field& field) {
  if (!builder.may_change || !is_curve(field.value)) {
    const std::optional<Colour> colour = builder.in.colour(field);
    return colour ? std::optional(Paint(*colour)) : std::nullopt;
  }
  const std::optional<CurveId> curve = read_curves(builder, field, kColours);
  if (!curve) return std::nullopt;
  Paint paint;
  paint.curve = *curve;
  return paint;
}

std::vector<TableInfo> curve_tables() {
  return {{"curve", key_infos<CurveWords>(kCurveKeys), true}};
}

}  // namespace flatray
