#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "app/files/outputs.h"
#include "app/files/scene_input.h"
#include "app/frames/frames.h"
#include "app/golden/golden_check.h"
#include "app/golden/golden_update.h"
#include "app/options/places.h"
#include "app/verb.h"
#include "base/counted.h"
#include "base/parallel.h"
#include "base/shown_text.h"
#include "image/compare.h"

namespace flatray::golden_verb {
namespace {

namespace fs = std::filesystem;

constexpr Word<std::string_view> kBackends[] = {{"software", "software"}, {"gl", "gl"}};

struct Options : Arguments {
  GoldenRequest request;
  std::string root = ".";
  unsigned threads = 1;

  std::span<const std::string> names() const { return std::span(operands()).subspan(1); }

  void rows(OptionTable& row) {
    row("--why TEXT", "update: reason the pictures change, kept in the manifest", request.why);
    row("-f, --frames LIST",
        "update: the scene's goldens from now on, as 1,12 (default: as before)", request.frames,
        &parse_frames);
    row("--size WxH", "update: size of the pictures, instead of the scene's", request.size,
        [](const std::string& text, const Place& where) {
          return parse_size(text, where, kMostPixels);
        });
    row("--backend", "update: what draws; goldens of gl stand beside", request.backend, kBackends);
    row("--root DIR", "folder that holds scenes and golden_images", root);
    row(kForceRow);
    row_of_threads(row, threads);
    const std::string action = row.operand(0);
    if (action == "check")
      for (const char* option : {"why", "frames", "size", "backend"})
        if (row.has(option)) row.problem(option, "belongs to golden update");
    if (action == "update") expect_update(row);
  }

 private:
  void expect_update(OptionTable& row) const {
    const auto wrong = [&](const char* what, std::string message, std::string hint) {
      row.keep({{named_place(what), std::move(message), std::move(hint), Trouble::usage}});
    };
    if (const char* ci = std::getenv("CI"); ci != nullptr && *ci != '\0')
      wrong("CI", "goldens are not accepted by a machine",
            "run this where someone looks at the pictures, and commit them");
    const std::string scene = row.operand(1);
    if (scene.empty() || !row.operand(2).empty())
      return wrong("golden update", "needs one scene", "flatray golden update SCENE --why \"...\"");
    if (request.why.find_first_not_of(" \t") == std::string::npos)
      wrong("--why", "a golden is accepted for a reason",
            fmt::format("flatray golden update {} --why \"...\"", shell_word(scene)));
  }
};

// Where --root is said, no link on the way to what is read or written leads out of it.
Result<void> expect_beneath(const Options& options, const std::vector<GoldenRow>& rows) {
  if (!options.has("root")) return {};
  const fs::path root = options.root;
  std::vector<fs::path> files = {root / "golden_images/manifest.json"};
  for (const GoldenRow& row : rows)
    files.insert(files.end(), {root / row.scene, root / row.file(), root / row.look()});
  return expect_in_root(options.root, files);
}

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
    const auto is_of_it = [&](const GoldenRow& row) { return row.scene == *scene; };
    if (std::ranges::any_of(chosen, is_of_it)) continue;  // named before
    const std::size_t before = chosen.size();
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), is_of_it);
    if (chosen.size() == before)
      problems.push_back({named_place(*scene), "has no golden",
                          fmt::format("flatray golden update {} --why \"...\"", shell_word(name)),
                          Trouble::missing});
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return chosen;
}

// The report of a row, "" if it passes; its pictures are left to look at if not.
Result<std::string> check_row(const fs::path& root, const GoldenRow& row, const Outputs& outputs) {
  FLATRAY_TRY(check, check_golden(root, row));
  if (check->passes()) return std::string();
  return write_look(root, row, *check, outputs).map([&] { return golden_report(row, *check); });
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

Result<VerbOutput> check(const Options& options) {
  const fs::path root = options.root;
  if (auto inside = expect_beneath(options, {}); !inside) return fail(std::move(inside));
  FLATRAY_TRY(all, read_goldens(root));
  FLATRAY_TRY(rows, chosen_rows(root, *all, options.names()));
  if (auto inside = expect_beneath(options, *rows); !inside) return fail(std::move(inside));
  Diagnostics strays;
  if (options.names().empty()) {
    FLATRAY_TRY(files, stray_goldens(root, *all));
    for (const std::string& file : *files)
      strays.push_back({named_place(file), "has no row in the manifest",
                        "delete it, or accept its scene by flatray golden update"});
  }
  return check_rows(root, *rows, options.threads, Outputs(options), std::move(strays));
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

// No manifest yet is a project without goldens; a bad one stays an error.
Result<std::vector<GoldenRow>> rows_so_far(const fs::path& root) {
  Result<std::vector<GoldenRow>> rows = read_goldens(root);
  std::error_code error;
  if (!rows && !fs::exists(root / "golden_images" / "manifest.json", error))
    return std::vector<GoldenRow>();
  return rows;
}

Result<VerbOutput> update(const Options& options) {
  const fs::path root = options.root;
  GoldenRequest request = options.request;
  FLATRAY_TRY(scene, find_scene(root, options.names().front()));
  request.scene = *std::move(scene);
  GoldenRow made;
  made.scene = request.scene;
  if (auto inside = expect_beneath(options, {made}); !inside) return fail(std::move(inside));
  FLATRAY_TRY(rows, rows_so_far(root));
  FLATRAY_TRY(update, plan_update(root, *rows, request));
  FLATRAY_TRY(written, write_update(root, *update, Outputs(options)));
  VerbOutput output;
  for (const GoldenUpdate::Picture& picture : update->pictures)
    output.text.emplace_back(change_text(picture));
  for (const GoldenRow& row : update->removed) output.text.emplace_back(row.file() + ": removed\n");
  return output;
}

Result<VerbOutput> run(const Options& options) {
  const std::string& action = options.operands().front();
  if (action == "check") return check(options);
  if (action == "update") return update(options);
  const std::string near = nearest_word(action, {"check", "update"});
  return usage_error(named_place("golden"), fmt::format("cannot '{}'", action),
                     near.empty() ? "say check or update" : fmt::format("did you mean {}?", near));
}

}  // namespace

extern const Verb entry = {
    "golden",
    "check|update [SCENE...]",
    "compare committed pictures with what the scenes draw, or accept new ones",
    kCommand<Options, &run>,
    "  flatray golden check\n"
    "  flatray golden check chamber/hall\n"
    "  flatray golden update chamber/hall --why \"walls are drawn thicker\" -f 3\n",
    "no golden changed"};

}  // namespace flatray::golden_verb
