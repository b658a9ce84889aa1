#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "base/result.h"
#include "study/stability.h"

namespace flatray {

/// Rows of a file stability.csv, one for each chunk checked: what a run that was stopped goes on
/// from. A last row without its end, as a full disk leaves it, is taken away.
///
/// Needs   a folder of its own for every build: rows tell tracers and tiers apart, not programs.
class StabilityLog {
 public:
  struct Key {
    std::string family, tracer, isa;
    std::uint64_t seed, chunk;
    auto operator<=>(const Key&) const = default;
  };

  /// The rows that are in `folder`, or none without a folder.
  /// Error   Trouble::missing, Trouble::output; Trouble::invalid, naming the line, where a row is
  ///         not what add() writes.
  static Result<StabilityLog> open(const std::optional<std::string>& folder);

  bool has(const Key& key) const { return rows_.contains(key); }
  /// Appends a row, flushed.
  Result<void> add(const Key& key, const StabilityTally& tally, double seconds);
  /// Chunks 0 to `chunks` - 1 together, whatever the chunk of `key`.
  StabilityTally sum(Key key, std::uint64_t chunks) const;

 private:
  Result<void> read();

  std::filesystem::path path_;  ///< "" where nothing is kept
  std::map<Key, StabilityTally> rows_;
};

}  // namespace flatray
