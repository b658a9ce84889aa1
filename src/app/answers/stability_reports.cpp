#include "app/answers/stability_reports.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/files/result_files.h"
#include "base/counted.h"
#include "base/parallel.h"
#include "base/table.h"
#include "study/plots/plot.h"
#include "study/stability/margins.h"
#include "study/stability/scale_sweep.h"

namespace flatray {
namespace {

constexpr std::size_t kShown = 20;           // margins, of all
constexpr std::uint64_t kRandomRays = 1000;  // of a scene without rays
constexpr double kNearUlps = 4, kCloseUlps = 1 << 20;

}  // namespace

Result<VerbOutput> stability_files(const Arguments& arguments, Table table,
                                   const ExperimentResult& result, bool sound) {
  if (const auto folder = arguments.text("output")) {
    FLATRAY_TRY(files, write_files(result, *folder, Outputs(arguments)));
  }
  return VerbOutput{
      .text = {table, result.summary}, .table = std::move(table), .exit_code = sound ? 0 : 1};
}

std::vector<const Tracer*> tracers_at_hand(const Arguments& arguments) {
  std::vector<const Tracer*> all;
  for (const Tracer* tracer : tracers()) {
    const std::string why = tracer->missing == nullptr ? "" : tracer->missing();
    if (why.empty())
      all.push_back(tracer);
    else
      report_warnings({{named_place(tracer->name), "is not here: " + why, ""}}, arguments);
  }
  return all;
}

Result<VerbOutput> report_sweep(const StabilityRequest& request) {
  const std::vector<double> steps = sweep_steps();
  const std::size_t side = steps.size();
  std::vector<SweepCell> cells(side * side);
  parallel_for(cells.size(), request.scene.limits.threads, [&](std::size_t i) {
    cells[i] = sweep_cell(request.tracers, request.seed, steps[i % side], steps[i / side]);
  });
  ExperimentResult result;
  Table all({"tracer", "scale_log2", "offset_log2", "rays", "wrong", "off"});
  Table table({"tracer", "cells", "cells_wrong", "rays", "wrong", "off", "worst_share", "at_scale",
               "at_offset", "verdict"});
  bool sound = true;
  for (std::size_t k = 0; k < request.tracers.size(); ++k) {
    const Tracer& tracer = *request.tracers[k];
    HeatMap map{fmt::format("--tracer {}: share of wrong walls", tracer.name),
                "log2 of the scale",
                "log2 of the offset",
                steps,
                steps,
                {}};
    std::uint64_t rays = 0, wrong = 0, off = 0, cells_wrong = 0;
    const SweepCell* worst = &cells.front();
    for (const SweepCell& cell : cells) {
      rays += cell.rays;
      wrong += cell.wrong[k];
      off += cell.off[k];
      cells_wrong += cell.wrong[k] > 0 ? 1 : 0;
      if (cell.wrong[k] > worst->wrong[k]) worst = &cell;
      map.shares.push_back(static_cast<double>(cell.wrong[k]) / static_cast<double>(cell.rays));
      all.add(
          {tracer.name, cell.scale_log2, cell.offset_log2, cell.rays, cell.wrong[k], cell.off[k]});
    }
    sound = sound && (wrong + off == 0 || !(request.named || tracer.exact));
    table.add({tracer.name, std::uint64_t{cells.size()}, cells_wrong, rays, wrong, off,
               static_cast<double>(worst->wrong[k]) / static_cast<double>(worst->rays),
               worst->scale_log2, worst->offset_log2, wrong + off == 0 ? "right" : "wrong"});
    if (wrong > 0)
      result.files.push_back({fmt::format("sweep_{}.svg", tracer.name), svg(plot_of(map))});
  }
  result.files.push_back(csv_file("sweep", all));
  return stability_files(request, std::move(table), result, sound);
}

Result<VerbOutput> report_margins(const StabilityRequest& request) {
  FLATRAY_TRY(scene, load_only_input(request, request.scene));
  FLATRAY_TRY(straight, expect_no_field(*scene, "stability"));
  FLATRAY_TRY(unsplit, expect_no_glass(*scene, "stability"));
  FLATRAY_TRY(standing, expect_no_speed(*scene, "stability"));
  const std::vector<Margin> all = margins(*scene, request.seed, kRandomRays);
  Table table({"ray", "leg", "near", "x", "y", "distance", "ulps"});
  for (const Margin& margin : all)
    table.add({margin.ray, margin.leg, margin.wall, margin.at.x(), margin.at.y(), margin.distance,
               margin.ulps});
  ExperimentResult result;
  result.files.push_back(csv_file("margins", table));
  const auto below = [&](double ulps) {
    return std::ranges::count_if(all, [&](const Margin& margin) { return margin.ulps < ulps; });
  };
  const auto exact =
      std::ranges::count_if(all, [](const Margin& margin) { return margin.distance == 0; });
  if (all.empty())
    result.summary = "\nno ray passes an end of a wall, or a tangent of a circle or ellipse\n";
  else
    result.summary = fmt::format(
        "\n{} from wall to wall: {} to an end, or a tangent of a circle or ellipse, exactly, {} "
        "within {} ulps of one, "
        "{} within 2^20\nsmallest margin: {:.3g} world units, {:.3g} ulps, of {} after {}, from {} "
        "at ({}, {})\n",
        counted(all.size(), "leg"), exact, below(kNearUlps), kNearUlps, below(kCloseUlps),
        all.front().distance, all.front().ulps, all.front().ray, counted(all.front().leg, "bounce"),
        all.front().wall, all.front().at.x(), all.front().at.y());
  Table shown = table;
  shown.rows.resize(std::min(table.rows.size(), kShown));
  auto output = stability_files(request, std::move(table), result, true);
  if (output) output->text.front() = std::move(shown);
  return output;
}

}  // namespace flatray
