#include "app/golden/golden_update.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/files/outputs.h"
#include "app/report/report.h"
#include "image/png.h"
#include "scene/load.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

std::vector<GoldenRow> rows_of(const std::vector<GoldenRow>& rows, const GoldenRequest& request) {
  std::vector<GoldenRow> mine;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(mine),
               [&](const GoldenRow& row) { return row.is_of(request.scene, request.backend); });
  return mine;
}

bool fits(const FilmSize& size) {
  return size.width <= kGoldenWidth && size.height <= kGoldenHeight;
}

// Rows asked for, before their pictures: what is unset is taken from the rows the scene has.
std::vector<GoldenRow> wanted_rows(const GoldenRequest& request,
                                   const std::vector<GoldenRow>& before, const Scene& scene) {
  FilmSize size{scene.film.width, scene.film.height};
  if (!fits(size) && !before.empty()) size = {before.front().width, before.front().height};
  std::vector<unsigned> frames(before.size());
  std::ranges::transform(before, frames.begin(), &GoldenRow::frame);
  if (frames.empty()) frames = {1};
  std::vector<GoldenRow> wanted;
  for (const unsigned frame : request.frames.value_or(frames)) {
    GoldenRow& row = wanted.emplace_back();
    row.scene = request.scene, row.scene_hash = scene_hash(scene);
    row.backend = request.backend;
    row.frame = frame, row.seed = scene.seed;
    row.width = request.size.value_or(size).width, row.height = request.size.value_or(size).height;
    row.why = request.why;
  }
  return wanted;
}

// What can be said before anything is drawn.
Diagnostics check_rows(const std::vector<GoldenRow>& wanted, const std::vector<GoldenRow>& rows) {
  Diagnostics problems;
  const GoldenRow& first = wanted.front();
  const auto wrong = [&](std::string message, std::string hint) {
    problems.push_back(
        {named_place(first.scene), std::move(message), std::move(hint), Trouble::usage});
  };
  if (!fits({first.width, first.height}))
    wrong(fmt::format("{} x {} pixels are too many for a golden", first.width, first.height),
          fmt::format("say --size WxH with at most {}x{}", kGoldenWidth, kGoldenHeight));
  if (wanted.size() > kGoldenFrames)
    wrong(fmt::format("{} frames are too many for one scene", wanted.size()),
          fmt::format("choose at most {} that show the most, as -f 1,12,40", kGoldenFrames));
  const auto other = std::ranges::find_if(rows, [&](const GoldenRow& row) {
    return row.scene != first.scene && row.folder() == first.folder();
  });
  if (other != rows.end())
    wrong(fmt::format("shares {} with {}", first.folder(), other->scene),
          "rename one of the scenes");
  return problems;
}

// The largest difference of other ways to draw the picture.
Result<Difference> measured_drift(const Scene& scene, const GoldenRow& row, const Image& picture) {
  std::vector<std::string> ways = {row.backend};
  if (!row.exact()) ways.insert(ways.end(), {"osmesa", "egl"});
  Difference drift;
  for (const std::string& way : ways) {
    FLATRAY_TRY(again, render_golden(scene, row, way, 3));
    const Difference one = compare(again->image, picture).value();
    const std::uint64_t pixels = std::max(drift.pixels, one.pixels);
    if (one.worst >= drift.worst) drift = one;
    drift.pixels = pixels;
  }
  return drift;
}

Result<GoldenUpdate::Picture> draw(const fs::path& root, const Scene& scene, GoldenRow row,
                                   const std::vector<GoldenRow>& before) {
  GoldenUpdate::Picture picture;
  FLATRAY_TRY(drawn, render_golden(scene, row, row.backend, 1));
  picture.after = std::move(drawn->image);
  FLATRAY_TRY(measured, measured_drift(scene, row, picture.after));
  const Difference& drift = *measured;
  if (!row.exact()) {
    row.renderer = drawn->renderer;
    row.tolerance = {static_cast<int>(drift.worst), drift.pixels};
  }
  if (!row.tolerance.allows(drift))
    return usage_error(named_place(row.name()),
                       fmt::format("frame {} drifts: {}", row.frame, difference_text(drift)),
                       "two renders must be equal: that is a bug, and no golden can stand for it");
  row.drift = row.tolerance.text();
  row.pixels = pixel_hash(picture.after);
  const auto old = std::ranges::find(before, row.frame, &GoldenRow::frame);
  if (old != before.end())
    if (Result<Image> image = read_png((root / old->file()).string())) picture.before = *image;
  if (picture.same() && old->pixels == row.pixels) row.why = old->why;
  picture.png = encode_png(picture.after);
  picture.row = std::move(row);
  return picture;
}

