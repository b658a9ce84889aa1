#pragma once
#include <vector>

#include "app/files/scene_input.h"
#include "app/report/report.h"
#include "study/experiment.h"
#include "trace/tracer.h"

namespace flatray {

/// What `flatray stability` is asked, read from its options.
struct StabilityRequest : Arguments {
  std::vector<const Tracer*> tracers;
  bool named =
      false;  ///< by --tracer; else those that claim to be exact alone decide the exit code
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> leaks{};  ///< rays of each room, of --leaks
  std::vector<std::string> places{};     ///< where rooms stand
  SceneOptions scene{};
};

/// All tracers that this machine has; warns of what it lacks.
std::vector<const Tracer*> tracers_at_hand(const Arguments& arguments);

/// --catalogue: a row for each stiff case and tracer, the tests of the others, and a row for each
/// tracer over all; catalogue.csv in the folder of --output, and what was measured in
/// catalogue_times.csv, so that the first is the same bytes every time.
Result<VerbOutput> report_catalogue(const StabilityRequest& request);

/// --sweep: scales and offsets from 2^-1000 to 2^1000; sweep.csv and a heat map for each tracer in
/// the folder of --output.
Result<VerbOutput> report_sweep(const StabilityRequest& request);

/// --leaks: a row for each place and tracer; leaks.csv in the folder of --output, from which it
/// goes on.
Result<VerbOutput> report_leaks(const StabilityRequest& request);

/// What other runs print, and their exit code; the files of `result` go to the folder of --output.
Result<VerbOutput> stability_files(const Arguments& arguments, Table table,
                                   const ExperimentResult& result, bool sound);

/// What a run in chunks that is stopped leaves.
inline constexpr const char* kRowsKept =
    "rows written with -o are kept, and the same command goes on";

/// What a run in chunks prints, and its exit code.
VerbOutput stability_output(Table table, bool sound);

/// SCENE: its rays by how near they are to a decision; margins.csv in the folder of --output.
Result<VerbOutput> report_margins(const StabilityRequest& request);

}  // namespace flatray
