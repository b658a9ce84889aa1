#include "base/isa.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace flatray {
namespace {

// FLATRAY_ISA as given for one test, then as it was.
class WantedIsa {
 public:
  explicit WantedIsa(const char* value) {
    if (const char* was = std::getenv("FLATRAY_ISA")) before_ = was;
    ::setenv("FLATRAY_ISA", value, 1);
  }
  WantedIsa(const WantedIsa&) = delete;
  WantedIsa& operator=(const WantedIsa&) = delete;
  ~WantedIsa() {
    if (before_)
      ::setenv("FLATRAY_ISA", before_->c_str(), 1);
    else
      ::unsetenv("FLATRAY_ISA");
  }

 private:
  std::optional<std::string> before_;
};

TEST(Isa, HasANameForEveryTier) {
  EXPECT_STREQ(isa_name(Isa::portable), "portable");
  EXPECT_STREQ(isa_name(Isa::baseline), "baseline");
  EXPECT_STREQ(isa_name(Isa::avx2), "avx2");
  EXPECT_STREQ(isa_name(Isa::avx512), "avx512");
}

TEST(Isa, PortableRunsEverywhereAndComesFirst) {
  const std::vector<Isa> have = available_isas();
  ASSERT_FALSE(have.empty());
  EXPECT_EQ(have.front(), Isa::portable);
  EXPECT_TRUE(std::is_sorted(have.begin(), have.end()));
}

TEST(Isa, TheEnvironmentChoosesAmongTheAvailable) {
  for (const Isa isa : available_isas()) {
    const WantedIsa wanted(isa_name(isa));
    const Result<Isa> chosen = chosen_isa();
    ASSERT_TRUE(chosen.has_value());
    EXPECT_EQ(*chosen, isa);
  }
}

TEST(Isa, UnsetOrEmptyIsTheFastest) {
  const WantedIsa wanted("");
  EXPECT_EQ(*chosen_isa(), available_isas().back());
}

TEST(Isa, AnUnknownTierIsAUsageErrorThatNamesTheKnown) {
  const WantedIsa wanted("sse9");
  const Result<Isa> chosen = chosen_isa();
  ASSERT_FALSE(chosen.has_value());
  EXPECT_EQ(chosen.error()[0].trouble, Trouble::usage);
  EXPECT_NE(chosen.error()[0].message.find("sse9"), std::string::npos);
  EXPECT_NE(chosen.error()[0].hint.find("portable, baseline, avx2 or avx512"), std::string::npos);
}

}  // namespace
}  // namespace flatray
