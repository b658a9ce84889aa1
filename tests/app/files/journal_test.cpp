// Records that several writers make longer at once.
#include "app/files/journal.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "support/own_folder.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

class JournalFile : public OwnFolder {
 protected:
  const Journal journal_{folder_ / "deep" / "list", "head\n"};
};

TEST_F(JournalFile, LinesStandBelowTheHeadInTheOrderOfTheirCalls) {
  EXPECT_EQ(journal_.read().value(), "");
  EXPECT_FALSE(fs::exists(folder_ / "deep")) << "reading writes nothing";
  ASSERT_TRUE(journal_.add("one\n"));
  ASSERT_TRUE(journal_.add("two\nthree\n"));
  EXPECT_EQ(journal_.read().value(), "head\none\ntwo\nthree\n");
}

TEST_F(JournalFile, AStepThatFailsAddsNothing) {
  ASSERT_TRUE(journal_.add("one\n"));
  EXPECT_FALSE(journal_.add("two\n", [] { return Result<void>(fail(named_place("x"), "no")); }));
  EXPECT_EQ(journal_.read().value(), "head\none\n");
}

TEST_F(JournalFile, WhatAFullDiskLeftOfALineDoesNotCountAndGoesWithTheNext) {
  ASSERT_TRUE(journal_.add("one\n"));
  std::ofstream(journal_.path(), std::ios::app) << "tw";
  EXPECT_EQ(journal_.read().value(), "head\none\n");
  EXPECT_EQ(read_file(journal_.path()).value(), "head\none\ntw") << "reading writes nothing";
  ASSERT_TRUE(journal_.add("three\n"));
  EXPECT_EQ(journal_.read().value(), "head\none\nthree\n");
}

TEST_F(JournalFile, AMergeThatChangesNothingLeavesTheFile) {
  ASSERT_TRUE(journal_.add("one\n"));
  const auto number = [&] {
    struct stat status {};
    EXPECT_EQ(::stat(journal_.path().c_str(), &status), 0);
    return status.st_ino;
  };
  const auto before = number();
  ASSERT_TRUE(journal_.merge([](const std::string& text) { return text; }));
  EXPECT_EQ(number(), before);
  ASSERT_TRUE(journal_.merge([](const std::string& text) { return text + "two\n"; }));
  EXPECT_NE(number(), before);
  EXPECT_EQ(journal_.read().value(), "head\none\ntwo\n");
}

TEST_F(JournalFile, OneThatIsRemovedBeginsAnew) {
  ASSERT_TRUE(journal_.remove()) << "of none";
  ASSERT_TRUE(journal_.add("one\n"));
  ASSERT_TRUE(journal_.remove());
  EXPECT_FALSE(fs::exists(journal_.path()));
  ASSERT_TRUE(journal_.add("two\n"));
  EXPECT_EQ(journal_.read().value(), "head\ntwo\n");
  ASSERT_TRUE(journal_.remove());
  fs::create_directories(journal_.path() / "inside");
  EXPECT_EQ(journal_.remove().error()[0].trouble, Trouble::output);
}

// Four processes, two of which replace the file all the time: no line is lost, none is torn.
TEST_F(JournalFile, ProcessesLoseNoLineOfEachOther) {
  constexpr int kProcesses = 4, kLines = 100;
  std::vector<pid_t> children;
  for (int process = 0; process < kProcesses; ++process) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    for (int i = 0; i < kLines; ++i) {
      const std::string line = fmt::format("{} {}\n", process, i);
      const auto done = process % 2 == 0
                            ? journal_.add(line, {}, Journal::Flush::later)
                            : journal_.merge([&](const std::string& text) { return text + line; });
      if (!done) ::_exit(1);
    }
    ::_exit(0);
  }
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  std::set<std::string> lines;
  each_line(journal_.read().value(), [&](std::string_view line) { lines.emplace(line); });
  lines.erase("head");
  EXPECT_EQ(lines.size(), static_cast<std::size_t>(kProcesses * kLines));
}