bool has_file(const std::vector<GoldenUpdate::Picture>& pictures, const std::string& file) {
  return std::ranges::any_of(
      pictures, [&](const GoldenUpdate::Picture& picture) { return picture.row.file() == file; });
}

// Bytes of all goldens afterwards.
std::uintmax_t total_bytes(const fs::path& root, const GoldenUpdate& update) {
  std::uintmax_t total = 0;
  for (const GoldenUpdate::Picture& picture : update.pictures) total += picture.png.size();
  for (const GoldenRow& row : update.rows) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(root / row.file(), error);
    if (!error && !has_file(update.pictures, row.file())) total += size;
  }
  return total;
}

// Colours only: a sheet has no alpha.
void paste(const Image& image, int left, Image& sheet) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(image.at(x, y), 3, sheet.at(left + x, y));
}

}  // namespace

Result<GoldenUpdate> plan_update(const fs::path& root, const std::vector<GoldenRow>& rows,
                                 const GoldenRequest& request) {
  FLATRAY_TRY(loaded, load_scene(root / request.scene, {}, {.root = root}));
  const std::vector<GoldenRow> before = rows_of(rows, request);
  std::vector<GoldenRow> wanted = wanted_rows(request, before, loaded->scene);
  if (Diagnostics problems = check_rows(wanted, rows); !problems.empty())
    return tl::unexpected(std::move(problems));
  FLATRAY_TRY(scene, scene_of_size(std::move(loaded->scene), root, wanted.front()));
  limit_golden_light(*scene);
  GoldenUpdate update;
  for (GoldenRow& row : wanted) {
    FLATRAY_TRY(picture, draw(root, *scene, std::move(row), before));
    update.rows.push_back(picture->row);
    update.pictures.push_back(std::move(*picture));
  }
  for (const GoldenRow& row : rows)
    if (!row.is_of(request.scene, request.backend))
      update.rows.push_back(row);
    else if (!has_file(update.pictures, row.file()))
      update.removed.push_back(row);
  if (const std::uintmax_t total = total_bytes(root, update); total > kGoldenBytes)
    return usage_error(
        named_place(request.scene), fmt::format("all goldens together would have {} bytes", total),
        fmt::format("at most {}: say a smaller --size or fewer frames (-f)", kGoldenBytes));
  return update;
}

Result<void> write_update(const fs::path& root, const GoldenUpdate& update,
                          const Outputs& outputs) {
  for (const GoldenUpdate::Picture& picture : update.pictures) {
    if (picture.same()) continue;
    FLATRAY_TRY(written, outputs.write(root / picture.row.file(), picture.png));
    FLATRAY_TRY(beside, outputs.write(root / picture.sheet(), encode_png(golden_sheet(picture))));
  }
  if (auto written = write_goldens(root, update.rows, outputs); !written) return written;
  for (const GoldenRow& row : update.removed) {
    std::error_code ignored;  // a file that stays is found by the next check
    fs::remove(root / row.file(), ignored);
  }
  return {};
}

Image golden_sheet(const GoldenUpdate::Picture& picture) {
  const Image& after = picture.after;
  if (!picture.before || !compare(*picture.before, after)) return after;
  constexpr int kGap = 4;
  Image sheet(3 * after.width + 2 * kGap, after.height, 3);
  std::ranges::fill(sheet.pixels, std::uint8_t{128});
  paste(*picture.before, 0, sheet);
  paste(after, after.width + kGap, sheet);
  paste(difference_image(after, *picture.before), 2 * (after.width + kGap), sheet);
  return sheet;
}

}  // namespace flatray
