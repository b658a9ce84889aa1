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
  std::vector<std::string> known;
  for (std::uint32_t i = 0; i < builder.scene.chains.size(); ++i) {
    const MarkovChain& chain = builder.scene.chains[i];
    known.push_back(chain.name);
    if (chain.name != *name) continue;
    words.chain = &chain;
    words.use.chain = i;
    words.use.start = chain.start;
    return;
  }
  builder.in.problems.push_back(unknown_word(field.value.where, "Markov chain", *name, known));
}

void read_start(Builder& builder, const Field& field, MarkovWords& words) {
  const auto name = builder.in.string(field);
  if (!name || words.chain == nullptr) return;
  if (const auto state = find_state(builder, *words.chain, field.value.where, *name))
    words.use.start = *state;
}

void read_hit(Builder& builder, const Field& field, MarkovWords& words) {
  const auto name = builder.in.string(field);
  if (!name || words.chain == nullptr) return;
  words.use.hit = find_state(builder, *words.chain, field.value.where, *name);
}

constexpr Key<MarkovWords> kMarkovKeys[] = {
    {{"chain", "\"CHAIN\"", kRequired}, &read_chain},
    {{"start", "\"STATE\"", "the chain's first row"}, &read_start},
    {{"hit", "\"STATE\"", "none"}, &read_hit},
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
  read_keys<MarkovWords>(builder, field.value, "markov", kMarkovKeys, words);
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
