#include <fmt/core.h>

#include "app/options/arguments.h"
#include "app/query/query.h"
#include "base/diagnostic.h"

namespace flatray {

#include "queries.inc"  // all_queries()

namespace {

Answer as_line(const JsonValue* id, Fields fields, bool ok) {
  if (id != nullptr) fields.insert(fields.begin(), {"id", *id});
  return {json_text(fields), ok};
}

Answer mistake(const JsonValue* id, std::string what) {
  return as_line(id, {{"error", std::move(what)}}, false);
}

std::string unknown_op(const std::string& op) {
  const std::vector<std::string> known = names_of(all_queries());
  return fmt::format("op: there is no '{}'{}; there are {}", op, did_you_mean(op, known),
                     comma_list(known));
}

}  // namespace

Answer answer_to_long_line(std::size_t most) {
  return mistake(nullptr, fmt::format("a line holds {} bytes at most", most));
}

Answer answer_line(std::string_view line, const Precision& precision) {
  const auto json = read_json(line);
  if (!json)
    return mistake(nullptr, fmt::format("column {}: {}", json.error().byte, json.error().what));
  if (!std::holds_alternative<Fields>(json->data))
    return mistake(nullptr, "column 1: a question is an object: {\"op\": ..}");
  const JsonValue* id = json->find("id");
  const JsonValue* op = json->find("op");
  if (op == nullptr) return mistake(id, "op: is missing");
  const auto name = op->as_text();
  if (!name) return mistake(id, "op: is not text");
  for (const Query* query : all_queries()) {
    if (*name != query->name) continue;
    Question question(*json, precision);
    Fields answer = query->answer(question);
    if (std::string what = question.mistakes(); !what.empty()) return mistake(id, std::move(what));
    return as_line(id, std::move(answer), true);
  }
  return mistake(id, unknown_op(shortened(*name)));
}

}  // namespace flatray
