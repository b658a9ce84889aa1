#include "app/golden/golden_check.h"

#include <fmt/core.h>

#include "app/files/outputs.h"
#include "app/report/report.h"
#include "base/shown_text.h"
#include "image/png.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

Result<Image> read_expected(const fs::path& root, const GoldenRow& row) {
  Result<Image> image = read_png((root / row.file()).string());
  if (!image || pixel_hash(*image) == row.pixels) return image;
  return fail(named_place(row.file()),
              fmt::format("is not the picture its row in the manifest names: {}, expected {}",
                          pixel_hash(*image), row.pixels),
              "take both from one commit, or accept the picture anew");
}

std::string layout_text(const Image& image) {
  return fmt::format("{} x {} with {} channels", image.width, image.height, image.channels);
}

}  // namespace

GoldenCheck judge(Image actual, Image expected) {
  GoldenCheck check{std::move(actual), std::move(expected), std::nullopt, false, {}, {}, {}};
  if (const auto difference = compare(check.actual, check.expected)) check.difference = *difference;
  return check;
}

Result<GoldenCheck> check_golden(const fs::path& root, const GoldenRow& row) {
  FLATRAY_TRY(expected, read_expected(root, row));
  FLATRAY_TRY(golden, load_golden_scene(root, row));
  FLATRAY_TRY(drawn, render_golden(golden->scene, row, row.backend, 1));
  GoldenCheck check = judge(std::move(drawn->image), std::move(*expected));
  check.tolerance = row.tolerance;
  check.renderer = drawn->renderer;
  check.scene_changed = scene_hash(golden->scene) != row.scene_hash;
  check.options = golden->options;
  return check;
}

std::string golden_report(const GoldenRow& row, const GoldenCheck& check) {
  const std::string stem = fs::path(row.scene).stem().string();
  const std::string allowed =
      row.exact() ? "must be equal" : fmt::format("{} allowed", row.tolerance.text());
  std::string text = fmt::format("{} frame {}: differs from {} ({}: {})\n", row.name(), row.frame,
                                 row.file(), row.backend, allowed);
  text += check.difference ? fmt::format("  {}\n", difference_text(*check.difference))
                           : fmt::format("  picture of {}, expected {}\n",
                                         layout_text(check.actual), layout_text(check.expected));
  if (check.scene_changed)
    text += fmt::format("  cause:  {} has changed since the picture was accepted\n", row.scene);
  if (check.renderer != row.renderer && !row.exact())
    text += fmt::format("  cause:  accepted from {}\n          drawn by {}\n", row.renderer,
                        check.renderer);
  text += fmt::format("  look:   {}/{{actual,expected{}}}.png\n", row.look(),
                      check.difference ? ",diff_x16" : "");
  const std::string backend = row.exact() ? "" : fmt::format(" --backend {}", row.backend);
  text += fmt::format("  replay: flatray render {} -f {}{}{} -o {}\n", shell_word(row.scene),
                      row.frame, check.options, backend, shell_word(stem + ".png"));
  return text + fmt::format("  accept: flatray golden update {}{} --why \"...\"\n",
                            shell_word(row.name()), backend);
}

Result<void> write_look(const fs::path& root, const GoldenRow& row, const GoldenCheck& check,
                        const Outputs& outputs) {
  const fs::path folder = root / row.look();
  std::vector<std::pair<const char*, Image>> pictures = {{"actual.png", check.actual},
                                                         {"expected.png", check.expected}};
  if (check.difference)
    pictures.emplace_back("diff_x16.png", difference_image(check.actual, check.expected));
  for (const auto& [name, image] : pictures)
    if (auto written = outputs.write(folder / name, encode_png(image)); !written) return written;
  return {};
}

}  // namespace flatray
