#include "app/files/chunk_log.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "app/options/option_values.h"
#include "base/number_text.h"

namespace flatray {
namespace {

constexpr std::size_t kOfKey = 5;

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
  for (std::size_t i = 0; i < N; ++i) tally.*members[i] = row.counts[i];
  return tally;
}

// Those that are members, and those of far off values of t.
constexpr std::array kStabilityNames = {
    "rays",       "hits",       "wrong",      "t_not_nearest", "t_off",      "by_rationals",
    "missed",     "invented",   "other_wall", "watched",       "one_by_one", "worst_ulps",
    "timed",      "ns",         "objects",    "bytes",         "t_off_2^8",  "t_off_2^16",
    "t_off_2^24", "t_off_2^32", "t_off_2^40", "t_off_2^48"};

constexpr std::array kLeakNames = {"rays",    "bounces",     "leaks",   "corners",
                                   "wrong",   "wrong_t",     "asked",   "beside",
                                   "nothing", "through_end", "through", "invented"};

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

std::string ChunkLog::head() const {
  std::string line = "family,tracer,isa,seed,chunk";
  for (std::size_t i = 0; i <= format_.counts.size(); ++i) {
    if (i == format_.before_seconds) line += ",seconds";
    if (i < format_.counts.size()) line += fmt::format(",{}", format_.counts[i]);
  }
  if (format_.note != nullptr) line += fmt::format(",{}", format_.note);
  return line + ",check";
}

std::optional<std::pair<ChunkLog::Key, ChunkLog::Row>> ChunkLog::read_row(
    std::string_view line) const {
  const std::vector<std::string_view> cells = split(line, ',');
  const std::size_t counts = format_.counts.size(), notes = format_.note == nullptr ? 0 : 1;
  if (cells.size() != kOfKey + counts + 1 + notes) return std::nullopt;
  const auto seed = parse_whole(cells[3]), chunk = parse_whole(cells[4]);
  if (!seed || !chunk) return std::nullopt;
  Row row;
  for (std::size_t i = 0; i <= counts; ++i) {
    if (i == format_.before_seconds) {
      const auto seconds = parse_number(cells[kOfKey + i]);
      if (!seconds || *seconds < 0) return std::nullopt;
      continue;
    }
    const auto count = parse_whole(cells[kOfKey + i]);
    if (!count) return std::nullopt;
    row.counts.push_back(*count);
  }
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
  auto read = rows.read(*text);
  if (read) return rows;
  if (!outputs.force()) return fail(std::move(read));
  if (auto removed = rows.journal_->remove(); !removed) return fail(std::move(removed));
  rows.rows_.clear();
  return rows;
}

Result<void> ChunkLog::read(const std::string& text) {
  int number = 0, wrong = 0;
  each_line(text, [&](std::string_view line) {
    const bool is_head = ++number == 1;
    const auto row = unchecked(line);
    auto parsed = is_head || !row ? std::nullopt : read_row(*row);
    if (wrong == 0 && (is_head ? line != head() : !parsed)) wrong = number;
    if (parsed) keep(parsed->first, std::move(parsed->second));
  });
  if (wrong == 0) return {};
  return fail(named_place(fmt::format("{}:{}", journal_->path().string(), wrong)),
              "is not a row that this program writes",
              "name another folder; --force begins the file anew", Trouble::output);
}

Result<void> ChunkLog::add(const Key& key, const Row& row, double seconds) {
  keep(key, row);
  if (!journal_) return {};
  std::string line =
      fmt::format("{},{},{},{},{}", key.family, key.tracer, key.isa, key.seed, key.chunk);
  for (std::size_t i = 0; i <= row.counts.size(); ++i) {
    if (i == format_.before_seconds) line += fmt::format(",{:.3f}", seconds);
    if (i < row.counts.size()) line += fmt::format(",{}", row.counts[i]);
  }
  if (format_.note != nullptr) line += "," + row.note;
  return journal_->add(checked(line) + "\n");
}

const ChunkLog::Format StabilityRows::kFormat = {"stability.csv", kStabilityNames, 6,
                                                 &possible_stability, "first_wrong"};

ChunkLog::Row StabilityRows::row(const StabilityTally& tally) {
  ChunkLog::Row row = row_of(tally, kStabilityCounts);
  row.counts.insert(row.counts.end(), tally.off_by_far.begin(), tally.off_by_far.end());
  row.note = tally.first_wrong;
  return row;
}

StabilityTally StabilityRows::tally(const ChunkLog::Row& row) {
  StabilityTally tally = tally_of(row, kStabilityCounts);
  constexpr std::size_t kFar = kStabilityCounts.size();
  for (std::size_t i = 0; i < tally.off_by_far.size(); ++i)
    tally.off_by_far[i] = row.counts[kFar + i];
  tally.first_wrong = row.note;
  return tally;
}

const ChunkLog::Format LeakRows::kFormat = {"leaks.csv", kLeakNames, kLeakNames.size(),
                                            &possible_leaks};

ChunkLog::Row LeakRows::row(const LeakTally& tally) { return row_of(tally, kLeakCounts); }

LeakTally LeakRows::tally(const ChunkLog::Row& row) { return tally_of(row, kLeakCounts); }

}  // namespace flatray
