#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "app/files/journal.h"
#include "app/files/outputs.h"
#include "app/report/progress.h"
#include "base/json.h"
#include "study/experiment.h"

namespace flatray {

/// Shows how far an experiment has come, stops it on Ctrl-C, and keeps the blocks that are done in
/// a file, so that the run can go on from them.
class ExperimentMonitor : public RunMonitor {
 public:
  /// Without `kept_in` nothing is kept. `setting` is all that results depend on.
  /// Error   Trouble::output, also where the file was kept by another run, or another is at work.
  static Result<std::unique_ptr<ExperimentMonitor>> open(
      const std::optional<std::filesystem::path>& kept_in, const Fields& setting,
      const Outputs& outputs);

  void begin(std::size_t blocks) override;
  std::optional<Numbers> kept(std::size_t block) override;
  void done(std::size_t block, const Numbers& result) override;
  bool stopped() override;

  /// Clears the bar. Error   of the first block that could not be kept.
  Result<void> finish();
  /// Removes what was kept, and a folder that held nothing else: all that came of it is written.
  Result<void> forget();

 private:
  Result<void> read(const std::string& key, bool force);

  std::optional<Journal> journal_;  // none where nothing is kept
  std::optional<Claim> claim_;
  std::map<std::size_t, Numbers> kept_;
  std::mutex mutex_;
  std::optional<Diagnostics> failure_;
  std::unique_ptr<Progress> progress_;
};

/// Whether a text is what a monitor keeps: a setting, and a block a line.
bool are_blocks(const std::string& text);

}  // namespace flatray
