// What may be replaced, and what not.
#include "app/files/outputs.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/file.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public OwnFolder {
 protected:
  // Of a command with these operands.
  static Outputs outputs(bool force, std::vector<std::string> operands = {}) {
    std::map<std::string, Arguments::Given, std::less<>> given;
    if (force) given["force"] = {"--force", {}, {}};
    return Outputs(Arguments(std::move(given), std::move(operands)));
  }
  fs::path file(const std::string& content) const {
    EXPECT_TRUE(write_file(folder_ / "file", content));
    return folder_ / "file";
  }
};

const std::string kPng = "\x89PNG\r\n\x1a\n and more",
                  kProfile = R"({"schema":"flatray.profile/1"})",
                  kTable = "family,tracer,rays\nvertex,grid,7\n", kScene = "flatray = 1\n";

TEST_F(OutputFiles, AFileOfTheSameKindIsReplaced) {
  const Outputs plain = outputs(false);
  EXPECT_TRUE(plain.allow(folder_ / "none", kPng));
  for (const std::string& content : {kPng, kProfile, kTable, kScene}) {
    EXPECT_TRUE(plain.write(file(content), content + "x")) << content;
    EXPECT_EQ(read_file(folder_ / "file").value(), content + "x");
    EXPECT_TRUE(plain.allow(file(""), content)) << "empty";
  }
  EXPECT_TRUE(plain.allow(file("family,more,rays\n"), kTable)) << "a table with other columns";
  EXPECT_TRUE(plain.allow(file("{\"sch"), kProfile)) << "what a full disk left";
}

TEST_F(OutputFiles, AFileOfAnotherKindIsReplacedByForceOnly) {
  const std::vector<std::string> kinds = {kPng,
                                          kProfile,
                                          kTable,
                                          kScene,
                                          "time,volts\n1,2\n",
                                          R"({"frames":[]})",
                                          "#?RADIANCE\n",
                                          "\x7f"
                                          "ELF"};
  for (const std::string& there : kinds)
    for (const std::string& here : {kPng, kProfile, kTable}) {
      if (there == here) continue;
      const auto refused = outputs(false).write(file(there), here);
      ASSERT_FALSE(refused) << there << here;
      EXPECT_EQ(refused.error()[0].trouble, Trouble::output);
      EXPECT_EQ(refused.error()[0].hint, "name another file; --force replaces this one");
      EXPECT_EQ(read_file(folder_ / "file").value(), there);
      EXPECT_TRUE(outputs(false).allow(folder_ / "file", here, true)) << "as records tell";
      EXPECT_TRUE(outputs(true).write(file(there), here));
      EXPECT_EQ(read_file(folder_ / "file").value(), here);
    }
}

TEST_F(OutputFiles, AnInputIsReplacedByForceOnlyUnderWhateverName) {
  const fs::path input = file(kPng);
  fs::create_hard_link(input, folder_ / "other");
  fs::create_symlink("file", folder_ / "link");
  for (const char* operand : {"file", "other", "link"}) {
    const std::string named = folder_ / operand;
    EXPECT_FALSE(outputs(false, {named}).write(input, kPng)) << operand;
    EXPECT_TRUE(outputs(true, {named}).allow(input, kPng)) << operand;
  }
}

TEST_F(OutputFiles, LinksAreReplacedByForceOnlyAndPipesAndFoldersNever) {
  const fs::path target = file(kPng);
  fs::create_symlink("file", folder_ / "link");
  fs::create_symlink("nowhere", folder_ / "dangling");
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0666), 0);
  for (const char* name : {"link", "dangling", "pipe", "."})
    EXPECT_FALSE(outputs(false).allow(folder_ / name, kPng, true)) << name;
  for (const char* name : {"link", "dangling", "pipe", "."})
    EXPECT_FALSE(outputs(false).allow(folder_ / name, kPng)) << name;
  for (const char* name : {"pipe", ".", "/dev/null"})
    EXPECT_FALSE(outputs(true).allow(folder_ / name, kPng)) << name;
  EXPECT_TRUE(outputs(true).write(folder_ / "link", kPng + "new"));
  EXPECT_EQ(read_file(target).value(), kPng) << "the link was followed";
}

TEST_F(OutputFiles, WhatCannotBeWrittenIsRefusedInTheWordsOfTheWrite) {
  const fs::path taken = file(kPng), closed = folder_ / "closed", nowhere = folder_ / "link";
  fs::create_symlink("nowhere", nowhere);
  fs::create_directory(closed);
  fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
  for (const fs::path& path :
       {taken / "a.png", taken / "new" / "a.png", closed / "a.png", closed / "new" / "a.png",
        nowhere / "a.png", nowhere / "new" / "a.png", folder_ / "new" / "er" / "a.png"}) {
    const auto allowed = outputs(false).allow(path, kPng), written = write_file(path, kPng);
    EXPECT_EQ(allowed.has_value(), written.has_value()) << path;  // the superuser may
    if (allowed || written) continue;
    EXPECT_EQ(format(allowed.error()), format(written.error()));
  }
  EXPECT_FALSE(outputs(true).allow(taken / "a.png", kPng));
  fs::permissions(closed, fs::perms::owner_all);
}

TEST_F(OutputFiles, WayIsMadeForRecordsByForceOnly) {
  const fs::path path = file(kScene);
  EXPECT_FALSE(outputs(false).make_way(path, kTable));
  EXPECT_TRUE(fs::exists(path));
  EXPECT_TRUE(outputs(true).make_way(path, kTable));
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(outputs(true).make_way(file(kTable), kTable));
  EXPECT_TRUE(fs::exists(path)) << "its own rows stay";
}

}  // namespace
}  // namespace flatray
