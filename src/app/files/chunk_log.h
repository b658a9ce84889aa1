#pragma once
#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/files/journal.h"
#include "app/files/outputs.h"
#include "app/interrupt.h"
#include "base/parallel.h"
#include "base/result.h"
#include "study/stability/leaks.h"
#include "study/stability/pair_stability.h"
#include "study/stability/stability.h"

namespace flatray {

/// What is counted, rays or pairs, in chunks of `size`: the last may have fewer.
struct Chunks {
  std::uint64_t count, size;
  std::uint64_t number() const { return (count + size - 1) / size; }
  std::uint64_t in(std::uint64_t chunk) const { return std::min(size, count - chunk * size); }
};

/// Rows of a file, one for each chunk checked: what a run that was stopped goes on from. Of two
/// rows of a chunk that of more rays counts. A last row without its end, as a full disk leaves it,
/// does not count. The last column is a hash of the row; a row without one is read, too.
///
/// Needs   a folder of its own for every build: rows tell tracers and tiers apart, not programs.
class ChunkLog {
 public:
  struct Key {
    std::string family, tracer, isa;
    std::uint64_t seed, chunk;
    auto operator<=>(const Key&) const = default;
  };
  struct Row {
    std::vector<std::uint64_t> counts;  ///< of rays first
    std::string note;
  };
  /// Its columns, after those of the key: counts, the seconds after some of them, and a note.
  struct Format {
    const char* file;
    std::span<const char* const> counts;
    std::size_t before_seconds;
    bool (*possible)(const Key& key, const Row& row);  ///< whether a run may have counted so
    const char* note = nullptr;
  };

  /// The rows that are in `folder`, or none without a folder. Writes nothing.
  /// Error   Trouble::output; naming the line where a row is not what add() writes, or
  ///         what no run can have counted.
  static Result<ChunkLog> open(const Format& format, const std::optional<std::string>& folder,
                               const Outputs& outputs);

  /// Whether so many rays of a chunk are there, or more.
  bool has(const Key& key, std::uint64_t rays) const {
    const auto row = rows_.find(key);
    return row != rows_.end() && row->second.counts.front() >= rays;
  }
  std::size_t size() const { return rows_.size(); }
  /// `each(row)` of chunks 0 to `chunks` - 1 that are there, in order, whatever the chunk of `key`.
  /// Cost    of the rows that are there.
  template <class Each>
  void for_each(Key key, std::uint64_t chunks, const Each& each) const {
    Key end = key;
    key.chunk = 0;
    end.chunk = chunks;
    const auto last = rows_.lower_bound(end);
    for (auto row = rows_.lower_bound(key); row != last; ++row) each(row->second);
  }
  /// Appends a row.
  Result<void> add(const Key& key, const Row& row, double seconds);
  /// Takes away what does not count of a last row.
  Result<void> mend() const {
    return journal_ && !rows_.empty() ? journal_->mend() : Result<void>();
  }

 private:
  explicit ChunkLog(const Format& format) : format_(format) {}
  void keep(const Key& key, Row row);
  std::string head() const;
  std::optional<std::pair<Key, Row>> read_row(std::string_view line) const;
  Result<void> read(const std::string& text);

  Format format_;
  std::optional<Journal> journal_;  ///< none where nothing is kept
  std::map<Key, Row> rows_;
};

/// Rows as tallies: `Rows` has their format, and makes a row of a Tally and a Tally of a row.
template <class Tally, class Rows>
class TallyLog {
 public:
  static Result<TallyLog> open(const std::optional<std::string>& folder,
                               const Outputs& outputs = {}) {
    FLATRAY_TRY(log, ChunkLog::open(Rows::kFormat, folder, outputs));
    return TallyLog(std::move(*log));
  }
  bool has(const ChunkLog::Key& key, std::uint64_t rays) const { return log_.has(key, rays); }
  std::size_t size() const { return log_.size(); }
  Result<void> add(const ChunkLog::Key& key, const Tally& tally, double seconds) {
    return log_.add(key, Rows::row(tally), seconds);
  }
  /// `each(tally)` of chunks 0 to `chunks` - 1, whatever the chunk of `key`.
  template <class Each>
  void for_each(const ChunkLog::Key& key, std::uint64_t chunks, const Each& each) const {
    log_.for_each(key, chunks, [&](const ChunkLog::Row& row) { each(Rows::tally(row)); });
  }
  /// All of them together.
  Tally sum(const ChunkLog::Key& key, std::uint64_t chunks) const {
    Tally sum;
    for_each(key, chunks, [&](const Tally& tally) { sum.add(tally); });
    return sum;
  }
  /// Adds what is not there of `chunks` of all `keys`, whatever their chunk, a round of `threads`
  /// chunks at a time, until interrupted: `check(first, count, open)` gives tallies of the rays or
  /// pairs of one chunk for the keys numbered in `open`, which are kept in order when the round is
  /// over.
  ///
  /// Cost    memory of a round, whatever the number of chunks.
  template <class Check>
  Result<void> run(const std::vector<ChunkLog::Key>& keys, const Chunks& chunks, unsigned threads,
                   const Check& check) {
    struct Chunk {
      std::vector<ChunkLog::Key> keys{};  // that it is not there of
      std::vector<std::size_t> open{};    // their numbers
      std::vector<Tally> tallies{};
    };
    std::uint64_t next = 0;
    while (!interrupted()) {
      std::vector<Chunk> round;
      for (; next < chunks.number() && round.size() < threads; ++next) {
        Chunk one;
        for (std::size_t k = 0; k < keys.size(); ++k) {
          ChunkLog::Key key = keys[k];
          key.chunk = next;
          if (has(key, chunks.in(next))) continue;
          one.keys.push_back(std::move(key));
          one.open.push_back(k);
        }
        if (!one.open.empty()) round.push_back(std::move(one));
      }
      if (round.empty()) break;
      const auto start = std::chrono::steady_clock::now();
      parallel_for(round.size(), threads, [&](std::size_t i) {
        const std::uint64_t chunk = round[i].keys.front().chunk;
        round[i].tallies = check(chunk * chunks.size, chunks.in(chunk), round[i].open);
      });
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
      for (const Chunk& one : round)
        for (std::size_t i = 0; i < one.keys.size(); ++i) {
          FLATRAY_TRY(added, add(one.keys[i], one.tallies[i],
                                 time.count() / static_cast<double>(round.size())));
        }
    }
    return log_.mend();
  }

 private:
  explicit TallyLog(ChunkLog log) : log_(std::move(log)) {}
  ChunkLog log_;
};

/// Of `stability.csv`.
struct StabilityRows {
  static const ChunkLog::Format kFormat;
  /// The family of a key, of pairs.
  static std::string pairs(const PairFamily& family) { return "pairs-" + family.name; }
  static ChunkLog::Row row(const StabilityTally& tally);
  static StabilityTally tally(const ChunkLog::Row& row);
};
using StabilityLog = TallyLog<StabilityTally, StabilityRows>;

/// Of `leaks.csv`.
struct LeakRows {
  static const ChunkLog::Format kFormat;
  static ChunkLog::Row row(const LeakTally& tally);
  static LeakTally tally(const ChunkLog::Row& row);
};
using LeakLog = TallyLog<LeakTally, LeakRows>;

}  // namespace flatray
