#include "study/accuracy_report.h"

#include <fmt/core.h>

#include <algorithm>

#include "study/accuracy_page.h"
#include "study/table.h"

namespace flatray {
namespace {

constexpr double kSmall = 1e-3, kShort = 1;  // error and seconds that advice is about

Table points_table(std::span<const ChoiceReport> reports) {
  Table table({"choice", "setting", "n", "seconds", "seconds_half_range", "error",
               "error_half_interval", "best"});
  for (const ChoiceReport& report : reports)
    for (const AccuracyPoint& point : report.points)
      table.add({report.name, point.setting, point.n, point.seconds, point.spread,
                 point.outcome.error, point.outcome.half, std::string(point.best ? "yes" : "no")});
  return table;
}

Table choices_table(std::span<const ChoiceReport> reports) {
  Table table({"choice", "error_of", "unit", "reference", "order", "order_standard_error",
               "left_out", "cut_by_budget"});
  for (const ChoiceReport& report : reports) {
    const auto order = [&](double FittedOrder::*part) {
      return report.order ? Cell(*report.order.*part) : Cell(std::string());
    };
    table.add({report.name, std::string(name(report.kind)), report.unit, report.reference,
               order(&FittedOrder::slope), order(&FittedOrder::standard_error), report.left_out,
               report.cut});
  }
  return table;
}

// What a person asks first.
std::string advice(const ChoiceReport& report) {
  const AccuracyPoint *cheap = nullptr, *near = nullptr;
  for (const AccuracyPoint& point : report.points) {
    if (!point.best) continue;
    if (point.outcome.error < kSmall && (cheap == nullptr || point.seconds < cheap->seconds))
      cheap = &point;
    if (point.seconds < kShort && (near == nullptr || point.outcome.error < near->outcome.error))
      near = &point;
  }
  const auto words = [](const AccuracyPoint* point) {
    return point == nullptr ? "none" : point->setting;
  };
  return fmt::format("cheapest below {}: {}; best below {} s: {}", kSmall, words(cheap), kShort,
                     words(near));
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
    Table table({"setting", "seconds", "error", "best"});
    for (const AccuracyPoint& point : report.points)
      table.add(
          {point.setting, point.seconds, point.outcome.error, std::string(point.best ? "*" : "")});
    text += table.text();
    if (report.order)
      text += fmt::format("  error ~ ({})^{:.2f} +- {:.2f}\n", report.grows, report.order->slope,
                          report.order->standard_error);
    if (report.one_question) text += "  " + advice(report) + "\n";
    if (!report.cut.empty()) text += "  not within the budget: " + report.cut + "\n";
    text += "\n";
  }
  return text;
}

}  // namespace

ExperimentResult accuracy_report(const std::string& scene, std::span<const ChoiceReport> reports) {
  ExperimentResult result;
  const Table points = points_table(reports), choices = choices_table(reports);
  result.files.push_back({"accuracy.csv", points.csv()});
  result.files.push_back(
      {"accuracy.json",
       json_document({{"scene", scene}}, {{"choices", &choices}, {"points", &points}})});
  for (const ChoiceReport& report : reports)
    if (!report.points.empty())
      result.files.push_back({fmt::format("accuracy_{}.svg", report.name), accuracy_plot(report)});
  result.files.push_back({"accuracy.html", accuracy_page(scene, reports)});
  result.summary = summary(reports);
  return result;
}

}  // namespace flatray
