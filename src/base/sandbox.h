#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"

namespace flatray {

/// Files and folders, with all beneath them, that stay open to this program.
struct Sandbox {
  std::vector<std::filesystem::path> read, write;  ///< what may be written may be read
};

/// Takes from this program for good, and from all it starts, every way to open another file, and where
/// the kernel knows how to also to connect to a network or signal other programs. Files open already stay so; names
/// in folders can still be asked for. Paths that are not there are passed over.
///
/// Needs   one thread.
/// Error   Trouble::unavailable where the kernel has no Landlock (Linux 5.13), or may not use it.
Result<void> enter_sandbox(const Sandbox& sandbox);

}  // namespace flatray
