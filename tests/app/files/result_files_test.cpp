// Files of a result: named by what a scene holds, and never outside their folder.
#include "app/files/result_files.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

using ResultFiles = OwnFolder;

TEST_F(ResultFiles, StayInTheirFolderUnderPlainNames) {
  ExperimentResult result;
  for (const char* name : {"a.csv", "../../b.svg", "/c/d.svg", ".._.._b.svg", "a b.svg"})
    result.files.push_back({name, name});
  result.files.push_back({fmt::format("{:x>1000}.svg", ""), "long"});
  const auto names = write_files(result, folder_, Outputs());
  ASSERT_TRUE(names) << format(names.error());
  EXPECT_EQ(names->size(), 6U);
  for (const char* name : {"a.csv", ".._.._b.svg", "_c_d.svg", ".._.._b_2.svg", "a_b.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
  EXPECT_EQ(files_in(folder_).size(), 6U);
  // One that must not be replaced, and none is written.
  ASSERT_TRUE(write_file(folder_ / "a.csv", std::string("flatray = 1\n")));
  result.files.front().content = "new";
  result.files.insert(result.files.begin(), {"first.csv", "new"});
  EXPECT_FALSE(write_files(result, folder_, Outputs()));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "first.csv"));
}

}  // namespace
}  // namespace flatray
