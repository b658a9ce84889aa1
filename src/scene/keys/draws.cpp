#include "scene/keys/draws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/philox.h"
#include "base/portable_math.h"

namespace flatray {

bool is_distribution(const Value& value) {
  if (value.kind != Value::Kind::table || value.members.size() != 1) return false;
  const std::string& key = value.members.front().key;
  return key == "uniform" || key == "normal" || key == "choice";
}

bool has_distribution(const Value& value) {
  return is_distribution(value) || std::ranges::any_of(value.items, &has_distribution) ||
         std::ranges::any_of(value.members,
                             [](const Member& member) { return has_distribution(member.value); });
}

Draws::Draws(std::uint64_t seed, std::uint32_t table, const Value& written)
    : seed_(seed), table_(table) {
  number(written);
}

void Draws::number(const Value& value) {
  if (is_distribution(value)) numbers_.emplace(&value, static_cast<std::uint32_t>(numbers_.size()));
  for (const Value& item : value.items) number(item);
  for (const Member& member : value.members) number(member.value);
}

double Draws::unit(const Value& distribution, bool second) const {
  const std::uint32_t draw = 2 * numbers_.at(&distribution) + (second ? 1 : 0);
  return unit_double(random_bits(seed_, Stream::value, table_, copy_, draw));
}

double Draws::normal(const Value& distribution) const {
  const double radius = std::sqrt(-2 * portable::log(1 - unit(distribution)));
  return radius * portable::cos(2 * std::numbers::pi * unit(distribution, true));
}

std::pair<double, double> Draws::place() const {
  return {unit_double(random_bits(seed_, Stream::scatter, table_, copy_, 0)),
          unit_double(random_bits(seed_, Stream::scatter, table_, copy_, 1))};
}

}  // namespace flatray
