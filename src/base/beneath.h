#pragma once
#include <filesystem>
#include <optional>

namespace flatray {

/// `path` with every link on its way followed, if that is the folder `root` or lies beneath it; what is
/// not there yet counts as the name it would have. nullopt also for a link that leads nowhere.
///
/// Links are followed once, when this is asked: a program that puts a link in the place of a folder
/// afterwards is kept out by the sandbox alone (base/sandbox.h).
std::optional<std::filesystem::path> path_beneath(const std::filesystem::path& root,
                                                  const std::filesystem::path& path);

}  // namespace flatray
