#include "scene/reading/args.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "scene/keys/curve_keys.h"
#include "scene/reading/numbers.h"

namespace flatray {
namespace {

bool written_the_same(const Value& a, const Value& b) {
  for (std::size_t i = 0; i < 2; ++i)
    if (parse_decimal(source_text(a.items[i])) != parse_decimal(source_text(b.items[i])))
      return false;
  return true;
}

std::string point_text(const Value& point) {
  return fmt::format("({}, {})", source_text(point.items[0]).substr(0, 40),
                     source_text(point.items[1]).substr(0, 40));
}

// As the table of its keys says.
bool may_change(const Field& field) {
  return std::string_view(field.takes).find("a curve") != std::string_view::npos;
}

}  // namespace

Args::Args(Builder& builder, Field field, std::span<const KeyInfo> keys, KeptArguments* changing)
    : where(field.value.where),
      builder_(&builder),
      scene_(&builder.scene),
      field_(std::move(field)),
      keys_(keys),
      noting_(changing),
      known_(changing) {
  check_keys(field_->value, field_->name, keys, builder.in.problems);
}

Args::Args(const Scene& scene, const KeptArguments& changing, double time)
    : scene_(&scene), known_(&changing), time_(time) {}

void Args::set_time(double time) {
  time_ = time;
  gone_ = warns_ = false;
}

std::optional<Field> Args::find(const char* key) const {
  const Member* member = field_ ? field_->value.find(key) : nullptr;
  if (member == nullptr) return std::nullopt;
  const auto info = std::ranges::find_if(
      keys_, [&](const KeyInfo& known) { return std::string_view(known.name) == key; });
  return Field{field_->name + "." + key, member->value, info == keys_.end() ? "" : info->takes};
}

const Moving* Args::kept_number(const char* key) {
  const Argument* argument = noted(key, [&](const Field& field, Argument& made) {
    if (const auto number = read_moving(*builder_, field, nullptr, changes() && may_change(field)))
      made.numbers.push_back(*number);
  });
  return argument == nullptr || argument->numbers.empty() ? nullptr : &argument->numbers.front();
}

void Args::note_point(const Field& field, Argument& argument) {
  const auto point = read_moving_point(*builder_, field, changes());
  if (!point) return;
  if (!changes() && !has_distribution(field.value)) read_.push_back({point->value, &field.value});
  argument.numbers.push_back({point->value.x(), point->x});
  argument.numbers.push_back({point->value.y(), point->y});
}

Vec2 Args::point_now(const Argument& argument, std::size_t i) const {
  if (i + 1 >= argument.numbers.size()) return {0, 0};
  return {plus(*scene_, argument.numbers[i], time_), plus(*scene_, argument.numbers[i + 1], time_)};
}

Vec2 Args::point(const char* key) {
  const Argument* argument =
      noted(key, [&](const Field& field, Argument& made) { note_point(field, made); });
  return argument == nullptr ? Vec2(0, 0) : point_now(*argument, 0);
}

double Args::number(const char* key, double fallback) {
  const Moving* number = kept_number(key);
  return number == nullptr ? fallback : plus(*scene_, *number, time_);
}

std::array<double, 3> Args::channels(const char* key, double fallback) {
  std::array<double, 3> numbers{fallback, fallback, fallback};
  const std::optional<Field> field = find(key);
  if (!field) return numbers;
  if (field->value.kind != Value::Kind::array) {
    numbers.fill(builder_->in.number(*field).value_or(fallback));
  } else if (field->value.items.size() != numbers.size()) {
    builder_->in.mismatch(*field, "a number, or three of them");
  } else {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = builder_->in.number(field->item(i)).value_or(fallback);
  }
  return numbers;
}

Vec2 Args::range(const char* key) {
  const Argument* argument = noted(key, [&](const Field& field, Argument& made) {
    if (field.value.kind == Value::Kind::array) return note_point(field, made);
    if (const auto number = read_moving(*builder_, field)) made.numbers = {*number, *number};
  });
  return argument == nullptr ? Vec2(0, 0) : point_now(*argument, 0);
}

double Args::size(const char* key) {
  const Moving* number = kept_number(key);
  const double size = number == nullptr ? 0 : plus(*scene_, *number, time_);
  vanish(!(size > 0));
  if (builder_ == nullptr || number == nullptr) return size;
  if (number->curve && size < 0)
    problem(key, "goes below 0", "end the curve at 0: nothing is there then");
  else if (!(size <= kFarthest) || (!number->curve && size <= 0))
    problem(key, fmt::format("is {}", source_text(find(key)->value).substr(0, 40)),
            "write a number above 0, at most 1e300");
  return size;
}

std::int64_t Args::integer(const char* key, std::int64_t fallback, std::int64_t low,
                           std::int64_t high) {
  return plain(key, fallback,
               [&](const Field& field) { return builder_->in.integer(field, low, high); });
}

std::string Args::string(const char* key, std::string fallback) {
  const Argument* argument = noted(key, [&](const Field& field, Argument& made) {
    made.text = builder_->in.string(field).value_or(fallback);
  });
  return argument == nullptr ? fallback : argument->text;
}

bool Args::flag(const char* key, bool fallback) {
  return plain(key, fallback, [&](const Field& field) { return builder_->in.flag(field); });
}

std::vector<Vec2> Args::points(const char* key) {
  const Argument* argument = noted(key, [&](const Field& field, Argument& made) {
    if (!builder_->in.is(field, Value::Kind::array, "a list of points")) return;
    if (field.value.items.empty())
      builder_->in.problem(field, "is empty", "write at least one point");
    for (std::size_t i = 0; i < field.value.items.size(); ++i) note_point(field.item(i), made);
  });
  std::vector<Vec2> points;
  for (std::size_t i = 0; argument != nullptr && i < argument->numbers.size(); i += 2)
    points.push_back(point_now(*argument, i));
  return points;
}

Place Args::place(const char* key, std::size_t index) const {
  const Member* member = field_ ? field_->value.find(key) : nullptr;
  if (member == nullptr) return where;
  const std::vector<Value>& items = member->value.items;
  return index < items.size() ? items[index].where : member->value.where;
}

Colour Args::colour(const char* key, const Colour& fallback) {
  const std::optional<Field> field = find(key);
  return field ? builder_->in.colour(*field).value_or(fallback) : fallback;
}

void Args::problem(const char* key, const std::string& message, std::string hint) {
  if (builder_ != nullptr)
    builder_->in.problem(place(key), fmt::format("{}.{} {}", field_->name, key, message),
                         std::move(hint));
}

void Args::warning(const Place& at, std::string message, std::string hint) {
  if (builder_ != nullptr && warns_) builder_->in.warning(at, std::move(message), std::move(hint));
}

void Args::warnings(Diagnostics more) {
  for (Diagnostic& one : more) warning(one.where, std::move(one.message), std::move(one.hint));
}

void Args::check_lost_features() {
  std::vector<std::size_t> order(read_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    const Vec2 &p = read_[a].point, &q = read_[b].point;
    return std::tuple(p.x(), p.y(), a) < std::tuple(q.x(), q.y(), b);
  });
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const ReadPoint &first = read_[order[i]], &second = read_[order[i + 1]];
    if (first.point != second.point || written_the_same(*first.value, *second.value)) continue;
    builder_->in.warning(second.value->where,
                         fmt::format("{} and {} read as the same point", point_text(*first.value),
                                     point_text(*second.value)),
                         "doubles hold about 16 digits: move the shape nearer to 0");
  }
}

}  // namespace flatray
