#include <numeric>

#include "base/counted.h"
#include "scene/keys/copies.h"
#include "scene/keys/corner_limit.h"
#include "scene/keys/look_keys.h"
#include "scene/keys/motion_keys.h"
#include "scene/keys/scene_keys.h"

namespace flatray {
namespace {

// A mirrored group would turn the outlines of what it holds inside out.
void read_scale(Builder& builder, const Field& field, Group& group) {
  const std::optional<Moving> scale = read_moving(builder, field);
  if (!scale) return;
  if (scale->curve && lowest(builder.scene.curves[*scale->curve]) < 0)
    return builder.in.problem(field, "goes below 0",
                              "end the curve at 0: what is in the group is a point then");
  if (!scale->curve && !(scale->value > 0 && scale->value <= kFarthest))
    return builder.in.problem(field, "is not above 0 and at most 1e300",
                              "write how many times larger what is in it is, 0.5 for half");
  group.scale = *scale;
}

constexpr Key<Group> kGroupKeys[] = {
    {{"name", "\"NAME\"", kRequired}, &set<&Group::name, Group>},
    kGroupKey<Group>,
    kMovingAtKey<Group>,
    kMovingAngleKey<Group>,
    {{"scale", "number or a curve", "1"}, &read_scale},
    kVelocityKey<Group>,
    kAngularVelocityKey<Group>,
    kLayerKey<Group>,
    kFollowKey<Group>,
    kRepeatKey<Group>,
};

// The [[group]] tables and which stands in which, before any copy is made.
class Nesting {
 public:
  Nesting(Builder& builder, const Value& tables) : builder_(builder), tables_(tables) {
    for (std::size_t i = 0; i < size(); ++i) add_name(i);
    for (std::size_t i = 0; i < size(); ++i) parents_.push_back(parent_of(i));
    break_circles();
    for (std::size_t i = 0; i < size(); ++i) depths_.push_back(depth_of(i));
  }

  // Those that stand in others after them.
  std::vector<std::size_t> outer_first() const {
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return depths_[i]; });
    return order;
  }

 private:
  std::size_t size() const { return tables_.items.size(); }
  const Member* name(std::size_t i) const { return tables_.items[i].find("name"); }

  // Known from here on, also where a mistake or a limit leaves it without copies: what stands in it
  // is not a second mistake.
  void add_name(std::size_t i) {
    if (name(i) != nullptr) builder_.groups[name(i)->value.text];
    if (name(i) == nullptr || numbers_.emplace(name(i)->value.text, i).second) return;
    builder_.in.problem(name(i)->value.where,
                        fmt::format("two groups are named '{}'", name(i)->value.text),
                        "give each a name of its own");
  }

  std::optional<std::size_t> parent_of(std::size_t i) const {
    const Member* group = tables_.items[i].find("group");
    if (group == nullptr) return std::nullopt;
    const auto found = numbers_.find(group->value.text);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }

  // Walks outward from each; a walk that comes to its own trace has found a circle.
  void break_circles() {
    std::vector<std::size_t> walked(size(), size());
    for (std::size_t i = 0; i < size(); ++i) {
      std::size_t at = i;
      while (walked[at] == size()) {
        walked[at] = i;
        if (!parents_[at]) break;
        if (walked[*parents_[at]] == i) {
          builder_.in.problem(tables_.items[at].find("group")->value.where,
                              fmt::format("group {} stands in itself{}", name_of(at), way(at)),
                              "break the circle");
          parents_[at].reset();
          break;
        }
        at = *parents_[at];
      }
    }
  }

  // Names from a group outward, until it comes round.
  std::string way(std::size_t from) const {
    std::string text = ": " + name_of(from);
    std::size_t at = *parents_[from];
    for (std::size_t shown = 0; shown < kShownNames && at != from; ++shown, at = *parents_[at])
      text += " in " + name_of(at);
    return text + (at == from ? " in " + name_of(from) : " in ...");
  }

  // Number of groups it stands in.
  std::size_t depth_of(std::size_t i) {
    std::size_t depth = 0;
    for (std::optional<std::size_t> at = parents_[i]; at; at = parents_[*at]) {
      if (++depth <= builder_.limits.max_depth) continue;
      if (!too_deep_)
        builder_.in.problem(
            tables_.items[i].find("group")->value.where,
            fmt::format("group {} stands in more than {}", name_of(i), counted(depth - 1, "group")),
            fmt::format("the limit is {}; --max-depth raises it", builder_.limits.max_depth));
      too_deep_ = true;
      parents_[i].reset();
    }
    return depth;
  }

  std::string name_of(std::size_t i) const {
    return fmt::format("'{}'", name(i) == nullptr ? "" : name(i)->value.text.substr(0, 64));
  }

  static constexpr std::size_t kShownNames = 8;

  Builder& builder_;
  const Value& tables_;
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::optional<std::size_t>> parents_;
  std::vector<std::size_t> depths_;
  bool too_deep_ = false;  // told
};

// How many times larger what is in a group is, by all it stands in; of curves the largest.
double whole_scale(const Scene& scene, const Group& group) {
  double scale = highest(scene, group.scale);
  for (auto outer = group.group; outer; outer = scene.groups[*outer].group)
    scale *= highest(scene, scene.groups[*outer].scale);
  return scale;
}

void read_group(Builder& builder, const Value& table, std::uint32_t number) {
  constexpr std::uint32_t kGroupTables = std::uint32_t{1} << 31;
  Scene& scene = builder.scene;
  bool too_far = false;  // told
  const auto add = [&](Group&& group, std::uint64_t, std::string suffix) {
    if (!take_corners(builder, corner_count(group.name), table.where)) return;
    const double scale = whole_scale(scene, group);
    if (const Member* own = table.find("scale");
        own != nullptr && !too_far &&
        !((scale >= 1 / kFarthest || group.scale.curve) && scale <= kFarthest)) {
      too_far = true;
      builder.in.problem(
          own->value.where,
          fmt::format("scale, times those of the groups this one stands in, is {}", scale),
          "keep the product between 1e-300 and 1e300");
    }
    if (group.group) group.layer += scene.groups[*group.group].layer;
    const Member* base = table.find("name");
    builder.groups[base == nullptr ? "" : base->value.text].push_back(
        static_cast<std::uint32_t>(scene.groups.size()));
    builder.group_suffixes.push_back(std::move(suffix));
    scene.groups.push_back(std::move(group));
  };
  make_copies<Group>(builder, table, {"group", kGroupTables + number, scene.groups.size()},
                     kGroupKeys, add);
}

}  // namespace

void read_groups(Builder& builder, const Field& field, Scene&) {
  const std::size_t problems = builder.in.problems.size();
  each_table(builder, field, [&](const Value& table) {
    builder.in.is({"group", table, "{ ... }"}, Value::Kind::table, "a table");
  });
  if (builder.in.problems.size() > problems) return;
  for (const std::size_t i : Nesting(builder, field.value).outer_first())
    read_group(builder, field.value.items[i], static_cast<std::uint32_t>(i));
}

std::vector<TableInfo> group_tables() { return {{"group", key_infos<Group>(kGroupKeys), true}}; }

}  // namespace flatray
