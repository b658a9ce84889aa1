// Goal S14: CPU time of a whole process that draws one 1080p frame of ten polygons into a PNG,
// `flatray render` against a minimal OSMesa program.
#include <fmt/core.h>

#include <filesystem>
#include <fstream>

#include "image/png.h"
#include "polygons.h"
#include "process.h"

namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 1920, kHeight = 1080;

// World and film are the same pixels, but for y, which grows upwards in scenes.
void write_scene(const fs::path& path) {
  std::ofstream out(path);
  out << fmt::format("flatray = 1\nfilm = {{ size = [{0}, {1}], world = [[0, 0], [{0}, {1}]] }}\n",
                     kWidth, kHeight);
  for (const bench::Polygon& polygon : bench::polygons(10, kWidth, kHeight)) {
    std::string points;
    for (const auto& corner : polygon.corners)
      points += fmt::format("[{}, {}], ", corner.x(), kHeight - corner.y());
    const auto& [r, g, b] = polygon.colour;
    out << fmt::format(
        "[[entity]]\nshape = {{ polygon = {{ points = [{}] }} }}\nfill = \"#{:02x}{:02x}{:02x}\"\n",
        points, r, g, b);
  }
}

// Mean over all channels, in levels; below 0 where a picture is missing.
double difference(const fs::path& a, const fs::path& b) {
  const auto first = flatray::read_png(a.string()), second = flatray::read_png(b.string());
  if (!first || !second || first->pixels.size() != second->pixels.size()) return -1;
  double sum = 0;
  for (std::size_t i = 0; i < first->pixels.size(); ++i)
    sum += std::abs(first->pixels[i] - second->pixels[i]);
  return sum / static_cast<double>(first->pixels.size());
}

}  // namespace

int main(int, char** arguments) {
  constexpr int kRounds = 15;
  const fs::path programs = fs::path(arguments[0]).parent_path();
  const fs::path folder = fs::temp_directory_path() / fmt::format("whole_process.{}", getpid());
  fs::create_directory(folder);
  write_scene(folder / "ten.toml");
  const std::string ours = (folder / "flatray.png").string();
  const std::string theirs = (folder / "osmesa.png").string();
  const std::vector<std::string> commands[] = {
      {(programs.parent_path() / "flatray").string(), "render", (folder / "ten.toml").string(),
       "-f", "1", "-j", "1", "-o", ours},
      {(programs / "osmesa_frame").string(), theirs}};
  std::vector<double> cpu[2];
  bool worked = true;
  for (int round = 0; round <= kRounds && worked; ++round)
    for (std::size_t i = 0; i < 2; ++i) {
      const bench::ProcessCost cost = bench::run_process(commands[i]);
      worked = worked && cost.worked;
      if (round > 0) cpu[i].push_back(cost.cpu);
    }
  const double apart = worked ? difference(ours, theirs) : -1;
  fs::remove_all(folder);
  if (!worked || apart < 0 || apart > 1) {
    fmt::print("S14: a program failed, or the pictures differ by {:.2f} levels\n", apart);
    return 1;
  }
  const double own = bench::median(cpu[0]), other = bench::median(cpu[1]);
  fmt::print(
      "\nS14: one frame of ten polygons at {} x {}, whole process, ms of CPU time, medians of {} "
      "rounds\n(mean difference of the pictures {:.3f} levels)\n"
      "| flatray render | OSMesa program | ratio | must | aim |\n|---|---|---|---|---|\n"
      "| {:14.1f} | {:14.1f} | {:5.1f} | 3    | 8   |\n",
      kWidth, kHeight, kRounds, apart, 1e3 * own, 1e3 * other, other / own);
}