TEST_F(JournalFile, AHardLinkKeepsWhatItHas) {
  ASSERT_TRUE(journal_.add("one\n"));
  fs::create_hard_link(journal_.path(), folder_ / "copy");
  ASSERT_TRUE(journal_.add("two\n"));
  EXPECT_EQ(read_file(folder_ / "copy").value(), "head\none\n");
  EXPECT_EQ(journal_.read().value(), "head\none\ntwo\n");
}

TEST_F(JournalFile, LinksPipesAndFoldersAreRefusedAtOnce) {
  ASSERT_TRUE(write_file(folder_ / "victim", std::string("whole\n")));
  fs::create_symlink("victim", folder_ / "link");
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0666), 0);
  fs::create_directory(folder_ / "folder");
  for (const char* name : {"link", "pipe", "folder"}) {
    const Journal journal(folder_ / name);
    EXPECT_EQ(journal.read().error()[0].trouble, Trouble::output) << name;
    EXPECT_EQ(journal.add("x\n").error()[0].trouble, Trouble::output) << name;
    EXPECT_FALSE(journal.merge([](const std::string& text) { return text + "x\n"; })) << name;
  }
  EXPECT_EQ(read_file(folder_ / "victim").value(), "whole\n");
}

const std::string kOne = R"({"seed":1,"size":"64x48"})", kTwo = R"({"seed":2,"size":"64x48"})";

TEST_F(JournalFile, AClaimIsSharedByRunsOfOneSettingAndRefusedToOthers) {
  {
    const auto one = Claim::take(folder_, "f_#.png", kOne, false);
    const auto again = Claim::take(folder_, "f_#.png", kOne, false);
    ASSERT_TRUE(one && again);
    const auto other = Claim::take(folder_, "f_#.png", kTwo, false);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error()[0].message, "another run is at work on it: its seed is 1, not 2");
    EXPECT_EQ(other.error()[0].trouble, Trouble::output);
    EXPECT_TRUE(Claim::take(folder_, "g_#.png", kTwo, false)) << "another pattern";
    EXPECT_TRUE(one->expect_held());
    remove_leftovers(folder_);
    EXPECT_TRUE(one->expect_held()) << "it lives";
  }
  EXPECT_TRUE(fs::is_empty(folder_)) << "claims that ended are gone";
  EXPECT_TRUE(Claim::take(folder_, "f_#.png", kTwo, false));
}

TEST_F(JournalFile, AClaimTakenByForceIsLostToTheOthers) {
  const auto one = Claim::take(folder_, "f_#.png", kOne, false);
  const auto other = Claim::take(folder_, "f_#.png", kTwo, true);
  ASSERT_TRUE(one && other);
  EXPECT_FALSE(one->expect_held());
  EXPECT_TRUE(other->expect_held());
}

TEST_F(JournalFile, AClaimOfADeadRunIsNobodysAndAPlantedOneWritesNowhereElse) {
  ASSERT_TRUE(write_file(folder_ / "victim", std::string("whole")));
  fs::create_hard_link(folder_ / "victim", folder_ / part_name("f_#.png", 0));
  EXPECT_TRUE(Claim::take(folder_, "f_#.png", kOne, false));
  EXPECT_EQ(read_file(folder_ / "victim").value(), "whole");
  ASSERT_TRUE(write_file(folder_ / part_name("f_#.png", 0), kTwo));
  EXPECT_TRUE(Claim::take(folder_, "f_#.png", kOne, false));
  fs::create_symlink("victim", folder_ / part_name("f_#.png", 0));
  EXPECT_FALSE(Claim::take(folder_, "f_#.png", kOne, false));
  EXPECT_EQ(read_file(folder_ / "victim").value(), "whole");
}

TEST(Differences, AreNamedWithBothValues) {
  EXPECT_EQ(differences(kOne, kOne), "");
  EXPECT_EQ(differences(R"({"seed":1})", kTwo),
            "its seed is 1, not 2; its size is none, not \"64x48\"");
  EXPECT_EQ(differences("a text of before", kTwo), "of another version");
}

}  // namespace
}  // namespace flatray
