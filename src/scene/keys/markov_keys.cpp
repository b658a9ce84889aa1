#include "scene/keys/markov_keys.h"

#include "scene/keys/scene_keys.h"

namespace flatray {
namespace {

struct MarkovWords {
  const MarkovChain* chain = nullptr;
  MarkovUse use;
};

void read_chain(Builder& builder, const Field& field, MarkovWords& words) {
  const auto name = builder.in.string(field);
  if (!name) return;
  const std::vector<MarkovChain>& chains = builder.scene.chains;
  const auto found = std::ranges::find(chains, *name, &MarkovChain::name);
  if (found == chains.end())
    return builder.in.problems.push_back(
        unknown_word(field.value.where, "Markov chain", *name, names_of(chains)));
  words.chain = &*found;
  words.use.chain = static_cast<std::uint32_t>(found - chains.begin());
  words.use.start = found->start;
}

template <auto Pointer>
void set_state(Builder& builder, const Field& field, MarkovWords& words) {
  const auto name = builder.in.string(field);
  if (!name || words.chain == nullptr) return;
  if (const auto state = find_state(builder, *words.chain, field.value.where, *name))
    words.use.*Pointer = *state;
}

constexpr Key<MarkovWords> kMarkovKeys[] = {
    {{"chain", "\"CHAIN\"", kRequired}, &read_chain},
    {{"start", "\"STATE\"", "the chain's first row"}, &set_state<&MarkovUse::start>},
    {{"hit", "\"STATE\"", "none"}, &set_state<&MarkovUse::hit>},
};

std::vector<Look> looks_of(const Value& value, const std::string& name, const ReadLook& read) {
  if (value.kind != Value::Kind::array) return {read(value, name)};
  std::vector<Look> looks;
  for (const Value& one : value.items) looks.push_back(read(one, name));
  return looks;
}

}  // namespace

std::optional<MarkovUse> read_markov_use(Builder& builder, const Field& field) {
  MarkovWords words;
  read_keys(builder, field.value, "markov", kMarkovKeys, words);
  if (words.chain == nullptr) return std::nullopt;
  words.use.looks.resize(words.chain->states.size());
  return std::move(words.use);
}

std::vector<KeyInfo> markov_use_keys() { return key_infos<MarkovWords>(kMarkovKeys); }

void read_looks(Builder& builder, const Field& field, std::optional<MarkovUse>& use,
                const ReadLook& read) {
  if (!builder.in.is(field, Value::Kind::table, "a table of states")) return;
  for (const Member& member : field.value.members) {
    std::vector<Look> looks = looks_of(member.value, "state " + member.key, read);
    if (!use) continue;
    const MarkovChain& chain = builder.scene.chains[use->chain];
    if (const auto state = find_state(builder, chain, member.where, member.key))
      use->looks[*state] = std::move(looks);
  }
}

void expect_chain(Builder& builder, const Value& table, const char* name) {
  const Member* states = table.find("states");
  if (states != nullptr && table.find("markov") == nullptr)
    builder.in.problem(states->where, fmt::format("{} has states but no Markov chain", name),
                       R"(add markov = { chain = "CHAIN" })");
}

}  // namespace flatray
