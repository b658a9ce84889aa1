#include "scene/material.h"

namespace flatray::materials {
namespace {

constexpr KeyInfo kKeys[] = {{"diffuse", "number", "0"},
                             {"isotropic", "number", "0"},
                             {"mirror", "number", "0"},
                             {"pass", "number", "0"},
                             {"colour", "\"#rrggbb\"", "\"#ffffff\""}};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const double numbers[] = {args.number("diffuse"), args.number("isotropic"), args.number("mirror"),
                            args.number("pass")};
  double sum = 0;
  for (const double number : numbers) sum += number >= 0 ? number : 2;
  if (sum == 0)
    args.warning(args.where, "the material sends no light on", "write \"absorb\", which says so");
  constexpr double kRounding =
      0x1p-50;  // that decimals and three sums leave, as of 0.1 + 0.2 + 0.7
  if (!(sum <= 1 + kRounding))
    return fail(args.where, "the parts of the mix are below 0 or more than 1 together",
                "write how much of the light goes each way; the rest is absorbed");
  const Reflectance colour = read_reflectance(args);
  const double part = colour.part;
  return mixture(
      {part * numbers[0], part * numbers[1], part * numbers[2], part * numbers[3], colour.tint});
}

}  // namespace

extern const MaterialType mix = {
    "mix", "parts of the light are scattered, mirrored or let through; the rest is absorbed", kKeys,
    &build};

}  // namespace flatray::materials
