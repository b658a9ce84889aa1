#include "study/accuracy/accuracy_page.h"

#include <fmt/core.h>

#include <algorithm>

#include "image/png.h"
#include "study/accuracy/accuracy_report.h"
#include "study/plots/plot.h"
#include "study/plots/svg_text.h"

namespace flatray {
namespace {

// RFC 4648.
std::string base64(std::span<const std::byte> bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      group = group << 8U | (k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
  }
  return text;
}

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
img {{ min-width: min(100%, 20rem); image-rendering: pixelated; }}
</style>
</head>
<body>
<main>
<h1>{0}: error against run time</h1>
<p>Seconds are processor time: the median of rounds in turn, &plusmn; half of their range. Marked rows are best: no other setting of the choice is both as
fast and as near. Points without any error are in the tables, not in the plots, whose axes are logarithms.</p>
)";

// The svg element alone, without the declaration of a file of its own.
std::string inline_svg(const std::string& file) { return file.substr(file.find("<svg")); }

// What links to the picture of a point, and names it.
std::string picture_id(const ChoiceReport& report, const AccuracyPoint& point) {
  return fmt::format("{}-{}", report.name, &point - report.points.data() + 1);
}

// A link to what is inside opens it.
std::string picture(const ChoiceReport& report, const AccuracyPoint& point) {
  if (!point.outcome.picture) return "";
  return fmt::format(
      "<details><summary>{0}</summary><img id=\"{2}\" alt=\"the picture by {0}\" "
      "src=\"data:image/png;base64,{1}\"></details>\n",
      svg_text(point.setting), base64(encode_png(*point.outcome.picture)),
      picture_id(report, point));
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

// Nothing where logarithms leave nothing to plot.
std::string figure(const ChoiceReport& report) {
  if (std::none_of(report.points.begin(), report.points.end(),
                   [](const AccuracyPoint& point) { return point.outcome.error > 0; }))
    return "<p>No setting has an error, so there is no plot.</p>\n";
  return "<figure role=\"img\" aria-label=\"error against seconds of " + svg_text(report.name) +
         "\">\n" + inline_svg(accuracy_plot(report)) + "</figure>\n";
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
  std::string text = fmt::format("<section>\n<h2>{}</h2>\n<p>{}</p>\n", svg_text(report.name),
                                 svg_text(report.question));
  if (!report.left_out.empty())
    return text + fmt::format("<p>Left out: {}.</p>\n</section>\n", svg_text(report.left_out));
  text += fmt::format("<p>Error of {}: {}; against {}.</p>\n", name(report.kind),
                      svg_text(report.unit), svg_text(report.reference));
  text += table(report);
  for (const FittedOrder& order : report.orders) text += law(order, svg_text(report.grows));
  text += "<ul>\n";
  for (const std::string& line : remarks(report)) text += "<li>" + svg_text(line) + "</li>\n";
  text += "</ul>\n" + figure(report);
  for (const AccuracyPoint& point : report.points) text += picture(report, point);
  return text + "</section>\n";
}

}  // namespace

std::string accuracy_plot(const ChoiceReport& report) {
  Plot plot{fmt::format("{}: {}", report.name, name(report.kind)), "seconds", report.unit, {}};
  plot.log_x = plot.log_y = true;
  for (const std::string& series : series_of(report.points)) {
    plot.series.push_back({series.empty() ? "settings" : series, {}, true});
    for (const AccuracyPoint& point : report.points)
      if (point.series == series)
        plot.series.back().points.push_back({point.seconds, point.outcome.error});
  }
  Plot::Series best{"best", {}};
  for (const AccuracyPoint& point : report.points) {
    if (point.best && point.outcome.error > 0)
      best.points.push_back({point.seconds, point.outcome.error});
    if (const std::string words = advice(report, point); !words.empty())
      plot.notes.push_back({point.seconds, point.outcome.error, words});
  }
  std::sort(best.points.begin(), best.points.end(),
            [](const auto& a, const auto& b) { return a.x < b.x; });
  if (!best.points.empty()) plot.series.push_back(std::move(best));
  return svg(plot);
}

std::string accuracy_page(const std::string& scene, std::span<const ChoiceReport> reports) {
  std::string text = fmt::format(kHead, svg_text(scene));
  for (const ChoiceReport& report : reports) text += section(report);
  return text + "</main>\n</body>\n</html>\n";
}

}  // namespace flatray
