#pragma once
#include "scene/keys/keys.h"
#include "scene/responses.h"

namespace flatray {

/// The keys by which an entity says what it does where it meets another.
template <class T>
constexpr Key<T> response_key(const char* fallback) {
  return {{"response", R"("none", "mark", "stop", "bounce", "slide" or "remove")", fallback},
          &set_word<&T::response, kResponses>};
}
void read_mass(Builder& builder, const Field& field, Entity& entity);

/// Refuses an entity that is to respond to contact and cannot.
void refuse_hindered(Builder& builder, const Entity& entity, const Value& table);

}  // namespace flatray
