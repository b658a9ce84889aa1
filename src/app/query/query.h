#pragma once
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "app/query/question.h"
#include "geom/hit_interval.h"

namespace flatray {

/// One kind of question. Registered by one file each in app/queries, defining `const Query entry`
/// in namespace flatray::<name>_query.
struct Query {
  const char* name;     ///< as "op" says it
  const char* summary;  ///< one line, no full stop
  /// Reads all its fields, then answers. What it gives where the question has mistakes is not used.
  Fields (*answer)(Question& question);
};

/// Registered queries by name.
std::vector<const Query*> all_queries();

/// An end of an interval: null where there is none, or no interval.
inline JsonValue interval_end(const HitInterval& interval, double t) {
  return interval && std::isfinite(t) ? JsonValue(t) : JsonValue();
}

/// A line of answer, without its end.
struct Answer {
  std::string line;
  bool ok;  ///< false: the line says what was wrong with the question
};

/// Answers one line of JSON: {"id":.., "op":"clip", ..}.
///
/// Gives   the answer's fields after the question's own id, where it has one; {"id":..,"error":..}
///         for what is not a question. Never fails otherwise, whatever the line holds.
Answer answer_line(std::string_view line, const Precision& precision = {});
/// The answer to a line that is longer than `most` bytes.
Answer answer_to_long_line(std::size_t most);

}  // namespace flatray
