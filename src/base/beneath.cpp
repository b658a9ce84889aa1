#include "base/beneath.h"

#include <algorithm>

namespace flatray {

namespace fs = std::filesystem;

std::optional<fs::path> path_beneath(const fs::path& root, const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::canonical(root.empty() ? fs::path(".") : root, error);
  if (error) return std::nullopt;
  const fs::path absolute = fs::absolute(path.empty() ? fs::path(".") : path, error);
  const fs::path found = fs::weakly_canonical(absolute, error);
  if (error) return std::nullopt;
  const auto [end, at] = std::mismatch(folder.begin(), folder.end(), found.begin(), found.end());
  if (end != folder.end()) return std::nullopt;
  fs::path way = folder;
  for (auto part = at; part != found.end(); ++part)
    if (way /= *part; fs::is_symlink(fs::symlink_status(way, error))) return std::nullopt;
  return found;
}

}  // namespace flatray
