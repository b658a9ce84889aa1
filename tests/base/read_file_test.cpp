#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/file.h"
#include "support/paths.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& path, const ReadLimits& limits = {}) {
  const Result<std::string> read = read_file(path, limits);
  return read ? "" : format(read.error());
}

TEST(ReadFile, APipeOrDeviceThatCouldKeepTheReaderIsRefusedUnlessAskedFor) {
  const fs::path pipe = fs::path(binary_path()) / "read_file_test.pipe";
  fs::remove(pipe);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
  for (const fs::path& endless : {pipe, fs::path("/dev/zero")})
    EXPECT_NE(refusal(endless).find("is not a plain file"), std::string::npos) << endless;
  EXPECT_NE(refusal("/dev/zero", {1000, "raise it", true}).find("is larger than 1000 bytes"),
            std::string::npos);
  fs::remove(pipe);
}

TEST(ReadFile, AFileLargerThanTheLimitIsRefusedByItsSize) {
  const fs::path path = fs::path(binary_path()) / "read_file_test.large";
  ASSERT_TRUE(write_file(path, std::string("begin")).has_value());
  fs::resize_file(path, std::uintmax_t{1} << 40);  // it takes no room, and no memory holds it
  EXPECT_NE(refusal(path).find("is larger than 1073741824 bytes"), std::string::npos);
  const Result<std::string> begun =
      read_file(path, {std::size_t{1} << 41, {}, false, {"\x89PNG\r\n\x1a\n", "#?"}});
  ASSERT_TRUE(begun.has_value());
  EXPECT_TRUE(begun->starts_with("begin"));
  EXPECT_LT(begun->size(), 1'000'000U);  // no PNG: the rest was not read
  fs::remove(path);
}

TEST(ReadFile, WhatBeginsAsItMustIsReadWhole) {
  const fs::path path = fs::path(binary_path()) / "read_file_test.whole";
  const std::string content = "begin" + std::string(200'000, 'x');
  ASSERT_TRUE(write_file(path, content).has_value());
  EXPECT_EQ(read_file(path, {1 << 20, {}, false, {"begin"}}).value(), content);
  ASSERT_TRUE(write_file(path, std::string("beg")).has_value());
  EXPECT_EQ(read_file(path, {1 << 20, {}, false, {"begin"}}).value(), "beg");
  fs::remove(path);
}

}  // namespace
}  // namespace flatray
