#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/counted.h"
#include "base/npy.h"
#include "base/number_text.h"
#include "study/plots/plot.h"
#include "study/rooms/boundary_orbits.h"
#include "study/statistics/stretches.h"

namespace flatray::poincare_experiment {
namespace {

constexpr std::uint64_t kRandomOrbits = 64;
constexpr int kWidth = 820, kHeight = 410;  // one to one in the picture
constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;
constexpr std::size_t kMostNames = 12;

// The bounces of all orbits: how many in each pixel of the section, some of them as they are.
struct Section {
  BoundaryOrbits watched;
  std::uint64_t every = 1;  // of the bounces of an orbit one is listed
  std::vector<std::uint64_t> counts = std::vector<std::uint64_t>(kPixels);
  std::vector<LinearRgb> light = std::vector<LinearRgb>(kPixels);
  std::vector<std::vector<BoundaryPoint>> listed{};  // by orbit
  std::vector<Stretch> squares{};  // of sines: drawn orbits as they are, independent of each other
  std::size_t closed = 0;          // orbits

  explicit Section(BoundaryOrbits orbits);
  // Stretches that an orbit asked for is cut into, in whole parts.
  std::size_t parts() const {
    const std::size_t orbits = watched.orbits.starts.size();
    constexpr std::size_t kParts = kStretches / kStretchesInPart;
    return watched.orbits.random ? 1 : (kParts + orbits - 1) / orbits * kStretchesInPart;
  }
  void add(std::size_t orbit, std::span<const double> found);
};

// Whether an orbit comes round to the same bounces for ever, as far as doubles are rounded, and
// without drift. One that takes longer than is looked at is not told.
class Rounds {
 public:
  void see(const BoundaryPoint& point) {
    if (open_) return;
    if (!period_ && !first_.empty() && is_near(point, first_.front())) period_ = first_.size();
    if (period_) {
      open_ = !is_near(point, first_[seen_++ % *period_]);
      return;
    }
    first_.push_back(point);
    open_ = first_.size() > kLongest;
  }
  bool is_closed() const { return !open_ && period_ && seen_ >= *period_; }

 private:
  static constexpr std::size_t kLongest = std::size_t{1} << 16;
  static bool is_near(const BoundaryPoint& a, const BoundaryPoint& b) {
    constexpr double kNear = 0x1p-22;  // far below what is seen, far above rounding
    return std::fabs(a.along - b.along) <= kNear && std::fabs(a.sine - b.sine) <= kNear;
  }
  std::vector<BoundaryPoint> first_;
  std::optional<std::size_t> period_;
  std::size_t seen_ = 0;  // bounces after the first round
  bool open_ = false;
};

// What is kept of an orbit while it bounces, however often that is.
class Watch {
 public:
  Watch(std::size_t parts, std::uint64_t bounces, std::uint64_t every)
      : planned_(bounces), every_(every), squares_(parts), ends_(parts), counts_(kPixels) {}

  void see(const BoundaryPoint& point) {
    const auto x = std::clamp(static_cast<int>(point.along * kWidth), 0, kWidth - 1);
    const auto y = std::clamp(static_cast<int>((1 - point.sine) * 0.5 * kHeight), 0, kHeight - 1);
    ++counts_[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)];
    // Stretch k begins with bounce k * planned / parts.
    const std::uint64_t part = ((bounces_ + 1) * squares_.size() - 1) / planned_;
    squares_[part] += point.sine * point.sine;
    ++ends_[part];
    if (bounces_++ % every_ == 0) listed_.insert(listed_.end(), {point.along, point.sine});
    rounds_.see(point);
  }
  // Bounces, whether closed; squares and bounces of each stretch; points; pixels and their counts.
  Numbers numbers() const {
    Numbers all{static_cast<double>(bounces_), rounds_.is_closed() ? 1.0 : 0.0};
    for (std::size_t i = 0; i < squares_.size(); ++i)
      all.insert(all.end(), {squares_[i], static_cast<double>(ends_[i])});
    all.push_back(static_cast<double>(listed_.size()));
    all.insert(all.end(), listed_.begin(), listed_.end());
    for (std::size_t i = 0; i < kPixels; ++i)
      if (counts_[i] > 0)
        all.insert(all.end(), {static_cast<double>(i), static_cast<double>(counts_[i])});
    return all;
  }

