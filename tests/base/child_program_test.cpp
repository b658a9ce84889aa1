#include "base/child_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>

#include "base/file.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

class ChildPrograms : public OwnFolder {
 protected:
  void SetUp() override { ::signal(SIGPIPE, SIG_IGN); }
  // A shell that knows its output as $0.
  Result<ChildProgram> shell(const char* script) {
    output_ = Descriptor(::open((folder_ / "out").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    return ChildProgram::start({"sh", "-c", script}, output_);
  }
  Descriptor output_{-1};
};

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

TEST_F(ChildPrograms, WritesWhatItIsFedIntoTheFileWhateverItsName) {
  auto cat = shell("cat > $0");
  ASSERT_TRUE(cat);
  const std::string much(1 << 20, 'x');
  std::filesystem::rename(folder_ / "out", folder_ / "moved");
  EXPECT_TRUE(cat->feed(bytes(much)));
  EXPECT_TRUE(cat->feed(bytes("end")));
  ASSERT_TRUE(cat->finish());
  EXPECT_EQ(read_file(folder_ / "moved").value(), much + "end");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(ChildPrograms, HowItEndedAndItsLastLineAreTold) {
  auto failing = shell("echo first; echo no codec >&2; exit 7");
  ASSERT_TRUE(failing);
  const auto ended = failing->finish();
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().front().message, "ended with exit code 7");
  EXPECT_EQ(ended.error().front().hint, "it said: no codec");
  EXPECT_EQ(ended.error().front().trouble, Trouble::output);
  auto killed = shell("kill -9 $$");
  ASSERT_TRUE(killed);
  EXPECT_EQ(killed->finish().error().front().message, "was ended by signal 9");
}

TEST_F(ChildPrograms, OneThatReadsNoMoreIsNotFed) {
  auto deaf = shell("exec 0<&-; sleep 0.1");
  ASSERT_TRUE(deaf);
  const std::string much(1 << 20, 'x');
  EXPECT_FALSE(deaf->feed(bytes(much)));
  EXPECT_TRUE(deaf->finish());
}

TEST_F(ChildPrograms, OneThatIsNotWaitedForIsEnded) {
  const auto start = std::chrono::steady_clock::now();
  { ASSERT_TRUE(shell("exec sleep 60")); }
  auto stopped = shell("exec sleep 60");
  ASSERT_TRUE(stopped);
  EXPECT_FALSE(stopped->finish([] { return true; }));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST_F(ChildPrograms, WhatIsNotThereIsUnavailable) {
  const auto missing = ChildProgram::start({"no-such-program-anywhere"}, Descriptor(0));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().front().trouble, Trouble::unavailable);
  EXPECT_EQ(missing.error().front().message, "cannot be started: No such file or directory");
}

}  // namespace
}  // namespace flatray
