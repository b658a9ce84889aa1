#include "app/result_files.h"

#include "base/file.h"

namespace flatray {

Result<Values> write_files(const ExperimentResult& result, const std::filesystem::path& folder) {
  Values names;
  for (const ExperimentResult::File& file : result.files) {
    if (auto written = write_file(folder / file.name, file.content); !written)
      return fail(std::move(written));
    names.emplace_back((folder / file.name).string());
  }
  return names;
}

}  // namespace flatray
