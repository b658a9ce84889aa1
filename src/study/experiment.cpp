#include "study/experiment.h"

#include <fmt/core.h>

namespace flatray {

#include "experiments.inc"  // experiments()

Measure within_rounding(std::string name, double value, std::optional<double> expected,
                        double allowed) {
  return expected_within(std::move(name), value, expected, allowed,
                         expected ? fmt::format("rounding may take it {:.2g} off", allowed) : "");
}

ExperimentResult::File csv_file(const std::string& name, const Table& table) {
  return {name + ".csv", csv_text(table)};
}

ExperimentResult::File json_file(const std::string& name, const Fields& fields) {
  return {name + ".json", json_text(fields, {.indent = 1, .null_for_infinity = true}) + "\n"};
}

Fields head_of(const std::string& experiment, const ExperimentContext& context) {
  return {{"experiment", experiment},
          {"scene", context.scene.name},
          {"scene_hash", fmt::format("{:016x}", context.scene.hash)},
          {"seed", context.seed},
          {"count", context.count}};
}

}  // namespace flatray