 private:
  std::uint64_t planned_, every_, bounces_ = 0;
  Numbers squares_;
  std::vector<std::uint64_t> ends_;
  std::vector<std::uint64_t> counts_;
  Numbers listed_;
  Rounds rounds_;
};

// Of runs too long to list whole a million bounces or fewer are.
Section::Section(BoundaryOrbits orbits) : watched(std::move(orbits)) {
  constexpr std::uint64_t kMostListed = 10'000'000, kSample = 1'000'000;
  const std::uint64_t all = watched.bounces * watched.orbits.starts.size();
  if (all > kMostListed) every = (all + kSample - 1) / kSample;
}

void Section::add(std::size_t orbit, std::span<const double> found) {
  closed += found[1] > 0 ? 1 : 0;
  // Too short for stretches, it is one: orbits stay for some hundred bounces near regular ones.
  constexpr std::size_t kLeastBounces = 300;
  const std::size_t count = parts();
  const bool whole = found[0] < static_cast<double>(count * kLeastBounces);
  Stretch sum{0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    sum = {sum.x + found[2 + 2 * i], sum.y + found[3 + 2 * i]};
    if (whole && i + 1 < count) continue;
    if (sum.y > 0) squares.push_back(sum);
    sum = {0, 0};
  }
  std::size_t at = 3 + 2 * count;
  const std::size_t end = at + static_cast<std::size_t>(found[at - 1]);
  std::vector<BoundaryPoint>& points = listed.emplace_back();
  for (; at < end; at += 2) points.push_back({found[at], found[at + 1]});
  for (; at < found.size(); at += 2) {
    const auto pixel = static_cast<std::size_t>(found[at]);
    counts[pixel] += static_cast<std::uint64_t>(found[at + 1]);
    light[pixel] += nth_colour(orbit) * found[at + 1];
  }
}

// Light of every point on black: colours tell orbits apart, and add where orbits share a pixel. How
// bright it is at most says how many bounces there are.
Image light_of(const Section& section, const std::function<double(double)>& brightness) {
  return image_of(kWidth, kHeight, [&](std::size_t i) {
    const LinearRgb& sum = section.light[i];
    const double most = std::max({sum.r, sum.g, sum.b});
    if (most == 0) return LinearRgb{};
    // All of a pixel by one factor: the colour of an orbit stays its own, however often it comes
    // by.
    return sum * (brightness(static_cast<double>(section.counts[i])) / most);
  });
}

Plot plot_of(const Section& section) {
  Plot plot{"Bounces by place along the walls and angle", "place, share of the length of all walls",
            "sine of the angle to the normal"};
  const auto most = static_cast<double>(std::ranges::max(section.counts));
  const auto brightness = [&](double bounces) { return log_share(bounces, most); };
  plot.map.emplace(Plot::Map{light_of(section, brightness), {{0, -1}, {1, 1}}});
  plot.bar = bar_of("bounces in a pixel", most, &grey, brightness);
  const std::vector<std::string>& names = section.watched.orbits.names;
  if (names.size() > kMostNames)
    plot.caption = counted(names.size(), "orbit") + ", each in a colour; light adds up";
  else
    for (std::size_t i = 0; i < names.size(); ++i)
      plot.kinds.emplace_back(hex(nth_colour(i)), names[i]);
  return plot;
}

// The points that are listed, as text and as numbers.
void add_points(ExperimentResult& result, const Section& section) {
  std::uint64_t rows = 0;
  for (const auto& orbit : section.listed) rows += orbit.size();
  using Kind = NpyTable::Kind;
  NpyTable numbers({{"orbit", Kind::whole},
                    {"bounce", Kind::whole},
                    {"along", Kind::real},
                    {"sine", Kind::real}},
                   rows);
  std::string text = "orbit,bounce,along,sine\n";
  for (std::uint64_t i = 0; i < section.listed.size(); ++i)
    for (std::uint64_t k = 0; k < section.listed[i].size(); ++k) {
      const BoundaryPoint& point = section.listed[i][k];
      const std::uint64_t bounce = k * section.every + 1;
      text += fmt::format("{},{},{},{}\n", i + 1, bounce, number_text(point.along),
                          number_text(point.sine));
      numbers.add(i + 1);
      numbers.add(bounce);
      numbers.add(point.along);
      numbers.add(point.sine);
    }
  result.files.push_back({"poincare_points.csv", std::move(text)});
  result.files.push_back({"poincare_points.npy", std::move(numbers).take(),
                          "along: share of the walls' length; sine: of the angle to the normal"});
}

// How many bounces are in each pixel: by the middle of the sine from its top down, and of the
// place.
void add_density(ExperimentResult& result, const Section& section) {
  std::string text = "sine";
  for (int x = 0; x < kWidth; ++x) text += fmt::format(",{}", number_text((x + 0.5) / kWidth));
  text += '\n';
  for (int y = 0; y < kHeight; ++y) {
    text += number_text(1 - (y + 0.5) / (0.5 * kHeight));
    for (int x = 0; x < kWidth; ++x)
      text += fmt::format(
          ",{}",
          section.counts[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)]);
    text += '\n';
  }
  result.files.push_back({"poincare_density.csv", std::move(text)});
  result.files.push_back({"poincare_density.npy", npy_grid(section.counts, kHeight, kWidth),
                          "bounces by sine, from 1 down to -1, and by share of the walls' length"});
}

