#include "app/query/line_stream.h"

#include "base/check.h"
#include "base/file.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

using Lines = OwnFolder;

// The lengths of a file's lines; -1 of one that is too long.
std::vector<int> lengths(const std::filesystem::path& file) {
  Result<LineStream> stream = LineStream::open(file.string());
  FLATRAY_CHECK(stream.has_value(), file.string());
  std::vector<int> all;
  while (true) {
    const auto lines = stream->next();
    FLATRAY_CHECK(lines.has_value(), file.string());
    if (lines->empty()) return all;
    for (const StreamLine& line : *lines)
      all.push_back(line.too_long ? -1 : static_cast<int>(line.text.size()));
  }
}

// Lines before it move the places where blocks of it end.
TEST_F(Lines, TheLongestDoesNotDependOnHowItArrives) {
  constexpr int kLongest = LineStream::kLongest;
  for (const int before : {0, 7, (1 << 18) - 1})
    for (const int beyond : {0, 1, 1 << 17})
      for (const char* end : {"", "\nx\n"}) {
        std::string text(static_cast<std::size_t>(before), '.');
        if (before > 0) text += '\n';
        text.append(static_cast<std::size_t>(kLongest + beyond), '[').append(end);
        ASSERT_TRUE(write_file(folder_ / "lines", text));
        std::vector<int> expected;
        if (before > 0) expected.push_back(before);
        expected.push_back(beyond > 0 ? -1 : kLongest + beyond);
        if (*end != '\0') expected.push_back(1);
        EXPECT_EQ(lengths(folder_ / "lines"), expected) << before << ' ' << beyond << end;
      }
}

}  // namespace
}  // namespace flatray
