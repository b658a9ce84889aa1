#include "support/own_folder.h"

#include <unistd.h>

#include <string>

namespace flatray {
namespace {

std::filesystem::path folder_of_test() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(::testing::TempDir()) /
         (std::string("flatray_") + test->test_suite_name() + "." + test->name() + "_" +
          std::to_string(::getpid()));
}

}  // namespace

OwnFolder::OwnFolder() : folder_(folder_of_test()) {
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
}

OwnFolder::~OwnFolder() { std::filesystem::remove_all(folder_); }

}  // namespace flatray
