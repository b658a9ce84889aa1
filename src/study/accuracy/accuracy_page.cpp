#include "study/accuracy/accuracy_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "study/accuracy/accuracy_report.h"
#include "study/plots/plot.h"
#include "study/plots/plot_axes.h"

namespace flatray {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>{0}: error against run time</title>
<style>
:root {{ color-scheme: light dark; --ink: #1a1a1a; --paper: #fff; --line: #767676; --best: #e8f0ff; }}
@media (prefers-color-scheme: dark) {{ :root {{ --ink: #eee; --paper: #16181c; --line: #8a8a8a; --best: #22324d; }} }}
body {{ font: 16px/1.5 sans-serif; color: var(--ink); background: var(--paper); margin: 0 auto; padding: 1rem; max-width: 72rem; }}
.wide {{ overflow-x: auto; }}
table {{ border-collapse: collapse; }}
th, td {{ border-bottom: 1px solid var(--line); padding: .2rem .8rem .2rem 0; text-align: right; white-space: nowrap; }}
th:first-child, td:first-child {{ text-align: left; }}
tr.best {{ background: var(--best); }}
a {{ color: inherit; }}
summary {{ cursor: pointer; padding: .3rem 0; }}
:focus-visible {{ outline: 3px solid #2a6fdb; outline-offset: 2px; }}
figure {{ margin: 1rem 0; }}
svg, img {{ max-width: 100%; height: auto; }}
svg {{ width: 44rem; }}
img {{ min-width: min(100%, 20rem); image-rendering: pixelated; vertical-align: top; margin: 0 .5rem .5rem 0; }}
</style>
</head>
<body>
<main>
<h1>{0}: error against run time</h1>
<p>Seconds are processor time: the median of rounds in turn, &plusmn; half of their range. Marked rows are best: no other setting of the choice is both as
fast and as near. Points without any error are in the tables, not in the plots, whose axes are logarithms. Bars are intervals: of errors those that
hold them in 95 % of all runs, of seconds the range of the rounds.</p>
)";

// What links to the picture of a point, and names it.
std::string picture_id(const ChoiceReport& report, const AccuracyPoint& point) {
  return fmt::format("{}-{}", report.name, &point - report.points.data() + 1);
}

std::string image(const Image& picture, const std::string& words, const std::string& id = {}) {
  return fmt::format("<img{} alt=\"{}\" width=\"{}\" height=\"{}\" src=\"{}\">",
                     id.empty() ? "" : " id=\"" + id + "\"", svg_text(words), picture.width,
                     picture.height, data_address(picture));
}

// A link to what is inside opens it.
std::string picture(const ChoiceReport& report, const AccuracyPoint& point) {
  const auto& [picture, difference] = std::tie(point.outcome.picture, point.outcome.difference);
  if (!picture) return "";
  std::string text = fmt::format(
      "<details><summary>{}{}</summary>{}", svg_text(point.setting),
      difference ? fmt::format(", and what it is off, &times; {}", kDifferenceGain) : "",
      image(*picture, "the picture by " + point.setting, picture_id(report, point)));
  if (difference)
    text += "\n" + image(*difference, fmt::format("its difference from the reference, times {}",
                                                  kDifferenceGain));
  return text + "</details>\n";
}

std::string rows(const ChoiceReport& report, const std::vector<std::size_t>& kinds) {
  std::string text;
  for (const AccuracyPoint& point : report.points) {
    std::string words = svg_text(point.setting);
    if (point.outcome.picture)
      words = fmt::format("<a href=\"#{}\">{}</a>", picture_id(report, point), words);
    const auto half = half_range(report, point);
    text += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{:.3g}{}</td><td>{}{:.3g}</td>",
                        point.best ? " class=\"best\"" : "", words, point.seconds,
                        half ? fmt::format(" &plusmn; {:.1g}", *half) : "",
                        point.outcome.at_most ? "&le; " : "", point.outcome.error);
    for (const std::size_t kind : kinds) {
      const std::optional<double> part = error_parts(report, point)[kind];
      text += part ? fmt::format("<td>{:.3g}</td>", *part) : "<td>not defined</td>";
    }
    text += fmt::format("<td>{}</td></tr>\n", advice(report, point));
  }
  return text;
}

std::string table(const ChoiceReport& report) {
  std::string text = fmt::format(
      "<div class=\"wide\" role=\"region\" tabindex=\"0\" aria-label=\"points of {}\"><table>\n"
      "<thead><tr><th scope=\"col\">setting</th><th scope=\"col\">seconds</th>"
      "<th scope=\"col\">error</th>",
      svg_text(report.name));
  const std::vector<std::size_t> kinds = kinds_of_error(report);
  for (const std::size_t kind : kinds)
    text += fmt::format("<th scope=\"col\">{}</th>", name(static_cast<ErrorKind>(kind)));
  return text + "<th scope=\"col\">remark</th></tr></thead>\n<tbody>\n" + rows(report, kinds) +
         "</tbody>\n</table></div>\n";
}

// The svg element alone, without the declaration of a file of its own.
std::string figure(const std::string& words, const std::string& file) {
  return fmt::format("<figure role=\"img\" aria-label=\"{}\">\n{}</figure>\n", svg_text(words),
                     file.substr(file.find("<svg")));
}

std::string law(const FittedOrder& order, const std::string& grows) {
  const std::string of = order.series.empty() ? "" : svg_text(order.series) + ": ";
  return order.law == Law::power
             ? fmt::format("<p>{}The error goes like ({})<sup>{:.2f}</sup>.</p>\n", of, grows,
                           order.slope)
             : fmt::format("<p>{}The error goes like e<sup>{:.3f} {}</sup>.</p>\n", of, order.slope,
                           grows);
}

std::string section(const ChoiceReport& report) {
  std::string text =
      fmt::format("<section>\n<h2>{}</h2>\n<p>{}</p>\n<p>Error of {}: {}; against {}.</p>\n",
                  svg_text(report.name), svg_text(report.question), name(report.kind),
                  svg_text(report.unit), svg_text(report.reference));
  text += has_plot(report)
              ? figure("error against seconds of " + report.name, accuracy_plot(report))
              : "<p>No setting has an error, so there is no plot.</p>\n";
  text += table(report);
  for (const FittedOrder& order : report.orders) text += law(order, svg_text(report.grows));
  text += "<ul>\n";
  for (const std::string& line : remarks(report)) text += "<li>" + svg_text(line) + "</li>\n";
  text += "</ul>\n";
  for (const AccuracyPoint& point : report.points) text += picture(report, point);
  return text + "</section>\n";
}

// Beside a point: what it is set to, or, where that takes too many words, what of it grows.
std::string label_of(const ChoiceReport& report, const AccuracyPoint& point) {
  constexpr std::size_t kLongest = 24, kMostSettings = 12;
  const bool brief = point.setting.size() > kLongest || report.points.size() > kMostSettings;
  std::string words = brief && point.n > 0 ? tick_words(point.n) : point.setting;
  return point.outcome.at_most ? words + ", at most" : words;
}

Plot::Point plot_point(const ChoiceReport& report, const AccuracyPoint& point) {
  return {point.seconds, point.outcome.error, point.outcome.half, label_of(report, point),
          half_range(report, point).value_or(0)};
}

// The best points in the order of their times, as a line.
Plot::Series best_of(const ChoiceReport& report, double unit, std::string ink) {
  Plot::Series best{"", {}, false, std::move(ink), 1};
  for (const AccuracyPoint& point : report.points)
    if (point.best) best.points.push_back({point.seconds, point.outcome.error / unit});
  std::ranges::sort(best.points, {}, &Plot::Point::x);
  return best;
}

// Points with an error, which alone have a place on a logarithm.
std::ptrdiff_t count_shown(const ChoiceReport& report) {
  return std::ranges::count_if(report.points,
                               [](const AccuracyPoint& point) { return point.outcome.error > 0; });
}

// All choices at once: units differ, so each error is told by the largest of its choice. Nothing
// where that is the only one of each.
std::string overview(std::span<const ChoiceReport> reports) {
  Plot plot{"All choices: error against run time", "seconds of processor time",
            "error, of the largest of its choice"};
  plot.log_x = plot.log_y = true;
  std::size_t number = 0;
  bool is_empty = true;
  for (const ChoiceReport& report : reports) {
    if (!has_plot(report)) continue;
    is_empty = is_empty && count_shown(report) == 1;
    double largest = 0;
    for (const AccuracyPoint& point : report.points)
      largest = std::max(largest, point.outcome.error);
    plot.series.push_back(best_of(report, largest, series_ink(number++)));
    Plot::Series& all = plot.series.emplace_back(Plot::Series{report.name, {}, true});
    for (const AccuracyPoint& point : report.points)
      all.points.push_back({point.seconds, point.outcome.error / largest});
  }
  plot.caption = "Lines join the best settings of a choice.";
  return is_empty ? "" : figure("error against seconds of all choices", svg(plot));
}

}  // namespace

bool has_plot(const ChoiceReport& report) { return count_shown(report) > 0; }

std::string accuracy_plot(const ChoiceReport& report) {
  Plot plot{fmt::format("{}: {}", report.name, name(report.kind)), "seconds of processor time",
            "error, " + report.unit};
  plot.log_x = plot.log_y = true;
  bool by_number = false;
  for (const std::string& series : series_of(report.points)) {
    plot.series.push_back({series.empty() ? "settings" : series, {}, true});
    for (const AccuracyPoint& point : report.points) {
      if (point.series != series) continue;
      Plot::Point& shown = plot.series.back().points.emplace_back(plot_point(report, point));
      by_number = by_number || !shown.label.starts_with(point.setting);
      const std::string words = advice(report, point);
      shown.ringed = !words.empty();
      if (shown.ringed)
        plot.caption += fmt::format("{}: {}, {}. ", shown.y > 0 ? "Ringed" : "Without any error",
                                    point.setting, words);
    }
  }
  plot.series.push_back(best_of(report, 1, "axis"));
  plot.series.back().name = "best";
  if (by_number) plot.caption += "Numbers at points: " + report.grows;
  return svg(plot);
}

std::string accuracy_page(const std::string& scene, std::span<const ChoiceReport> reports,
                          const std::optional<Image>& shown) {
  std::string text = fmt::format(kHead, svg_text(scene)), left_out;
  if (shown) text += "<figure>" + image(*shown, "the scene, " + scene) + "</figure>\n";
  text += overview(reports);
  for (const ChoiceReport& report : reports)
    if (report.left_out.empty())
      text += section(report);
    else
      left_out +=
          fmt::format("<li>{}: {}</li>\n", svg_text(report.name), svg_text(report.left_out));
  if (!left_out.empty())
    text += "<section>\n<h2>Left out</h2>\n<ul>\n" + left_out + "</ul>\n</section>\n";
  return text + "</main>\n</body>\n</html>\n";
}

}  // namespace flatray
