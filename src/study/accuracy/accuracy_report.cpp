#include "study/accuracy/accuracy_report.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/counted.h"
#include "base/table.h"
#include "study/accuracy/accuracy_page.h"

namespace flatray {
namespace {

std::string missing_words(const ChoiceReport& report) {
  std::string text;
  for (const MissingSetting& one : report.missing)
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", one.words, one.why);
  return text;
}

// Of people: what an error is, or is at most.
JsonValue error_cell(const Outcome& outcome) {
  return outcome.at_most ? fmt::format("<= {:.6g}", outcome.error) : JsonValue(outcome.error);
}

// A part of an error, or that there is none such.
JsonValue part_cell(const std::optional<double>& part) { return cell_or("not defined", part); }

JsonValue half_range_cell(const ChoiceReport& report, const AccuracyPoint& point) {
  return cell_or("unknown", half_range(report, point));
}

// For people, or else for programs: null is what is not known, and there are true and false.
Table points_table(std::span<const ChoiceReport> reports, bool for_people) {
  Table table({"choice", "series", "setting", "n", "seconds", "seconds_half_range", "error",
               "error_half_interval", "at_most", "sampling", "truncation", "discretisation",
               "rounding", "best", "advice"});
  const auto yes_or_no = [=](bool yes) {
    return for_people ? JsonValue(yes ? "yes" : "no") : JsonValue(yes);
  };
  const auto known = [=](JsonValue cell) {
    return for_people || !cell.as_text() ? std::move(cell) : JsonValue();
  };
  for (const ChoiceReport& report : reports)
    for (const AccuracyPoint& point : report.points) {
      const auto parts = error_parts(report, point);
      table.add({report.name, point.series, point.setting, point.n, point.seconds,
                 known(half_range_cell(report, point)), point.outcome.error, point.outcome.half,
                 yes_or_no(point.outcome.at_most), known(part_cell(parts[0])),
                 known(part_cell(parts[1])), known(part_cell(parts[2])), known(part_cell(parts[3])),
                 yes_or_no(point.best), advice(report, point)});
    }
  return table;
}

Table choices_table(std::span<const ChoiceReport> reports) {
  Table table({"choice", "error_of", "unit", "reference", "left_out", "missing", "cut_by_budget",
               "rounds", "reference_seconds", "seconds"});
  for (const ChoiceReport& report : reports)
    table.add({report.name, name(report.kind), report.unit, report.reference, report.left_out,
               missing_words(report), report.cut, report.rounds, report.reference_seconds,
               report.seconds});
  return table;
}

Table orders_table(std::span<const ChoiceReport> reports) {
  Table table({"choice", "series", "grows", "law", "order"});
  for (const ChoiceReport& report : reports)
    for (const FittedOrder& order : report.orders)
      table.add({report.name, order.series, report.grows,
                 order.law == Law::power ? "power" : "exponential", order.slope});
  return table;
}

Table settings_table(const ChoiceReport& report) {
  const std::vector<std::size_t> kinds = kinds_of_error(report);
  std::vector<std::string> columns{"setting", "seconds", "half_range", "error"};
  for (const std::size_t k : kinds) columns.emplace_back(name(static_cast<ErrorKind>(k)));
  columns.insert(columns.end(), {"best", ""});
  Table table(columns);
  for (const AccuracyPoint& point : report.points) {
    Values row{point.setting, point.seconds, half_range_cell(report, point),
               error_cell(point.outcome)};
    for (const std::size_t k : kinds) row.push_back(part_cell(error_parts(report, point)[k]));
    row.emplace_back(point.best ? "*" : "");
    row.emplace_back(advice(report, point));
    table.add(std::move(row));
  }
  return table;
}

std::string summary(std::span<const ChoiceReport> reports) {
  std::string text;
  for (const ChoiceReport& report : reports) {
    text += fmt::format("{}: {}\n", report.name, report.question);
    if (!report.left_out.empty()) {
      text += fmt::format("  left out: {}\n\n", report.left_out);
      continue;
    }
    text += fmt::format("  error: {}, {}; against {}\n", report.unit, name(report.kind),
                        report.reference);
    text += aligned_text(settings_table(report), kBrief);
    for (const FittedOrder& order : report.orders) text += "  " + words(order, report.grows) + "\n";
    for (const std::string& line : remarks(report)) text += "  " + line + "\n";
    text += "\n";
  }
  return text;
}

}  // namespace

std::vector<std::size_t> kinds_of_error(const ChoiceReport& report) {
  std::vector<std::size_t> kinds;
  for (std::size_t k = 0; k < kErrorKinds; ++k)
    if (k == static_cast<std::size_t>(report.kind) ||
        std::ranges::any_of(report.points, [&](const AccuracyPoint& point) {
          return error_parts(report, point)[k].has_value();
        }))
      kinds.push_back(k);
  return kinds;
}

std::optional<double> half_range(const ChoiceReport& report, const AccuracyPoint& point) {
  return report.rounds < 2 ? std::nullopt : std::optional(point.spread);
}

std::vector<std::string> remarks(const ChoiceReport& report) {
  std::vector<std::string> lines;
  const auto words = [](const AccuracyPoint* point) {
    return point == nullptr ? "none" : point->setting;
  };
  if (report.one_question)
    lines.push_back(fmt::format("cheapest under {}: {}; best under {} s: {}", kSmallError,
                                words(cheapest_below(report, kSmallError)), kShortSeconds,
                                words(best_within(report, kShortSeconds))));
  std::string undefined;
  const std::vector<std::size_t> kinds = kinds_of_error(report);
  for (std::size_t k = 0; k < kErrorKinds; ++k)
    if (std::ranges::find(kinds, k) == kinds.end())
      undefined += (undefined.empty() ? "" : ", ") + std::string(name(static_cast<ErrorKind>(k)));
  std::string limited;
  for (const AccuracyPoint& point : report.points)
    if (point.outcome.at_most) limited += (limited.empty() ? "" : ", ") + point.setting;
  if (!limited.empty()) lines.push_back("nearer than the reference tells: " + limited);
  if (!undefined.empty()) lines.push_back("not defined for its error: " + undefined);
  for (const MissingSetting& one : report.missing)
    lines.push_back(fmt::format("not here: {}: {}", one.words, one.why));
  if (!report.cut.empty()) lines.push_back("not within the budget: " + report.cut);
  lines.push_back(fmt::format("{}, {:.3g} s of processor time, {:.3g} s of it for the reference",
                              counted(report.rounds, "round"), report.seconds,
                              report.reference_seconds));
  return lines;
}

Fields accuracy_fields(const std::string& scene, std::span<const ChoiceReport> reports) {
  return {{"scene", scene},
          {"choices", choices_table(reports)},
          {"orders", orders_table(reports)},
          {"points", points_table(reports, false)}};
}

ExperimentResult accuracy_report(const std::string& scene, std::span<const ChoiceReport> reports,
                                 const std::optional<Image>& shown) {
  ExperimentResult result;
  result.files.push_back(csv_file("accuracy", points_table(reports, true)));
  result.files.push_back(json_file("accuracy", accuracy_fields(scene, reports)));
  for (const ChoiceReport& report : reports)
    if (has_plot(report)) result.files.push_back({plot_name(report.name), accuracy_plot(report)});
  result.files.push_back({"accuracy.html", accuracy_page(scene, reports, shown)});
  result.summary = summary(reports);
  return result;
}

}  // namespace flatray
