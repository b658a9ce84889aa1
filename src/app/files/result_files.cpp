#include "app/files/result_files.h"

#include <algorithm>
#include <set>
#include <vector>

#include "app/files/output_pattern.h"

namespace flatray {
namespace {

constexpr std::size_t kLongestStem = 100;

// Names of things in a scene may hold anything; a file is called by plain letters of them, and by a
// number where another is called the same.
std::string plain_name(const std::string& name, std::set<std::string>& taken) {
  const std::size_t dot = std::min(name.rfind('.'), name.size());
  const std::string stem = plain_letters(name.substr(0, std::min(dot, kLongestStem)));
  const std::string extension = name.substr(dot);
  std::string plain = stem + extension;
  for (int number = 2; !taken.insert(plain).second; ++number)
    plain = stem + "_" + std::to_string(number) + extension;
  return plain;
}

}  // namespace

Result<std::vector<std::filesystem::path>> allow_files(const ExperimentResult& result,
                                                       const std::filesystem::path& folder,
                                                       const Outputs& outputs) {
  std::vector<std::filesystem::path> paths;
  std::set<std::string> taken;
  for (const ExperimentResult::File& file : result.files) {
    paths.push_back(folder / plain_name(file.name, taken));
    FLATRAY_TRY(allowed, outputs.allow(paths.back(), file.content));
  }
  return paths;
}

Result<Values> write_files(const ExperimentResult& result, const std::filesystem::path& folder,
                           const Outputs& outputs) {
  FLATRAY_TRY(paths, allow_files(result, folder, outputs));
  Values names;
  for (std::size_t i = 0; i < paths->size(); ++i) {
    FLATRAY_TRY(written, outputs.write((*paths)[i], result.files[i].content));
    names.emplace_back((*paths)[i].string());
  }
  return names;
}

}  // namespace flatray
