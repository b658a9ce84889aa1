#pragma once
#include <gtest/gtest.h>

#include <filesystem>

namespace flatray {

// A test with a folder of its own, empty at first and gone at the end.
class OwnFolder : public ::testing::Test {
 protected:
  OwnFolder();
  ~OwnFolder() override;

  const std::filesystem::path folder_;
};

}  // namespace flatray
