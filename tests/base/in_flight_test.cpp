#include "base/in_flight.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/file.h"
#include "support/paths.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

fs::path made(const char* name) {
  const fs::path path = fs::path(binary_path()) / name;
  EXPECT_TRUE(write_file(path, std::string("x")).has_value());
  return path;
}

TEST(InFlight, OnlyWhatHasNoNameOfItsOwnYetIsRemoved) {
  const fs::path kept = made("in_flight_test.kept"), early = made("in_flight_test.early"),
                 late = made("in_flight_test.late");
  const pid_t child = ::fork();  // what follows must end the program
  ASSERT_GE(child, 0);
  if (child == 0) {
    const InFlight first(early);
    { const InFlight done(kept); }
    const InFlight second(late);
    remove_in_flight();
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  EXPECT_TRUE(fs::exists(kept));
  EXPECT_FALSE(fs::exists(early));
  EXPECT_FALSE(fs::exists(late));
  fs::remove(kept);
}

}  // namespace
}  // namespace flatray
