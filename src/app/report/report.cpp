#include "app/report/report.h"

#include <fmt/core.h>

#include <chrono>
#include <cstdio>

#include "app/help/version.h"
#include "base/counted.h"
#include "base/number_text.h"
#include "base/shown_text.h"

namespace flatray {

int exit_code(const Diagnostics& problems) {
  if (problems.empty()) return 0;
  switch (problems.front().trouble) {
    case Trouble::usage:
      return 2;
    case Trouble::missing:
      return 3;
    case Trouble::invalid:
      return 4;
    case Trouble::unavailable:
      return 5;
    case Trouble::output:
      return 6;
  }
  return 70;
}

int report_failure(const Diagnostics& problems, const std::string& undone) {
  const std::string closing = fmt::format("flatray: {}{}{}", counted(problems.size(), "error"),
                                          undone.empty() ? "" : ", ", undone);
  std::fputs(format(problems).c_str(), stderr);
  report_note(closing);
  return exit_code(problems);
}

void report_warnings(const Diagnostics& warnings, const Arguments& arguments) {
  if (!arguments.has("quiet")) std::fputs(format(warnings, "warning").c_str(), stderr);
}

void report_note(const std::string& line) { std::fputs((shown_text(line) + "\n").c_str(), stderr); }

std::string json_report(const char* verb, const Arguments& arguments, JsonValue results,
                        Fields of_all) {
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - arguments.read_at();
  Fields options;
  for (const auto& [name, given] : arguments.given()) {
    Values values(given.values.begin(), given.values.end());
    options.emplace_back(name, values.empty()       ? JsonValue(true)
                               : values.size() == 1 ? values.front()
                                                    : JsonValue(std::move(values)));
  }
  const std::vector<std::string>& operands = arguments.operands();
  Fields report{{"schema", fmt::format("flatray.{}/1", verb)},
                {"version", kVersion},
                {"args", Fields{{"operands", Values(operands.begin(), operands.end())},
                                {"options", std::move(options)}}},
                {"results", JsonValue()},
                {"timing", Fields{{"seconds", time.count()}}}};
  report[3].second = std::move(results);  // lists copy what they begin with
  std::move(of_all.begin(), of_all.end(), std::back_inserter(report));
  return json_text(report) + "\n";
}

std::string point_text(const Vec2& point) {
  return fmt::format("({}, {})", number_text(point.x()), number_text(point.y()));
}

JsonValue as_value(const Diagnostic& diagnostic) {
  Fields fields;
  if (diagnostic.where) {
    const SourceText& source = *diagnostic.where.source;
    fields.emplace_back("file", source.name());
    if (!source.text().empty()) {
      const SourceText::Position at = source.position(diagnostic.where.offset);
      fields.emplace_back("line", at.line);
      fields.emplace_back("column", at.column);
    }
  }
  fields.emplace_back("message", diagnostic.message);
  fields.emplace_back("hint", diagnostic.hint);
  return fields;
}

}  // namespace flatray
