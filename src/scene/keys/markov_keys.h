#pragma once
#include <functional>

#include "scene/keys/keys.h"

namespace flatray {

/// Reads `{ chain = "CHAIN", start = "STATE" }`.
std::optional<MarkovUse> read_markov_use(Builder& builder, const Field& field);
std::vector<KeyInfo> markov_use_keys();

/// Reads `{ STATE = { ... } or [{ ... }, ...] }` into `use`, each look by `read(table, its name)`.
using ReadLook = std::function<Look(const Value& table, const std::string& name)>;
void read_looks(Builder& builder, const Field& field, std::optional<MarkovUse>& use,
                const ReadLook& read);

/// A table that has states has a chain.
void expect_chain(Builder& builder, const Value& table, const char* name);

/// Keys of what goes through the states of a chain: entities and lamps. That of the states comes
/// after that of the chain.
template <class T>
void set_markov(Builder& builder, const Field& field, T& thing) {
  thing.markov = read_markov_use(builder, field);
}
template <class T>
inline constexpr Key<T> kMarkovKey = {{"markov", R"({ chain = "CHAIN", start = "STATE" })", "none"},
                                      &set_markov<T>};
template <class T>
constexpr Key<T> states_key(void (*read)(Builder&, const Field&, T&)) {
  return {{"states", "{ STATE = { ... } or [{ ... }, ...] }", "{}"}, read};
}

}  // namespace flatray
