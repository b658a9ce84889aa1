#include "app/report/report.h"

#include <fmt/core.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <set>

#include "app/help/version.h"
#include "base/counted.h"
#include "base/number_text.h"
#include "base/shown_text.h"

namespace flatray {

int exit_code(const Diagnostics& problems) {
  return problems.empty() ? 0 : static_cast<int>(problems.front().trouble);
}

int report_failure(const Diagnostics& problems, const std::string& undone) {
  // A file that two scenes name, or a scene given twice, has its mistakes told once.
  std::set<std::string> told;
  for (const Diagnostic& one : problems)
    if (const auto [text, is_new] = told.insert(format({one})); is_new)
      std::fputs(text->c_str(), stderr);
  const std::string closing = fmt::format("flatray: {}{}{}", counted(told.size(), "error"),
                                          undone.empty() ? "" : ", ", undone);
  report_note(closing);
  return exit_code(problems);
}

void report_warnings(const Diagnostics& warnings, const Arguments& arguments) {
  std::set<std::string> told;
  for (const Diagnostic& one : *arguments.warnings) told.insert(format(one));
  for (const Diagnostic& one : warnings) {
    if (!told.insert(format(one)).second) continue;
    if (!arguments.has("quiet")) std::fputs(format(one, "warning").c_str(), stderr);
    arguments.warnings->push_back(one);
  }
}

void report_note(const std::string& line) { std::fputs((shown_text(line) + "\n").c_str(), stderr); }

namespace {

Fields as_value(const Arguments& arguments) {
  Fields options;
  for (const auto& [name, given] : arguments.given()) {
    Values values(given.values.begin(), given.values.end());
    options.emplace_back(name, values.empty()       ? JsonValue(true)
                               : values.size() == 1 ? values.front()
                                                    : JsonValue(std::move(values)));
  }
  const std::vector<std::string>& operands = arguments.operands();
  return {{"operands", Values(operands.begin(), operands.end())}, {"options", std::move(options)}};
}

// Written by parts, as the time is taken when the results are.
std::string json_of(const char* verb, const Arguments& arguments, const JsonValue& results,
                    const Fields& of_all) {
  std::string text = json_text(Fields{{"schema", fmt::format("flatray.{}/1", verb)},
                                      {"version", kVersion},
                                      {"args", as_value(arguments)}});
  text.back() = ',';
  text += "\"results\":" + json_text(results) + ',';
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - arguments.read_at();
  Fields rest{{"timing", Fields{{"seconds", time.count()}}},
              {"warnings", as_values(*arguments.warnings)}};
  rest.insert(rest.end(), of_all.begin(), of_all.end());
  text += json_text(rest).substr(1) + "\n";
  return text;
}

bool is_null(const JsonValue& value) { return value.data.index() == 0; }

}  // namespace

void VerbOutput::add(JsonValue result, std::string words) {
  if (is_null(results)) results = Values();
  std::get<Values>(results.data).push_back(std::move(result));
  text.emplace_back(std::move(words));
}

std::string written(const char* verb, const Arguments& arguments, VerbOutput& output) {
  if (arguments.has("json") && (output.table || !is_null(output.results))) {
    if (is_null(output.results)) output.results = *std::move(output.table);
    if (!output.problems.empty()) output.of_all.emplace_back("errors", as_values(output.problems));
    return json_of(verb, arguments, output.results, output.of_all);
  }
  if (output.table && arguments.has("csv")) return csv_text(*output.table);
  if (output.table && output.text.empty()) return aligned_text(*output.table);
  std::string text;
  for (const auto& part : output.text) {
    const auto* table = std::get_if<Table>(&part);
    text += table != nullptr ? aligned_text(*table) : std::get<std::string>(part);
  }
  return text;
}

JsonValue failed_results(const Diagnostics& problems) {
  return Fields{{"errors", as_values(problems)}};
}

std::string point_text(const Vec2& point) {
  return fmt::format("({}, {})", number_text(point.x()), number_text(point.y()));
}

std::string difference_text(const Difference& difference) {
  constexpr std::array<const char*, 4> kChannels = {"red", "green", "blue", "alpha"};
  return fmt::format("worst pixel ({}, {}) {}: {}, expected {}; {} of {} differ{}", difference.x,
                     difference.y, kChannels[static_cast<std::size_t>(difference.channel)],
                     static_cast<float>(difference.actual), static_cast<float>(difference.expected),
                     difference.pixels, counted(difference.of, "pixel"),
                     difference.pixels == 1 ? "s" : "");
}

JsonValue as_value(const Vec2& point) { return Values{point.x(), point.y()}; }

Values as_values(const Diagnostics& diagnostics) {
  Values values;
  for (const auto& [where, message, hint, trouble] : diagnostics) {
    Fields fields;
    if (where) fields.emplace_back("file", where.source->name());
    if (where && !where.source->text().empty()) {
      const SourceText::Position at = where.source->position(where.offset);
      fields.insert(fields.end(), {{"line", at.line}, {"column", at.column}});
    }
    fields.insert(fields.end(), {{"message", message}, {"hint", hint}});
    values.emplace_back(std::move(fields));
  }
  return values;
}

}  // namespace flatray
