// Goal S10: filling convex polygons at 1080p against Cairo, AGG and OSMesa, as far as they are
// built in; and how far each is from the exact area of every pixel.
#include <fmt/core.h>

#include <map>

#include "drawing.h"
#include "exact_picture.h"
#include "measure.h"

namespace {

using bench::kHeight;
using bench::kWidth;
using bench::Polygon;

class Flatray : public bench::Filler {
 public:
  explicit Flatray(flatray::Coverage coverage) : coverage_(coverage) {}
  std::string name() const override {
    return coverage_ == flatray::Coverage::area   ? "flatray, exact area"
           : coverage_ == flatray::Coverage::rows ? "flatray, 4 rays a row"
                                                  : "flatray, centres";
  }
  void fill(const std::vector<Polygon>& polygons) override {
    if (list_.items.size() != polygons.size())
      list_ = bench::draw_list(polygons, kWidth, kHeight, coverage_);
    flatray::render_into(list_, {}, image_);
  }
  std::array<double, 3> pixel(int x, int y) const override {
    const std::uint8_t* at = image_.at(x, y);
    return {1.0 * at[0], 1.0 * at[1], 1.0 * at[2]};
  }

 private:
  const flatray::Coverage coverage_;
  flatray::DrawList list_;
  flatray::Image image_;
};

double same(double value) { return value; }
double light_of_srgb(double value) {
  const double v = value / 255;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double srgb_of_light(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

// Goals S10, for K = 10, 1000, 100 000: the ratio to be reached by flatray's mode of the same kind.
struct Goal {
  std::string must, aim;
};
const std::map<std::string, std::array<Goal, 3>> kGoals = {
    {"Cairo, no AA", {{{"2.6", "5"}, {"5.2", "7"}, {"12", "14"}}}},
    {"Cairo, AA", {{{"1.8", "3"}, {"4.5", "5"}, {"14", "15"}}}},
    {"AGG, AA", {{{"3.9", "6"}, {"4.7", "5"}, {"8", "9"}}}},
    {"OSMesa, no AA", {{{"8", "15"}, {"12", "15"}, {"25", "28"}}}},
    {"OSMesa, 4x MSAA", {{{"46", "60"}, {"17", "20"}, {"20", "22"}}}}};

bool smooth(const std::string& name) { return name.find("no AA") == std::string::npos; }

void compare(int count, std::size_t column, bench::Fillers& all) {
  const std::vector<Polygon> polygons = bench::polygons(count, kWidth, kHeight);
  const bench::ExactPicture srgb(polygons, &same), light(polygons, &light_of_srgb);
  std::vector<bench::Contender> contenders;
  for (const auto& filler : all)
    contenders.push_back({filler->name(), [&] { filler->fill(polygons); }});
  for (const auto& contender : contenders) contender.run();
  const std::vector<double> times = bench::compare(contenders, 9, 0.03);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool own = i < 3;
    const auto pixel = [&](int x, int y) { return all[i]->pixel(x, y); };
    const double difference =
        own ? light.mean_difference(pixel, &srgb_of_light) : srgb.mean_difference(pixel, &same);
    const std::string& name = contenders[i].name;
    fmt::print("| {:6} | {:21} | {:7.2f} | {:6.3f} |", count, name, 1e3 * times[i], difference);
    if (own) {
      fmt::print("       |      |     |\n");
      continue;
    }
    const Goal& goal = kGoals.at(name)[column];
    fmt::print(" {:5.1f} | {:4} | {:3} |\n", times[i] / times[smooth(name) ? 1 : 0], goal.must,
               goal.aim);
  }
}

}  // namespace

int main(int argc, char** argv) {
  bench::Fillers all;
  all.push_back(std::make_unique<Flatray>(flatray::Coverage::centre));
  all.push_back(std::make_unique<Flatray>(flatray::Coverage::area));
  all.push_back(std::make_unique<Flatray>(flatray::Coverage::rows));
#ifdef BENCH_CAIRO
  bench::add_cairo(all);
#endif
#ifdef BENCH_AGG
  bench::add_agg(all);
#endif
#ifdef BENCH_OSMESA
  bench::add_osmesa(all);
#endif
  fmt::print(
      "\nS10: convex polygons of together twice the area of {} x {}, one thread, ms of CPU time,\n"
      "medians of 9 rounds in turn; difference: mean of all channels from exact area, in levels\n"
      "(peers blend sRGB values, flatray light). Exact area may reach a third of the AA figures.\n"
      "|      K | who                 |      ms | differ | ratio | must | aim |\n"
      "|---|---|---|---|---|---|---|\n",
      kWidth, kHeight);
  if (argc > 1) return compare(std::atoi(argv[1]), 1, all), 0;
  compare(10, 0, all);
  compare(1000, 1, all);
  compare(100'000, 2, all);
}
