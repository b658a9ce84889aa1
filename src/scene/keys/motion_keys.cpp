#include "scene/keys/motion_keys.h"

#include "scene/keys/corner_limit.h"

namespace flatray {
namespace {

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

constexpr NumberRule kDurationRule{&is_above_zero, "is not above 0",
                                   "write the seconds the whole path takes"};

constexpr Key<FollowWords> kFollowKeys[] = {
    {{"path", "[[x, y], ...]", kRequired}, &read_path},
    {{"speed", "number", "none"}, &set<&FollowWords::speed>},
    {{"duration", "seconds", "none"}, &set_number<&FollowWords::duration, kDurationRule>},
    {{"start", "world units", "0"}, &set<&FollowWords::start>},
    {{"closed", "true or false", "false"}, &set<&FollowWords::closed>},
    {{"turn", "true or false", "false"}, &set<&FollowWords::turn>},
};

constexpr double kLongestPath = 1e150;  // squares of lengths stay doubles

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
    const double length = path.lengths.back() + size_of(edge);
    if (!(length > path.lengths.back())) return;
    path.points.push_back(point);
    path.lengths.push_back(length);
  };
  for (const Vec2& point : words.path) add(point);
  if (words.closed && !words.path.empty()) add(words.path.front());
  return path;
}

}  // namespace

void read_follow_path(Builder& builder, const Field& field, Motion& motion) {
  FollowWords words;
  if (!read_keys(builder, field.value, "follow", kFollowKeys, words)) return;
  if (words.speed.has_value() == words.duration.has_value())
    return builder.in.problem(field.value.where, "follow wants either speed or duration",
                              "write one of speed = v and duration = seconds");
  auto [known, added] = builder.fixed_paths.try_emplace(field.value.find("path"));
  if (added || has_distribution(field.value)) {
    Path path = measured(words);
    if (path.points.size() < 2)
      return builder.in.problem(field.value.where, "the path of follow has no length",
                                "write two points or more that differ");
    if (!(path.lengths.back() <= kLongestPath))
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
  return {{"follow", key_infos<FollowWords>(kFollowKeys), true}};
}

}  // namespace flatray
