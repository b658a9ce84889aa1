// The three forms of a hit report.
#include <fmt/core.h>

#include <memory>

#include "app/answers/hit_report.h"
#include "app/report/report.h"
#include "base/number_text.h"
#include "base/shown_text.h"

namespace flatray {
namespace {

std::string with_fraction(double value, const std::string& fraction) {
  return fraction.empty() ? number_text(value) : fraction + " = " + number_text(value);
}

JsonValue edge_value(int edge) { return edge == kNoEdge ? JsonValue() : JsonValue(edge); }

std::string range_text(const Range& range) {
  return fmt::format("[{}, {}]", number_text(range.low), number_text(range.high));
}

Table step_table(const HitReport& report) {
  Table table({"edge", "numerator", "denominator", "t", "kind", "candidate"});
  for (const HitStep& step : report.steps)
    table.add({step.edge ? JsonValue(*step.edge) : "cut", step.numerator, step.denominator,
               step.t ? with_fraction(*step.t, step.exact_t) : "-", step.kind,
               step.empty ? "empty" : range_text(step.candidate)});
  return table;
}

std::string end_text(const char* what, const char* not_by, int edge, const Ray& ray, double t) {
  if (edge == kNoEdge) return fmt::format("{} at t = {}", not_by, number_text(t));
  const Vec2 point = ray.origin + t * ray.direction;
  return fmt::format("{} by edge {} at {}", what, edge, point_text(point));
}

std::string verdict_text(const HitReport& report) {
  const HitInterval& hit = report.hit;
  if (!hit) return fmt::format("  {}, starts {}\n", name(hit.kind), name(hit.start));
  std::string text = fmt::format("  {}: t from {} to {}\n", name(hit.kind),
                                 with_fraction(hit.t_enter, report.exact_enter),
                                 with_fraction(hit.t_exit, report.exact_exit));
  text += fmt::format("  {}, {}, starts {}\n",
                      end_text("enters", "begins", hit.edge_enter, report.ray.ray, hit.t_enter),
                      end_text("leaves", "ends", hit.edge_exit, report.ray.ray, hit.t_exit),
                      name(hit.start));
  if (hit.enter_overflows || hit.exit_overflows)
    text += "  an end lies beyond the doubles; the largest is shown\n";
  return text;
}

Fields step_fields(const HitStep& step) {
  return {
      {"edge", step.edge},
      {"numerator", step.numerator},
      {"denominator", step.denominator},
      {"t", step.t},
      {"t_exact", step.exact_t},
      {"kind", step.kind},
      {"candidate", step.empty ? JsonValue() : Values{step.candidate.low, step.candidate.high}}};
}

// One for each edge, or for what has none.
void add_rows(const HitReport& report, const std::vector<std::string>& columns,
              const Table::EachRow& each) {
  const JsonValue of_report = as_value(report);
  const auto add = [&](const JsonValue& of_step) {
    Values row;
    for (const std::string& column : columns) {
      const JsonValue *a = of_step.find(column), *b = of_report.find(column);
      row.push_back(a != nullptr ? *a : b != nullptr ? *b : JsonValue());
    }
    each(row);
  };
  for (const HitStep& step : report.steps) {
    Fields fields = step_fields(step);
    if (!step.edge) fields.front().second = "cut";
    if (!step.empty)
      fields.insert(fields.end(), {{"candidate_enter", step.candidate.low},
                                   {"candidate_exit", step.candidate.high}});
    add(std::move(fields));
  }
  if (report.steps.empty()) add({});
}

}  // namespace

std::string text_of(const HitReport& report) {
  const Ray& ray = report.ray.ray;
  std::string text = fmt::format(
      "{}: {} + t {}, t in {}, against {}\n", shown_text(report.ray.name), point_text(ray.origin),
      point_text(ray.direction), range_text(report.within), shown_text(report.against));
  if (!report.steps.empty()) text += aligned_text(step_table(report), {"  "});
  return text + verdict_text(report);
}

// Of the fields of --json those called as the columns; edges and candidates are told otherwise.
Table csv_rows(std::vector<HitReport> reports) {
  Table table({"ray", "against", "edge", "numerator", "denominator", "t", "kind", "candidate_enter",
               "candidate_exit", "class", "t_enter", "t_exit", "edge_enter", "edge_exit", "start"});
  table.made = [columns = table.columns, all = std::make_shared<const std::vector<HitReport>>(
                                             std::move(reports))](const Table::EachRow& each) {
    for (const HitReport& report : *all) add_rows(report, columns, each);
  };
  return table;
}

JsonValue as_value(const HitReport& report) {
  const Ray& ray = report.ray.ray;
  Values steps;
  for (const HitStep& step : report.steps) steps.push_back(step_fields(step));
  const HitInterval& hit = report.hit;
  return Fields{{"ray", report.ray.name},
                {"origin", as_value(ray.origin)},
                {"direction", as_value(ray.direction)},
                {"within", Values{report.within.low, report.within.high}},
                {"against", report.against},
                {"steps", std::move(steps)},
                {"class", name(hit.kind)},
                {"t_enter", hit ? JsonValue(hit.t_enter) : JsonValue()},
                {"t_exit", hit ? JsonValue(hit.t_exit) : JsonValue()},
                {"t_enter_exact", report.exact_enter},
                {"t_exit_exact", report.exact_exit},
                {"edge_enter", edge_value(hit.edge_enter)},
                {"edge_exit", edge_value(hit.edge_exit)},
                {"start", name(hit.start)}};
}

Values primitives_hit(const std::vector<HitReport>& reports) {
  const auto same = [](const NamedRay& a, const NamedRay& b) {
    return a.name == b.name && a.ray.origin == b.ray.origin && a.ray.direction == b.ray.direction;
  };
  Values rays;
  for (std::size_t i = 0; i < reports.size();) {
    const NamedRay& ray = reports[i].ray;
    std::uint64_t tested = 0, edges = 0, hit = 0;
    for (; i < reports.size() && same(reports[i].ray, ray); ++i, ++tested) {
      edges += reports[i].steps.size();
      if (reports[i].hit) ++hit;
    }
    rays.push_back(Fields{{"ray", ray.name},
                          {"tested", tested},
                          {"edges_tested", edges},
                          {"hit", hit},
                          {"hit_share", static_cast<double>(hit) / static_cast<double>(tested)}});
  }
  return rays;
}

}  // namespace flatray
