#include <fmt/core.h>

#include <cstdlib>

#include "app/files/outputs.h"
#include "app/files/scene_input.h"
#include "app/frames/frames.h"
#include "app/golden/golden_check.h"
#include "app/golden/golden_update.h"
#include "app/report/difference_text.h"
#include "app/report/report.h"
#include "app/verb.h"
#include "base/counted.h"
#include "base/parallel.h"
#include "image/compare.h"

namespace flatray::verbs {
namespace {

namespace fs = std::filesystem;

constexpr Option kOptions[] = {
    {"why", '\0', "TEXT", "update: reason the pictures change, kept in the manifest"},
    {"frames", 'f', "LIST",
     "update: the scene's goldens from now on, as 1,12 (default: as before)"},
    {"size", '\0', "WxH", "update: size of the pictures (default: the scene's)"},
    {"backend", '\0', "NAME", "update: software (default) or gl, whose goldens stand beside"},
    {"root", '\0', "DIR", "folder that holds scenes and golden_images (default: this one)"},
    kForceOption,
    kThreadsOption,
};

// Rows of the scenes named, or all.
Result<std::vector<GoldenRow>> chosen_rows(const fs::path& root, std::vector<GoldenRow> rows,
                                           std::span<const std::string> names) {
  if (names.empty()) return rows;
  std::vector<GoldenRow> chosen;
  Diagnostics problems;
  for (const std::string& name : names) {
    const Result<std::string> scene = find_scene(root, name);
    if (!scene) {
      problems.insert(problems.end(), scene.error().begin(), scene.error().end());
      continue;
    }
    const std::size_t before = chosen.size();
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen),
                 [&](const GoldenRow& row) { return row.scene == *scene; });
    if (chosen.size() == before)
      problems.push_back({named_place(*scene), "has no golden",
                          fmt::format("flatray golden update {} --why \"...\"", name),
                          Trouble::missing});
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return chosen;
}

// The report of a row, "" if it passes; its pictures are left to look at if not.
Result<std::string> check_row(const fs::path& root, const GoldenRow& row, const Outputs& outputs) {
  const Result<GoldenCheck> check = check_golden(root, row);
  if (!check) return tl::unexpected(check.error());
  if (check->passes()) return std::string();
  if (auto written = write_look(root, row, *check, outputs); !written)
    return fail(std::move(written));
  return golden_report(row, *check);
}

// All rows drawn and judged: reports of those that differ, and what kept others from being judged.
VerbOutput check_rows(const fs::path& root, const std::vector<GoldenRow>& rows, unsigned threads,
                      const Outputs& outputs, Diagnostics problems) {
  std::vector<Result<std::string>> reports(rows.size());
  parallel_for(rows.size(), threads,
               [&](std::size_t i) { reports[i] = check_row(root, rows[i], outputs); });
  VerbOutput output;
  std::size_t differ = 0, left_out = 0, not_judged = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Result<std::string>& report = reports[i];
    if (!report && !rows[i].exact() && report.error().front().trouble == Trouble::unavailable) {
      ++left_out;
      continue;
    }
    if (!report) {
      ++not_judged;
      problems.insert(problems.end(), report.error().begin(), report.error().end());
    }
    if (!report || report->empty()) continue;
    ++differ;
    output.text.emplace_back(*report + "\n");
  }
  output.text.emplace_back(
      fmt::format("{}, {} of them different{}{}\n", counted(rows.size(), "golden"), differ,
                  not_judged == 0 ? "" : fmt::format(", {} not judged", not_judged),
                  left_out == 0 ? "" : fmt::format(", {} not drawn: no GL here", left_out)));
  output.exit_code = differ == 0 ? 0 : 1;
  if (!problems.empty()) output.exit_code = report_failure(problems, "");
  return output;
}

Result<VerbOutput> check(const Arguments& arguments, const fs::path& root,
                         std::span<const std::string> names) {
  for (const char* option : {"why", "frames", "size", "backend"})
    if (arguments.has(option))
      return usage_error(arguments.where(option), "belongs to golden update");
  const Result<unsigned> count = threads(arguments);
  if (!count) return tl::unexpected(count.error());
  const Result<std::vector<GoldenRow>> all = read_goldens(root);
  if (!all) return tl::unexpected(all.error());
  const Result<std::vector<GoldenRow>> rows = chosen_rows(root, *all, names);
  if (!rows) return tl::unexpected(rows.error());
  Diagnostics strays;
  if (names.empty())
    for (const std::string& file : stray_goldens(root, *all))
      strays.push_back({named_place(file), "has no row in the manifest",
                        "delete it, or accept its scene by flatray golden update"});
  return check_rows(root, *rows, *count, Outputs(arguments), std::move(strays));
}

