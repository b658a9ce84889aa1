// Files of a result: named by what a scene holds, and never outside their folder.
#include "app/result_files.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "support/paths.h"

namespace flatray {
namespace {

TEST(ResultFiles, StayInTheirFolderUnderPlainNames) {
  const std::filesystem::path folder =
      std::filesystem::path(binary_path()) / "tests" / "result_files_test";
  std::filesystem::remove_all(folder);
  ExperimentResult result;
  for (const char* name : {"a.csv", "../../b.svg", "/c/d.svg", ".._.._b.svg", "a b.svg"})
    result.files.push_back({name, name});
  result.files.push_back({fmt::format("{:x>1000}.svg", ""), "long"});
  const auto names = write_files(result, folder, Outputs());
  ASSERT_TRUE(names) << format(names.error());
  EXPECT_EQ(names->size(), 6U);
  for (const char* name : {"a.csv", ".._.._b.svg", "_c_d.svg", ".._.._b_2.svg", "a_b.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder),
                          std::filesystem::directory_iterator()),
            6);
  // One that must not be replaced, and none is written.
  ASSERT_TRUE(write_file(folder / "a.csv", std::string("flatray = 1\n")));
  result.files.front().content = "new";
  result.files.insert(result.files.begin(), {"first.csv", "new"});
  EXPECT_FALSE(write_files(result, folder, Outputs()));
  EXPECT_FALSE(std::filesystem::exists(folder / "first.csv"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace flatray
