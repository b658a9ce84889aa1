#include "app/query/query.h"

#include <algorithm>
#include <optional>

#include "base/check.h"
#include "fuzz/target.h"

// A line of JSON and its answer, which is one line whatever was asked. Orbits may be long: they are
// only stopped as hanging.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text = flatray::text_of(data, size);
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::optional<flatray::OneSecond> limit;
  if (text.find("bounces") == std::string::npos) limit.emplace();
  const flatray::Answer answer = flatray::answer_line(text);
  FLATRAY_CHECK(answer.line.find('\n') == std::string::npos, "an answer is one line");
  FLATRAY_CHECK(answer.line.starts_with("{") && answer.line.ends_with("}"), "no object");
  FLATRAY_CHECK(answer.ok == (answer.line.find("\"error\":") == std::string::npos) ||
                    text.find("error") != std::string::npos,
                "a mistake and an answer");
  return 0;
}