std::string change_text(const GoldenUpdate::Picture& picture) {
  if (picture.same()) return fmt::format("{}: same as before\n", picture.row.file());
  std::string what = "new";
  if (picture.before) {
    const auto change = compare(picture.after, *picture.before);
    what = change ? difference_text(*change) : std::string("of another size");
  }
  return fmt::format("{}: {}\n  look:   {}{}\n", picture.row.file(), what, picture.sheet(),
                     picture.before ? " (before, after, difference x16)" : "");
}

Result<GoldenRequest> read_request(const Arguments& arguments, const fs::path& root,
                                   const std::string& name) {
  GoldenRequest request;
  request.why = arguments.text("why").value_or("");
  if (request.why.find_first_not_of(" \t") == std::string::npos)
    return usage_error(named_place("--why"), "a golden is accepted for a reason",
                       fmt::format("flatray golden update {} --why \"...\"", name));
  if (const auto text = arguments.text("frames")) {
    Result<std::vector<unsigned>> frames = parse_frames(*text, arguments.where("frames"));
    if (!frames) return fail(std::move(frames));
    request.frames = std::move(*frames);
  }
  if (const auto text = arguments.text("size")) {
    const auto size = parse_size(*text, arguments.where("size"), kMostPixels);
    if (!size) return tl::unexpected(size.error());
    request.size = *size;
  }
  const Result<std::string> backend = arguments.one_of("backend", {"software", "gl"});
  if (!backend) return tl::unexpected(backend.error());
  request.backend = *backend;
  Result<std::string> scene = find_scene(root, name);
  if (!scene) return fail(std::move(scene));
  request.scene = std::move(*scene);
  return request;
}

// No manifest yet is a project without goldens; a bad one stays an error.
Result<std::vector<GoldenRow>> rows_so_far(const fs::path& root) {
  Result<std::vector<GoldenRow>> rows = read_goldens(root);
  std::error_code error;
  if (!rows && !fs::exists(root / "golden_images" / "manifest.json", error))
    return std::vector<GoldenRow>();
  return rows;
}

Result<VerbOutput> update(const Arguments& arguments, const fs::path& root,
                          std::span<const std::string> names) {
  if (const char* ci = std::getenv("CI"); ci != nullptr && *ci != '\0')
    return usage_error(named_place("CI"), "goldens are not accepted by a machine",
                       "run this where someone looks at the pictures, and commit them");
  if (names.size() != 1)
    return usage_error(named_place("golden update"), "needs one scene",
                       "flatray golden update SCENE --why \"...\"");
  const Result<GoldenRequest> request = read_request(arguments, root, names.front());
  if (!request) return tl::unexpected(request.error());
  const Result<std::vector<GoldenRow>> rows = rows_so_far(root);
  if (!rows) return tl::unexpected(rows.error());
  const Result<GoldenUpdate> update = plan_update(root, *rows, *request);
  if (!update) return tl::unexpected(update.error());
  if (auto written = write_update(root, *update, Outputs(arguments)); !written)
    return fail(std::move(written));
  VerbOutput output;
  for (const GoldenUpdate::Picture& picture : update->pictures)
    output.text.emplace_back(change_text(picture));
  for (const GoldenRow& row : update->removed) output.text.emplace_back(row.file() + ": removed\n");
  return output;
}

Result<VerbOutput> run(const Arguments& arguments) {
  const std::string& action = arguments.operands().front();
  const std::span<const std::string> names = std::span(arguments.operands()).subspan(1);
  const fs::path root = arguments.text("root").value_or(".");
  if (action == "check") return check(arguments, root, names);
  if (action == "update") return update(arguments, root, names);
  const std::string near = nearest_word(action, {"check", "update"});
  return usage_error(named_place("golden"), fmt::format("cannot '{}'", action),
                     near.empty() ? "say check or update" : fmt::format("did you mean {}?", near));
}

}  // namespace

extern const Verb golden = {
    "golden",
    "check|update [SCENE...]",
    "compare committed pictures with what the scenes draw, or accept new ones",
    1,
    10'000,
    kOptions,
    "  flatray golden check\n"
    "  flatray golden check chamber/hall\n"
    "  flatray golden update chamber/hall --why \"walls are drawn thicker\" -f 3\n",
    "no golden changed",
    &run};

}  // namespace flatray::verbs
