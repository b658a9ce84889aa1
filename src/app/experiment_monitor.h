#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "app/progress.h"
#include "study/experiment.h"

namespace flatray {

/// Shows how far an experiment has come, stops it on Ctrl-C, and keeps the blocks that are done in
/// a file, so that the run can go on from them.
class ExperimentMonitor : public RunMonitor {
 public:
  /// Without `kept_in` nothing is kept. `key` names all that results depend on.
  /// Error   Trouble::invalid where the file was kept by another run; Trouble::output.
  static Result<std::unique_ptr<ExperimentMonitor>> open(
      const std::optional<std::filesystem::path>& kept_in, const std::string& key);

  void begin(std::size_t blocks) override;
  std::optional<Numbers> kept(std::size_t block) override;
  void done(std::size_t block, const Numbers& result) override;
  bool stopped() override;

  /// Clears the bar. The file is removed where the run is over.
  /// Error   of the first block that could not be kept.
  Result<void> finish(bool over);

 private:
  Result<void> read(const std::string& key);

  std::filesystem::path path_;  // "" where nothing is kept
  std::map<std::size_t, Numbers> kept_;
  std::mutex mutex_;
  std::optional<Diagnostics> failure_;
  std::unique_ptr<Progress> progress_;
};

}  // namespace flatray
