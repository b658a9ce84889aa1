#include "base/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/own_folder.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

class File : public OwnFolder {
 protected:
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
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

TEST_F(File, AFileIsThereUnderItsNameWhenItTakesIt) {
  const std::string content(1 << 16, 'x');
  {
    auto file = NewFile::write(folder_ / "a.txt", std::as_bytes(std::span(content)));
    ASSERT_TRUE(file.has_value());
    EXPECT_FALSE(fs::exists(folder_ / "a.txt"));
    EXPECT_TRUE(leftovers(folder_).empty()) << "its writer lives";
    EXPECT_TRUE(file->take_name().has_value());
  }
  EXPECT_EQ(read_file(folder_ / "a.txt").value(), content);
  EXPECT_TRUE(flush_file(folder_ / "a.txt").has_value());
  { const auto never = NewFile::write(folder_ / "b.txt", std::as_bytes(std::span(content))); }
  EXPECT_EQ(entries(), 1U);
  EXPECT_EQ(flush_file(folder_ / "none.txt").error()[0].trouble, Trouble::output);
}

TEST_F(File, MissingFoldersAreMade) {
  const fs::path deep = folder_ / "a" / "b" / "c.txt";
  ASSERT_TRUE(write_file(deep, std::string("x")).has_value());
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
  EXPECT_TRUE(read_file(folder_ / "a.txt", {100'000}).has_value());
  const Result<std::string> read = read_file(folder_ / "a.txt", {99'999});
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error()[0].trouble, Trouble::missing);
}

// Containers that share a folder have equal process numbers: only the lock tells who lives.
TEST_F(File, WhatNobodyHoldsLockedIsLeftOverAndNothingElse) {
  const std::string gone = part_name("f.png", 0x123456789abcdef0);
  EXPECT_EQ(gone, ".f.png.123456789abcdef0.part");
  const std::vector<std::string> others = {
      "f.png.0000000000000000.part", ".f.part",        "f.png", ".f.000000000000000g.part",
      ".0000000000000000.part",      ".f.0000000.part"};
  for (const std::string& name : others) ASSERT_TRUE(write_file(folder_ / name, "x")) << name;
  ASSERT_TRUE(write_file(folder_ / gone, "x"));
  fs::create_symlink("f.png", folder_ / part_name("link", 1));
  ASSERT_EQ(::mkfifo((folder_ / part_name("pipe", 1)).c_str(), 0666), 0);
  const auto alive = NewFile::write(folder_ / "g.png", {});
  ASSERT_TRUE(alive.has_value());
  EXPECT_EQ(leftovers(folder_), std::vector<fs::path>{folder_ / gone});
  remove_leftovers(folder_);
  remove_leftovers(folder_ / "none");
  EXPECT_FALSE(fs::exists(folder_ / gone));
  EXPECT_EQ(entries(), others.size() + 3);
}

TEST_F(File, AllThatStandsInAFolderIsToldByName) {
  fs::create_directories(folder_ / "b" / "inside");
  fs::create_symlink("nowhere", folder_ / "c");
  for (const char* name : {"d", ".a"}) ASSERT_TRUE(write_file(folder_ / name, std::string()));
  EXPECT_EQ(files_in(folder_),
            (std::vector<fs::path>{folder_ / ".a", folder_ / "b", folder_ / "c", folder_ / "d"}));
  EXPECT_TRUE(files_in(folder_ / "none").empty());
}

TEST_F(File, NamesOfTwoWritersOfOneProcessNumberDiffer) {
  const auto one = NewFile::write(folder_ / "a.txt", {});
  const auto two = NewFile::write(folder_ / "a.txt", {});
  ASSERT_TRUE(one && two);
  EXPECT_EQ(entries(), 2U);
}

TEST_F(File, OnlyWhatHasTheNameIsReplacedNeitherLinksNorHardLinksLeadAnywhere) {
  ASSERT_TRUE(write_file(folder_ / "victim", std::string("whole")).has_value());
  fs::create_symlink("victim", folder_ / "link");
  fs::create_hard_link(folder_ / "victim", folder_ / "hard");
  ASSERT_TRUE(write_file(folder_ / "link", std::string("x")).has_value());
  ASSERT_TRUE(write_file(folder_ / "hard", std::string("x")).has_value());
  EXPECT_EQ(read_file(folder_ / "victim").value(), "whole");
  EXPECT_EQ(read_regular_file(folder_ / "link").value(), "x");
}

TEST_F(File, PipesLinksAndFoldersAreNoRegularFilesAndNothingWaitsForThem) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0666), 0);
  ASSERT_TRUE(write_file(folder_ / "file", std::string("x")).has_value());
  fs::create_symlink("file", folder_ / "link");
  for (const char* name : {"pipe", "link", ".", "none"}) {
    EXPECT_EQ(read_regular_file(folder_ / name).error()[0].trouble, Trouble::missing) << name;
    EXPECT_EQ(flush_file(folder_ / name).error()[0].trouble, Trouble::output) << name;
  }
  EXPECT_FALSE(read_regular_file("/dev/zero").has_value());
}

}  // namespace
}  // namespace flatray