// Random starts have the measure that reflection keeps, in which the sine is uniform: the mean of
// its square is 1/3 in every room, whatever orbits do there.
Measure mean_square_sine(const Section& section) {
  const std::size_t orbits = section.listed.size();
  if (!section.watched.orbits.random) {
    Measure measure = measure_of_run("mean_square_sine", section.squares);
    if (section.closed == 0) return measure;
    // What stretches of it differ by is rounding, and where they begin.
    withhold_error(measure, "no error: " + (orbits == 1 ? "a closed orbit"
                                                        : fmt::format("{} of {} orbits are closed",
                                                                      section.closed, orbits)));
    return measure;
  }
  RatioSums sums;
  for (const Stretch& one : section.squares) sums.add(one.x, one.y);
  Measure measure = sums.measure("mean_square_sine", 1.0 / 3);
  if (measure.standard_error) measure.remark = fmt::format("error from {} orbits", sums.samples);
  return measure;
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  FLATRAY_TRY(orbits, boundary_orbits(context, room, kRandomOrbits));
  Section section(std::move(*orbits));
  const auto audit = watch_bounces(
      context, room, section.watched,
      Watch(section.parts(), section.watched.bounces, section.every),
      [&](std::size_t orbit, std::span<const double> found) { section.add(orbit, found); });
  if (!audit) return tl::unexpected(audit.error());
  ExperimentResult result =
      measured(context, "poincare",
               fmt::format("Bounces of {} by place along the walls and sine of the angle",
                           counted(section.listed.size(), "orbit")),
               {mean_square_sine(section)}, *audit);
  add_points(result, section);
  add_density(result, section);
  add_plot(result, "poincare", plot_of(section), context.threads);
  return result;
}

}  // namespace

extern const Experiment entry = {"poincare",
                                 "Where along the walls do orbits bounce, and at which angles?",
                                 &run, kUsesOfOrbitMeans};

}  // namespace flatray::poincare_experiment
