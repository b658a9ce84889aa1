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
/// from.
class StabilityLog {
 public:
  struct Key {
    std::string family, tracer;
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
  /// Chunks 0 to `chunks` - 1 together.
  StabilityTally sum(const std::string& family, const std::string& tracer, std::uint64_t seed,
                     std::uint64_t chunks) const;

 private:
  Result<void> read();

  std::filesystem::path path_;  ///< "" where nothing is kept
  std::map<Key, StabilityTally> rows_;
};

}  // namespace flatray
