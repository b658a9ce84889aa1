#include <fmt/core.h>

#include "app/answers/hit_report.h"
#include "base/counted.h"
#include "base/number_text.h"
#include "base/shown_text.h"

namespace flatray {
namespace {

IntervalSet inside(const std::vector<HitReport>& reports) {
  std::vector<Range> parts;
  for (const HitReport& report : reports)
    if (report.hit) parts.push_back({report.hit.t_enter, report.hit.t_exit});
  return interval_set(std::move(parts));
}

// World units; 0 of a point test, whose t may be any.
double length_of(const HitSet& set) {
  const double unit = set.ray.ray.direction.stableNorm();
  return unit > 0 ? unit * length_of(set.parts) : 0;
}

}  // namespace

HitSet combine(const NamedRay& ray, HitOperation operation,
               const std::vector<std::vector<HitReport>>& by_entity) {
  HitSet set{ray, inside(by_entity.front())};
  for (std::size_t i = 1; i < by_entity.size(); ++i)
    set.parts = operation(set.parts, inside(by_entity[i]));
  return set;
}

std::string text_of(const HitSet& set) {
  if (set.parts.empty()) return shown_text(set.ray.name) + ": no part\n";
  std::string text = fmt::format("{}: {}, length {}\n", shown_text(set.ray.name),
                                 counted(set.parts.size(), "part"), number_text(length_of(set)));
  for (const Range& part : set.parts)
    text += fmt::format("  t from {} to {}\n", number_text(part.low), number_text(part.high));
  return text;
}

Table csv_rows(const std::vector<HitSet>& sets) {
  Table table({"ray", "part", "t_enter", "t_exit"});
  for (const HitSet& set : sets)
    for (std::size_t i = 0; i < set.parts.size(); ++i)
      table.add({set.ray.name, std::uint64_t{i}, set.parts[i].low, set.parts[i].high});
  return table;
}

JsonValue as_value(const HitSet& set) {
  Values parts;
  for (const Range& part : set.parts) parts.push_back(Values{part.low, part.high});
  return Fields{{"ray", set.ray.name}, {"parts", std::move(parts)}, {"length", length_of(set)}};
}

}  // namespace flatray
