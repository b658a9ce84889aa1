#pragma once
#include "base/result.h"
#include "base/table.h"
#include "study/experiment.h"

namespace flatray {

/// A key of a scene and the values it is to have.
struct Sweep {
  std::string key;
  std::vector<std::string> values;  ///< as written after "key="
};

/// "key=0.1..0.4:0.05" (both ends, the last where a step meets it) or "key=a,b,c".
/// Error   Trouble::usage; more than 10 000 values.
Result<Sweep> parse_sweep(std::string_view text, const Place& where);

/// What an experiment finds for each value, side by side.
class SweepResults {
 public:
  SweepResults(std::string experiment, Sweep sweep);
  void add(const std::string& value, const ExperimentResult& result);
  /// sweep.csv and sweep.json, sweep_MEASURE.svg where values are numbers, and the table as text.
  ExperimentResult result() &&;

 private:
  std::string experiment_;
  Sweep sweep_;
  Table table_;
  std::vector<std::pair<std::string, std::vector<Measure>>> found_;
  std::vector<std::string> names_;  // of all measures: which there are may depend on the value
  bool holds_ = true;
};

}  // namespace flatray
