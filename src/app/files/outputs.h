#pragma once
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "app/options/arguments.h"
#include "base/result.h"

namespace flatray {

/// What a verb writes goes through here, so that nothing is lost of what the user keeps: a file is
/// made or replaced whole, and unless --force is given it replaces only one of its own kind that is
/// no input.
class Outputs {
 public:
  Outputs() = default;
  /// The operands that name files are inputs.
  explicit Outputs(const Arguments& arguments);

  bool force() const { return force_; }
  void add_input(const std::filesystem::path& path);

  /// Whether a file that begins like `content` may be written; nothing is. Of what is known to be
  /// `ours`, as records tell, the content does not count.
  /// Error   Trouble::output: an input, a file of another kind, a link; a folder, a pipe or a
  ///         device whether forced or not; a folder that cannot be written or made.
  Result<void> allow(const std::filesystem::path& path, std::string_view content,
                     bool ours = false) const;

  /// The same of a file that is to be made longer: what --force allows to replace is removed.
  Result<void> make_way(const std::filesystem::path& path, std::string_view content) const;

  /// Writes what is allowed.
  Result<void> write(const std::filesystem::path& path, std::span<const std::byte> bytes) const;
  Result<void> write(const std::filesystem::path& path, const std::string& text) const;

 private:
  Result<void> judge(const std::filesystem::path& path, std::string_view content, bool ours,
                     bool force) const;

  std::set<std::pair<std::uint64_t, std::uint64_t>> inputs_;  ///< device and number of each
  bool force_ = false, can_force_ = false;
};

}  // namespace flatray
