#include "base/file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/paths.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// An empty folder of its own for each test.
class File : public ::testing::Test {
 protected:
  File() : folder_(fs::path(binary_path()) / "file_test" / test_name()) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~File() override { fs::remove_all(folder_); }

  static std::string test_name() {
    return ::testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const fs::path folder_;
};

TEST_F(File, WhatIsWrittenIsReadBack) {
  const std::string content("a\0\r\n\xff", 5);
  ASSERT_TRUE(write_file(folder_ / "a.bin", content).has_value());
  EXPECT_EQ(read_file(folder_ / "a.bin").value(), content);
  ASSERT_TRUE(write_file(folder_ / "a.bin", std::string()).has_value());
  EXPECT_EQ(read_file(folder_ / "a.bin").value(), "");
}

TEST_F(File, WritingLeavesNoTemporaryFile) {
  ASSERT_TRUE(write_file(folder_ / "a.txt", std::string(1 << 20, 'x')).has_value());
  ASSERT_TRUE(write_file(folder_ / "a.txt", std::string("again")).has_value());
  EXPECT_EQ(entries(), 1U);
}

TEST_F(File, WhatIsFlushedLaterIsThereAtOnce) {
  const std::string content(1 << 16, 'x');
  ASSERT_TRUE(
      write_file(folder_ / "a.txt", std::as_bytes(std::span(content)), Flush::later).has_value());
  ASSERT_TRUE(append_line(folder_ / "b.txt", "line", Flush::later).has_value());
  EXPECT_EQ(read_file(folder_ / "a.txt").value(), content);
  EXPECT_EQ(read_file(folder_ / "b.txt").value(), "line\n");
  EXPECT_TRUE(flush_file(folder_ / "b.txt").has_value());
  flush_folder(folder_);
  EXPECT_EQ(flush_file(folder_ / "none.txt").error()[0].trouble, Trouble::output);
}

TEST_F(File, MissingFoldersAreMade) {
  const fs::path deep = folder_ / "a" / "b" / "c.txt";
  ASSERT_TRUE(write_file(deep, std::string("x")).has_value());
  EXPECT_TRUE(append_line(folder_ / "d" / "e.txt", "x").has_value());
  EXPECT_EQ(read_file(deep).value(), "x");
}

TEST_F(File, AWriteThatFailsKeepsWhatWasThereAndLeavesNothing) {
  fs::create_directories(folder_ / "taken" / "inside");
  const Result<void> written = write_file(folder_ / "taken", std::string("x"));
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error()[0].trouble, Trouble::output);
  EXPECT_TRUE(fs::is_directory(folder_ / "taken" / "inside"));
  EXPECT_EQ(entries(), 1U);
}

TEST_F(File, AFolderThatCannotBeMadeIsAnOutputError) {
  ASSERT_TRUE(write_file(folder_ / "file", std::string("x")).has_value());
  const Result<void> written = write_file(folder_ / "file" / "below.txt", std::string("y"));
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error()[0].trouble, Trouble::output);
  EXPECT_EQ(append_line(folder_ / "file" / "below.txt", "y").error()[0].trouble, Trouble::output);
}

TEST_F(File, AFolderWithoutPermissionIsAnOutputError) {
  if (::geteuid() == 0) GTEST_SKIP() << "permissions do not hold for the super-user";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  const Result<void> written = write_file(folder_ / "a.txt", std::string("x"));
  fs::permissions(folder_, fs::perms::owner_all);
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error()[0].trouble, Trouble::output);
  EXPECT_EQ(entries(), 0U);
}

TEST_F(File, AMissingInputNamesPathAndReason) {
  const Result<std::string> read = read_file(folder_ / "none.toml");
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error()[0].trouble, Trouble::missing);
  EXPECT_NE(format(read.error()).find("none.toml: error: cannot read: No such file"),
            std::string::npos);
  EXPECT_EQ(read_file(folder_).error()[0].trouble, Trouble::missing);  // a folder is no input
}

TEST_F(File, AnInputBeyondTheLimitIsRefused) {
  ASSERT_TRUE(write_file(folder_ / "a.txt", std::string(100'000, 'x')).has_value());
  EXPECT_TRUE(read_file(folder_ / "a.txt", 100'000).has_value());
  const Result<std::string> read = read_file(folder_ / "a.txt", 99'999);
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error()[0].trouble, Trouble::missing);
}

TEST_F(File, LeftoversOfDeadProcessesAreRemovedAndNothingElse) {
  const pid_t dead = ::fork();
  ASSERT_GE(dead, 0);
  if (dead == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(dead, nullptr, 0), dead);
  const std::string gone = "." + std::to_string(dead) + ".part";
  const std::string alive = ".g.png." + std::to_string(::getpid()) + ".part";
  for (const std::string& name :
       {".f.png" + gone, ".manifest.jsonl" + gone, alive, "f.png" + gone, std::string(".f.part"),
        std::string(".f.x1.part"), std::string(".f.99999999999999.part"), std::string("f.png")})
    ASSERT_TRUE(write_file(folder_ / name, "x")) << name;
  fs::create_symlink("f.png", folder_ / (".link" + gone));
  remove_leftovers(folder_);
  remove_leftovers(folder_ / "none");
  EXPECT_FALSE(fs::exists(folder_ / (".f.png" + gone)));
  EXPECT_FALSE(fs::exists(folder_ / (".manifest.jsonl" + gone)));
  EXPECT_TRUE(fs::exists(folder_ / alive));
  EXPECT_TRUE(fs::exists(folder_ / "f.png"));
  EXPECT_EQ(entries(), 7U);
}

TEST_F(File, LinesAreAddedAtTheEnd) {
  ASSERT_TRUE(append_line(folder_ / "log", "one").has_value());
  ASSERT_TRUE(append_line(folder_ / "log", "two").has_value());
  EXPECT_EQ(read_file(folder_ / "log").value(), "one\ntwo\n");
}

TEST_F(File, ALinkPlantedAtTheTemporaryNameIsNotFollowed) {
  const std::string temporary = ".a.txt." + std::to_string(::getpid()) + ".part";
  ASSERT_TRUE(write_file(folder_ / "victim", std::string("whole")).has_value());
  fs::create_symlink("victim", folder_ / temporary);
  EXPECT_FALSE(write_file(folder_ / "a.txt", std::string("x")).has_value());
  EXPECT_EQ(read_file(folder_ / "victim").value(), "whole");
}

}  // namespace
}  // namespace flatray
