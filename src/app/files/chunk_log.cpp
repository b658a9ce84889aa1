#include "app/files/chunk_log.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "app/options/option_values.h"
#include "base/number_text.h"

namespace flatray {
namespace {

constexpr std::size_t kOfKey = 5;

// Of a row: the key, the seconds and the note.
std::size_t cells_besides_counts(const ChunkLog::Format& format) {
  return kOfKey + 1 + (format.note == nullptr ? 0 : 1);
}

// Of a type whose counts are members.
template <class Tally, std::size_t N>
ChunkLog::Row row_of(const Tally& tally, const std::array<std::uint64_t Tally::*, N>& members) {
  ChunkLog::Row row;
  for (const auto member : members) row.counts.push_back(tally.*member);
  return row;
}

template <class Tally, std::size_t N>
Tally tally_of(const ChunkLog::Row& row, const std::array<std::uint64_t Tally::*, N>& members) {
  Tally tally;
  for (std::size_t i = 0; i < std::min(N, row.counts.size()); ++i)
    tally.*members[i] = row.counts[i];
  return tally;
}

// Those that are members, those of far off values of t, and what rows of before alone have: rays
// that were decided in whole numbers.
constexpr std::array kStabilityNames = {
    "rays",       "hits",       "wrong",      "t_not_nearest", "t_off",      "by_rationals",
    "missed",     "invented",   "other_wall", "watched",       "one_by_one", "worst_ulps",
    "timed",      "ns",         "objects",    "bytes",         "t_off_2^8",  "t_off_2^16",
    "t_off_2^24", "t_off_2^32", "t_off_2^40", "t_off_2^48",    "whole"};
constexpr std::array<std::size_t, 5> kStabilityWidths = {kStabilityNames.size(), 22, 11, 9, 6};

constexpr std::array kLeakNames = {"rays",    "bounces",     "leaks",   "corners",
                                   "wrong",   "wrong_t",     "asked",   "beside",
                                   "nothing", "through_end", "through", "invented"};
constexpr std::array<std::size_t, 1> kLeakWidths = {kLeakNames.size()};

bool is_family(const std::string& name, const auto& families) {
  return std::ranges::any_of(families, [&](const auto& family) { return name == family.name; });
}

// Of a family of now, with no more rays than a chunk has, and no more of anything than rays.
bool possible_stability(const ChunkLog::Key& key, const ChunkLog::Row& row) {
  const StabilityTally tally = StabilityRows::tally(row);
  static const std::vector<PairFamily> pairs = pair_families();  // of each row of a log
  const bool of_pairs = std::ranges::any_of(
      pairs, [&](const PairFamily& family) { return key.family == StabilityRows::pairs(family); });
  if (!of_pairs && !is_family(key.family, oracle::families())) return false;
  return tally.rays <= (of_pairs ? kPairsAChunk : kRaysAChunk) && tally.hits <= tally.rays &&
         tally.wrong <= tally.rays && tally.watched <= tally.rays && tally.timed <= tally.rays &&
         tally.one_by_one <= tally.watched;
}

bool possible_leaks(const ChunkLog::Key& key, const ChunkLog::Row& row) {
  const LeakTally tally = LeakRows::tally(row);
  return is_family(key.family, room_places()) && tally.rays <= kRaysALeakBlock &&
         tally.leaks <= tally.rays && tally.corners <= tally.rays &&
         tally.bounces <= tally.rays * kLeakBounces;
}

}  // namespace

void ChunkLog::keep(const Key& key, Row row) {
  if (!has(key, row.counts.front())) rows_.insert_or_assign(key, std::move(row));
}

std::string ChunkLog::header(std::size_t counts) const {
  std::string line = "family,tracer,isa,seed,chunk";
  for (std::size_t i = 0; i < counts; ++i) {
    if (i == format_.before_seconds) line += ",seconds";
    line += fmt::format(",{}", format_.counts[i]);
  }
  if (counts == format_.before_seconds) line += ",seconds";
  return format_.note == nullptr ? line : line + "," + format_.note;
}

// A row of before in the columns of now: what it did not count is empty.
std::string ChunkLog::padded(std::string_view line) const {
  const std::size_t cells = split(line, ',').size();
  const std::size_t missing = cells_besides_counts(format_) + format_.counts.size() - cells;
  const std::size_t end = format_.note == nullptr ? line.size() : line.rfind(',');
  return std::string(line).insert(end, missing, ',');
}

std::optional<std::pair<ChunkLog::Key, ChunkLog::Row>> ChunkLog::read_row(
    std::string_view line) const {
  const std::vector<std::string_view> cells = split(line, ',');
  const std::size_t others = cells_besides_counts(format_);
  const auto is_width = [&](std::size_t counts) {
    return std::ranges::find(format_.widths, counts) != format_.widths.end();
  };
  if (cells.size() < others || !is_width(cells.size() - others)) return std::nullopt;
  const auto seed = parse_whole(cells[3]), chunk = parse_whole(cells[4]);
  if (!seed || !chunk) return std::nullopt;
  Row row;
  bool ended = false;
  for (std::size_t i = 0; i <= cells.size() - others; ++i) {
    if (i == format_.before_seconds) {
      const auto seconds = parse_number(cells[kOfKey + i]);
      if (!seconds || *seconds < 0) return std::nullopt;
      continue;
    }
    const auto count = parse_whole(cells[kOfKey + i]);
    ended = ended || cells[kOfKey + i].empty();
    if (ended ? !cells[kOfKey + i].empty() : !count) return std::nullopt;
    if (!ended) row.counts.push_back(*count);
  }
  if (!is_width(row.counts.size())) return std::nullopt;
  if (format_.note != nullptr) row.note = cells.back();
  const Key key{std::string(cells[0]), std::string(cells[1]), std::string(cells[2]), *seed, *chunk};
  if (!format_.possible(key, row)) return std::nullopt;
  return std::pair{key, row};
}

Result<ChunkLog> ChunkLog::open(const Format& format, const std::optional<std::string>& folder,
                                const Outputs& outputs) {
  ChunkLog rows(format);
  if (!folder) return rows;
  const std::string head = rows.head() + "\n";
  rows.journal_.emplace(std::filesystem::path(*folder) / format.file, head);
  FLATRAY_TRY(allowed, outputs.make_way(rows.journal_->path(), head));
  FLATRAY_TRY(text, rows.journal_->read());
  if (const auto now = rows.read(*text)) {
    rows.old_ = *now != *text;
    return rows;
  } else if (!outputs.force()) {
    return tl::unexpected(now.error());
  }
  if (auto removed = rows.journal_->remove(); !removed) return fail(std::move(removed));
  rows.rows_.clear();
  return rows;
}

// The text in the columns of now.
Result<std::string> ChunkLog::read(const std::string& text) {
  if (text.empty()) return text;
  const auto is_header = [&](std::string_view line) {
    return line == head() || std::ranges::any_of(format_.widths, [&](std::size_t width) {
             return line == header(width);
           });
  };
  std::string now;
  int number = 0, wrong = 0;
  each_line(text, [&](std::string_view line) {
    ++number;
    const auto row = unchecked(line);
    auto parsed = number == 1 || !row ? std::nullopt : read_row(*row);
    if (wrong == 0 && (number == 1 ? !is_header(line) : !parsed)) wrong = number;
    if (parsed) keep(parsed->first, std::move(parsed->second));
    now += (parsed ? checked(padded(*row)) : head()) + "\n";
  });
  if (wrong == 0) return now;
  return fail(named_place(fmt::format("{}:{}", journal_->path().string(), wrong)),
              "is not a row that this program writes",
              "name another folder; --force begins the file anew", Trouble::output);
}

Result<void> ChunkLog::add(const Key& key, const Row& row, double seconds) {
  keep(key, row);
  if (!journal_) return {};
  if (std::exchange(old_, false)) {
    auto merged = journal_->merge([this](const std::string& text) { return read(text); });
    if (!merged) return merged;
  }
  std::string line =
      fmt::format("{},{},{},{},{}", key.family, key.tracer, key.isa, key.seed, key.chunk);
  for (std::size_t i = 0; i <= row.counts.size(); ++i) {
    if (i == format_.before_seconds) line += fmt::format(",{:.3f}", seconds);
    if (i < row.counts.size()) line += fmt::format(",{}", row.counts[i]);
  }
  if (format_.note != nullptr) line += "," + row.note;
  return journal_->add(checked(padded(line)) + "\n");
}

const ChunkLog::Format StabilityRows::kFormat = {
    "stability.csv", kStabilityNames, 6, kStabilityWidths, &possible_stability, "first_wrong"};

ChunkLog::Row StabilityRows::row(const StabilityTally& tally) {
  ChunkLog::Row row = row_of(tally, kStabilityCounts);
  row.counts.insert(row.counts.end(), tally.off_by_far.begin(), tally.off_by_far.end());
  row.note = tally.first_wrong;
  return row;
}

StabilityTally StabilityRows::tally(const ChunkLog::Row& row) {
  StabilityTally tally = tally_of(row, kStabilityCounts);
  constexpr std::size_t kFar = kStabilityCounts.size();
  for (std::size_t i = kFar; i < std::min(row.counts.size(), kFar + tally.off_by_far.size()); ++i)
    tally.off_by_far[i - kFar] = row.counts[i];
  tally.first_wrong = row.note;
  return tally;
}

const ChunkLog::Format LeakRows::kFormat = {"leaks.csv", kLeakNames, kLeakNames.size(), kLeakWidths,
                                            &possible_leaks};

ChunkLog::Row LeakRows::row(const LeakTally& tally) { return row_of(tally, kLeakCounts); }

LeakTally LeakRows::tally(const ChunkLog::Row& row) { return tally_of(row, kLeakCounts); }

}  // namespace flatray
