#include "app/stability_log.h"

#include <fmt/core.h>

#include "app/option_values.h"
#include "base/file.h"

namespace flatray {
namespace {

constexpr const char* kHeader =
    "family,tracer,seed,chunk,rays,hits,wrong,t_not_nearest,t_off,by_rationals,seconds,first_wrong";
constexpr std::size_t kColumns = 12, kFirstCount = 4;

using Counts = std::array<std::uint64_t StabilityTally::*, 6>;
constexpr Counts kCounts = {&StabilityTally::rays,        &StabilityTally::hits,
                            &StabilityTally::wrong,       &StabilityTally::not_nearest,
                            &StabilityTally::off_by_more, &StabilityTally::by_rationals};

std::optional<std::pair<StabilityLog::Key, StabilityTally>> read_row(std::string_view line) {
  const std::vector<std::string_view> cells = split_commas(line);
  if (cells.size() < kColumns) return std::nullopt;
  const auto seed = parse_whole(cells[2]), chunk = parse_whole(cells[3]);
  if (!seed || !chunk) return std::nullopt;
  StabilityTally tally;
  for (std::size_t i = 0; i < kCounts.size(); ++i) {
    const auto count = parse_whole(cells[kFirstCount + i]);
    if (!count) return std::nullopt;
    tally.*kCounts[i] = *count;
  }
  tally.first_wrong = cells[kColumns - 1];
  return std::pair{StabilityLog::Key{std::string(cells[0]), std::string(cells[1]), *seed, *chunk},
                   tally};
}

}  // namespace

Result<StabilityLog> StabilityLog::open(const std::optional<std::string>& folder) {
  StabilityLog log;
  if (!folder) return log;
  log.path_ = std::filesystem::path(*folder) / "stability.csv";
  std::error_code error;
  std::filesystem::create_directories(*folder, error);
  if (error) return fail(named_place(*folder), error.message(), "", Trouble::output);
  auto done = std::filesystem::exists(log.path_) ? log.read() : append_line(log.path_, kHeader);
  if (!done) return fail(std::move(done));
  return log;
}

Result<void> StabilityLog::read() {
  const auto text = read_file(path_);
  if (!text) return tl::unexpected(text.error());
  std::string_view rest = *text;
  for (int line = 1; !rest.empty(); ++line) {
    const std::string_view row = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), row.size() + 1));
    if (line == 1 && row == kHeader) continue;
    auto parsed = read_row(row);
    if (line == 1 || !parsed)
      return fail(named_place(fmt::format("{}:{}", path_.string(), line)),
                  "is no row of this program", "move the file away, or name another folder");
    rows_.insert(std::move(*parsed));
  }
  return {};
}

Result<void> StabilityLog::add(const Key& key, const StabilityTally& tally, double seconds) {
  rows_.emplace(key, tally);
  if (path_.empty()) return {};
  std::string row = fmt::format("{},{},{},{}", key.family, key.tracer, key.seed, key.chunk);
  for (const auto count : kCounts) row += fmt::format(",{}", tally.*count);
  return append_line(path_, row + fmt::format(",{:.3f},{}", seconds, tally.first_wrong));
}

StabilityTally StabilityLog::sum(const std::string& family, const std::string& tracer,
                                 std::uint64_t seed, std::uint64_t chunks) const {
  StabilityTally sum;
  for (std::uint64_t chunk = 0; chunk < chunks; ++chunk)
    if (const auto row = rows_.find({family, tracer, seed, chunk}); row != rows_.end())
      sum.add(row->second);
  return sum;
}

}  // namespace flatray
