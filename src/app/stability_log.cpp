#include "app/stability_log.h"

#include <fmt/core.h>

#include "app/option_values.h"
#include "base/file.h"

namespace flatray {
namespace {

constexpr const char* kHeader =
    "family,tracer,isa,seed,chunk,rays,hits,wrong,t_not_nearest,t_off,by_rationals,seconds,"
    "missed,invented,other_wall,first_wrong";
// Without what kinds of wrong there are, as rows were before: still read.
constexpr std::string_view kShortHeader =
    "family,tracer,isa,seed,chunk,rays,hits,wrong,t_not_nearest,t_off,by_rationals,seconds,"
    "first_wrong";
constexpr std::size_t kColumns = 16, kShortColumns = 13, kFirstCount = 5, kFirstKind = 12;

constexpr std::array kCounts = {&StabilityTally::rays,        &StabilityTally::hits,
                                &StabilityTally::wrong,       &StabilityTally::not_nearest,
                                &StabilityTally::off_by_more, &StabilityTally::by_rationals};
constexpr std::array kKinds = {&StabilityTally::missed, &StabilityTally::invented,
                               &StabilityTally::other_wall};

template <class Counts>
bool read_counts(std::span<const std::string_view> cells, const Counts& counts,
                 StabilityTally& tally) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto count = parse_whole(cells[i]);
    if (!count) return false;
    tally.*counts[i] = *count;
  }
  return true;
}

std::optional<std::pair<StabilityLog::Key, StabilityTally>> read_row(std::string_view line) {
  const std::vector<std::string_view> cells = split_commas(line);
  if (cells.size() != kColumns && cells.size() != kShortColumns) return std::nullopt;
  const auto seed = parse_whole(cells[3]), chunk = parse_whole(cells[4]);
  if (!seed || !chunk) return std::nullopt;
  StabilityTally tally;
  const std::span all(cells);
  if (!read_counts(all.subspan(kFirstCount), kCounts, tally)) return std::nullopt;
  if (cells.size() == kColumns && !read_counts(all.subspan(kFirstKind), kKinds, tally))
    return std::nullopt;
  tally.first_wrong = cells.back();
  return std::pair{StabilityLog::Key{std::string(cells[0]), std::string(cells[1]),
                                     std::string(cells[2]), *seed, *chunk},
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
  const bool there = std::filesystem::exists(log.path_);
  auto done = there ? log.read() : append_line(log.path_, kHeader);
  if (!done) return fail(std::move(done));
  return log;
}

Result<void> StabilityLog::read() {
  const auto text = read_whole_lines(path_);
  if (!text) return tl::unexpected(text.error());
  std::string_view rest = *text;
  if (rest.empty()) return append_line(path_, kHeader);
  for (int line = 1; !rest.empty(); ++line) {
    const std::string_view row = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), row.size() + 1));
    if (line == 1 && (row == kHeader || row == kShortHeader)) continue;
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
  std::string row =
      fmt::format("{},{},{},{},{}", key.family, key.tracer, key.isa, key.seed, key.chunk);
  for (const auto count : kCounts) row += fmt::format(",{}", tally.*count);
  row += fmt::format(",{:.3f}", seconds);
  for (const auto kind : kKinds) row += fmt::format(",{}", tally.*kind);
  return append_line(path_, row + "," + tally.first_wrong);
}

StabilityTally StabilityLog::sum(Key key, std::uint64_t chunks) const {
  StabilityTally sum;
  for (key.chunk = 0; key.chunk < chunks; ++key.chunk)
    if (const auto row = rows_.find(key); row != rows_.end()) sum.add(row->second);
  return sum;
}

}  // namespace flatray
