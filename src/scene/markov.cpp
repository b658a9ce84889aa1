#include "scene/markov.h"

#include "base/counted.h"
#include "scene/keys/keys.h"
#include "scene/keys/scene_keys.h"
#include "scene/reading/numbers.h"

namespace flatray {
namespace {

constexpr std::size_t kMaxChains = 100, kMaxStates = 500;
constexpr std::int64_t kMaxHold = 1'000'000'000;
constexpr Word<ChainRepair> kRepairs[] = {{"to-start", ChainRepair::to_start},
                                          {"to-self", ChainRepair::to_self},
                                          {"scaled", ChainRepair::scaled}};

struct ChainSettings {
  unsigned hold = 1;
  ChainRepair repair = ChainRepair::none;
};

constexpr Key<ChainSettings> kChainKeys[] = {
    {{"hold", "frames", "1"}, &set_integer<&ChainSettings::hold, 1, kMaxHold>},
    {{"repair", R"("to-start", "to-self" or "scaled")", "none"},
     &set_word<&ChainSettings::repair, kRepairs>},
};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

bool is_state_name(std::string_view key) {
  const auto is_tail = [](char c) { return is_upper(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !key.empty() && is_upper(key.front()) && std::ranges::all_of(key, is_tail);
}

std::string upper_case(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

// x - 1 of a whole number from 1 to 2^64.
std::uint64_t less_one(const Rational& x) {
  const Rational high = (x / 0x1p32).floor();
  const double low = (x - high * 0x1p32).nearest();
  return (static_cast<std::uint64_t>(high.nearest()) << 32) + static_cast<std::uint64_t>(low) - 1;
}

// One chain while its rows are read.
struct ChainReader {
  Builder& builder;
  MarkovChain chain;
  ChainSettings settings;
  std::vector<const Member*> rows;

  Reader& in() { return builder.in; }

  void split(const Value& table) {
    Value lower = table_value(table.where, {});
    for (const Member& member : table.members) {
      if (is_state_name(member.key)) {
        rows.push_back(&member);
        chain.states.push_back(member.key);
      } else if (std::ranges::any_of(member.key, is_upper)) {
        in().problem(member.where,
                     fmt::format("'{}' is not a name of a state", member.key.substr(0, 64)),
                     "states are upper case: " + upper_case(member.key.substr(0, 64)));
      } else {
        lower.members.push_back(member);
      }
    }
    read_keys(builder, lower, "markov." + chain.name, kChainKeys, settings);
  }

  std::optional<Rational> probability(const Field& field) {
    const auto value = in().number(field);
    if (!value) return std::nullopt;
    const auto decimal = *value == 0 ? Decimal{} : parse_decimal(source_text(field.value));
    const bool near = *value >= 0 && *value <= 1;
    Rational exact = decimal && near ? to_rational(*decimal) : Rational(*value);
    if (exact >= Rational(0) && exact <= Rational(1)) return exact;
    return in().refuse(
        {field.value.where,
         fmt::format("probability {} is {}", field.name, source_text(field.value).substr(0, 40)),
         "it must lie between 0 and 1"});
  }

  std::optional<ChainRow> row(const Member& member) {
    const Field field{member.key, member.value, "{ STATE = probability, ... }"};
    if (!in().is(field, Value::Kind::table, "a table")) return std::nullopt;
    const std::size_t problems = in().problems.size();
    ChainRow steps;
    for (const Member& step : member.value.members) {
      const auto to = target(step);
      const auto p = probability({member.key + "." + step.key, step.value, "0.5"});
      if (to && p) steps.push_back({*to, *p});
    }
    if (in().problems.size() > problems) return std::nullopt;
    return steps;
  }

  // A state that is only mentioned has no way on, and that must be said.
  std::optional<StateId> target(const Member& step) {
    const auto found = std::ranges::find(chain.states, step.key);
    if (found != chain.states.end()) return static_cast<StateId>(found - chain.states.begin());
    // Single letters are all near to each other.
    const std::string near = step.key.size() > 1 ? nearest_word(step.key, chain.states) : "";
    std::string message = fmt::format("state '{}' has no row", step.key.substr(0, 64));
    if (!near.empty()) message += fmt::format(" (did you mean '{}'?)", near);
    return in().refuse(
        {step.where, std::move(message),
         fmt::format("if it ends there, write {0} = {{ {0} = 1 }}", step.key.substr(0, 64))});
  }

  void check_sum(const Member& member, const ChainRow& steps) {
    const Rational sum = total_probability(steps), rest = Rational(1) - sum;
    const bool missing = rest.sign() == Sign::positive, some = sum.sign() == Sign::positive;
    in().problem(
        member.where, fmt::format("transitions out of {} sum to {}", member.key, decimal_text(sum)),
        fmt::format("they must sum to 1: {}, or say repair = {}",
                    missing ? "add " + decimal_text(rest) : "take " + decimal_text(-rest) + " away",
                    !some     ? R"("to-start" or "to-self")"
                    : missing ? R"("to-start", "to-self" or "scaled")"
                              : "\"scaled\""));
  }

  void add(StateId self, ChainRow steps) {
    if (total_probability(steps) != Rational(1) &&
        !repair_row(steps, settings.repair, self, chain.start))
      return check_sum(*rows[self], steps);
    chain.rows.push_back(cumulative_row(steps));
    const auto possible = std::ranges::count_if(
        steps, [](const ChainStep& step) { return step.probability.sign() == Sign::positive; });
    if (static_cast<std::size_t>(possible) > chain.rows.back().size())
      in().warning(rows[self]->where,
                   fmt::format("{} has steps that are never taken", rows[self]->key),
                   "draws have 64 bits: probabilities below 2^-64 are lost");
    std::vector<double>& doubles = chain.probabilities.emplace_back(chain.states.size(), 0.0);
    std::vector<std::string>& texts = chain.fractions.emplace_back(chain.states.size(), "0");
    for (const ChainStep& step : steps) {
      doubles[step.to] = step.probability.nearest();
      texts[step.to] = step.probability.text();
    }
  }

  void read(const Value& table) {
    split(table);
    if (rows.empty())
      in().problem(table.where, fmt::format("chain '{}' has no states", chain.name),
                   "write STATE = { STATE = 1 }, states in upper case");
    if (rows.size() > kMaxStates)
      return in().problem(table.where,
                          fmt::format("chain '{}' has {} states", chain.name, rows.size()),
                          fmt::format("at most {}", kMaxStates));
    chain.hold = settings.hold;
    for (StateId self = 0; self < rows.size(); ++self)
      if (auto steps = row(*rows[self])) add(self, std::move(*steps));
  }
};

}  // namespace

Rational total_probability(std::span<const ChainStep> row) {
  Rational sum = 0;
  for (const ChainStep& step : row) sum += step.probability;
  return sum;
}

bool repair_row(ChainRow& row, ChainRepair repair, StateId self, StateId start) {
  const Rational sum = total_probability(row), rest = Rational(1) - sum;
  if (repair == ChainRepair::none) return false;
  if (repair == ChainRepair::scaled) {
    if (sum.sign() != Sign::positive) return false;
    for (ChainStep& step : row) step.probability /= sum;
    return true;
  }
  if (rest.sign() != Sign::positive) return false;
  const StateId to = repair == ChainRepair::to_self ? self : start;
  const auto known =
      std::ranges::find_if(row, [&](const ChainStep& step) { return step.to == to; });
  if (known != row.end())
    known->probability += rest;
  else
    row.push_back({to, rest});
  return true;
}

std::vector<Transition> cumulative_row(std::span<const ChainStep> row) {
  std::vector<Transition> transitions;
  Rational sum = 0, draws = 0;
  for (const ChainStep& step : row) {
    sum += step.probability;
    const Rational reached = (sum * Rational(0x1p64) + Rational(0.5)).floor();
    if (reached != draws) transitions.push_back({less_one(reached), step.to});
    draws = reached;
  }
  return transitions;
}

std::optional<StateId> find_state(Builder& builder, const MarkovChain& chain, const Place& where,
                                  const std::string& name) {
  const auto found = std::ranges::find(chain.states, name);
  if (found != chain.states.end()) return static_cast<StateId>(found - chain.states.begin());
  return builder.in.refuse(
      unknown_word(where, "state of chain '" + chain.name + "':", name, chain.states));
}

void read_chains(Builder& builder, const Field& field, Scene& scene) {
  if (!builder.in.is(field, Value::Kind::table, "a table of chains")) return;
  if (field.value.members.size() > kMaxChains)
    return builder.in.problem(field.value.where,
                              counted(field.value.members.size(), "Markov chain"),
                              fmt::format("at most {}", kMaxChains));
  for (const Member& member : field.value.members) {
    if (!builder.in.is({"markov." + member.key, member.value, "{ STATE = { ... } }"},
                       Value::Kind::table, "a chain"))
      continue;
    ChainReader reader{builder, {}, {}, {}};
    reader.chain.name = member.key;
    reader.read(member.value);
    scene.chains.push_back(std::move(reader.chain));
  }
}

std::vector<TableInfo> markov_tables() {
  std::vector<KeyInfo> keys = key_infos<ChainSettings>(kChainKeys);
  keys.push_back({"STATE", "{ STATE = probability, ... }", kRequired});
  return {{"markov.NAME", std::move(keys)}};
}

}  // namespace flatray
