#include <fmt/core.h>

#include <algorithm>

#include "base/number_text.h"
#include "geom/refract.h"
#include "scene/material.h"

namespace flatray::glass_material {
namespace {

constexpr double kYellow_nm = 589.3;  // at which indices are told
constexpr double kMostIndex = 100;

constexpr KeyInfo kKeys[] = {{"index", "number", "1.5"},
                             {"dispersion", "number", "0"},
                             {"absorption", "number or [number, number, number]", "0"}};
constexpr double kMostAbsorption = 1e30;

using Channels = std::array<double, 3>;

class Glass : public Scatterer {
 public:
  // Cauchy: index + dispersion (1 / nm^2 - 1 / yellow^2).
  Glass(double index, double dispersion, const Channels& absorption)
      : index_(index), dispersion_(dispersion), absorption_(absorption) {}

  Departure scatter(const Arrival& arrival, double u) const override {
    const double own = index(arrival.nm);
    const double from = arrival.from_inside ? own : arrival.outer_index;
    const double to = arrival.from_inside ? arrival.outer_index : own;
    if (from == to) return {Departure::Way::scattered, arrival.direction};
    const auto refracted = refraction(from / to, -arrival.direction.dot(arrival.normal));
    if (!refracted || u < refracted->reflected) return {Departure::Way::mirrored};
    return {Departure::Way::scattered, refracted->of(arrival.direction, arrival.normal)};
  }

  double index(double nm) const override {
    if (dispersion_ == 0 || nm == 0) return index_;
    return index_ + dispersion_ * (1 / (nm * nm) - 1 / (kYellow_nm * kYellow_nm));
  }
  bool disperses() const override { return dispersion_ != 0; }
  Material for_rays() const override { return Material::glass; }
  Channels absorption() const override { return absorption_; }
  bool colours() const override {
    return disperses() || absorption_ != Channels{absorption_[0], absorption_[0], absorption_[0]};
  }

 private:
  double index_, dispersion_;
  Channels absorption_;
};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const double index = args.number("index", 1.5), dispersion = args.number("dispersion", 0);
  if (!(index > 0 && index <= kMostIndex))
    return fail(
        args.place("index"),
        fmt::format("material.glass.index is {}, not above 0 and at most 100", number_text(index)),
        "write 1.33 for water, 1.5 for glass");
  constexpr double kViolet_nm = 380, kRed_nm = 780;
  const Channels absorption = args.channels("absorption", 0);
  const Glass glass(index, dispersion, absorption);
  if (!(glass.index(kViolet_nm) > 0 && glass.index(kRed_nm) > 0))
    args.problem("dispersion", "leaves an index that is not above 0",
                 "write 0 to 30000, 4200 for crown glass");
  const auto wrong = std::ranges::find_if(
      absorption, [](double channel) { return !(channel >= 0 && channel <= kMostAbsorption); });
  if (wrong != absorption.end())
    args.problem("absorption", fmt::format("is {}, not 0 to 1e30", number_text(*wrong)),
                 "0 is clear; with 1 a part of 1/e is left after a unit of length");
  return std::make_unique<Glass>(glass);
}

}  // namespace

extern const MaterialType entry = {
    "glass",
    "refracts and reflects as a body does, clear or tinted; colours apart where it has dispersion",
    kKeys, &build};

}  // namespace flatray::glass_material
