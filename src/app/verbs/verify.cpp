#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "app/experiments/experiment_monitor.h"
#include "app/files/chunk_log.h"
#include "app/files/manifest.h"
#include "app/files/output_pattern.h"
#include "app/files/scene_input.h"
#include "app/verb.h"
#include "base/counted.h"
#include "base/parallel.h"

namespace flatray::verify_verb {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& file) {
  const PictureFormat* format = picture_format_by_name(file);
  return format != nullptr && !format->is_video();  // videos have no record
}

struct Options : Arguments {
  unsigned threads = 1;

  void rows(OptionTable& row) {
    row_of_threads(row, threads);
    row(kJsonRow);
  }
};

// A name with one of its numbers taken out, which may be that of its frame.
struct Pattern {
  std::string key;    ///< "f_#.png" of "f_0003.png" and of "f_10000.png"
  std::string shown;  ///< "f_####.png"
};

// By each number of a name, or by each that is `frame`.
std::vector<Pattern> patterns_of(const std::string& name, std::optional<unsigned> frame) {
  constexpr const char* kDigits = "0123456789";
  std::vector<Pattern> all;
  for (std::size_t end = 0, at; (at = name.find_first_of(kDigits, end)) != std::string::npos;) {
    end = std::min(name.find_first_not_of(kDigits, at), name.size());
    const std::string run = name.substr(at, end - at), digits = frame ? std::to_string(*frame) : "";
    if (frame &&
        (!run.ends_with(digits) || run.find_first_not_of('0') + digits.size() != run.size()))
      continue;
    std::string key = name, shown = name;
    all.push_back({key.replace(at, end - at, "#"), shown.replace(at, end - at, end - at, '#')});
  }
  return all;
}

const char* why_nothing(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return "is not there";
  if (!fs::is_directory(folder, ignored)) return "is no folder";
  return "holds no records of frames, blocks or rows";
}

class FolderCheck {
 public:
  FolderCheck(fs::path folder, unsigned threads) : folder_(std::move(folder)), threads_(threads) {}

  // Error   Trouble::missing: nothing there is a record.
  Result<void> run() {
    for (const fs::path& manifest : manifests_in(folder_)) read_manifest(manifest);
    check_rows();
    for (const fs::path& file : files_in(folder_)) check_file(file);
    if (!found_)
      return fail(named_place(folder_.string()), why_nothing(folder_),
                  "name a folder that flatray wrote to", Trouble::missing);
    check_pictures();
    check_settings();
    for (const fs::path& path : leftovers(folder_)) tell(path, "was left by a run that was killed");
    return {};
  }

  void add_to(VerbOutput& output) const {
    std::string text;
    Values problems;
    for (const Diagnostic& one : findings_) {
      const std::string& file = one.where.source->name();
      text += fmt::format("{}: {}\n", file, one.message);
      problems.push_back(Fields{{"file", file}, {"problem", one.message}});
    }
    const bool sound = findings_.empty();
    text += fmt::format(
        "{}: {}, {}\n", folder_.string(), counted(records_.size() + rows_, "record"),
        sound ? "all as recorded" : counted(findings_.size(), "thing") + " not as recorded");
    output.add(Fields{{"folder", folder_.string()},
                      {"sound", sound},
                      {"records", records_.size() + rows_},
                      {"problems", std::move(problems)}},
               std::move(text));
    if (!sound) output.exit_code = 1;
  }

 private:
  void tell(const fs::path& file, std::string problem) {
    findings_.push_back({named_place(file.string()), std::move(problem), ""});
  }
  void tell(const Diagnostics& problems) {
    findings_.insert(findings_.end(), problems.begin(), problems.end());
  }

  void read_manifest(const fs::path& path) {
    found_ = true;
    const auto text = read_regular_file(path);
    if (!text) return tell(text.error());
    std::size_t number = 0;
    each_line(*text, [&](std::string_view line) {
      ++number;
      const auto record = parse_manifest_line(line);
      if (!record) return tell(path, fmt::format("line {} is no record", number));
      records_[record->file].push_back(*record);
      if (!record->error_file.empty()) errors_[record->error_file].push_back(*record);
    });
    check_end(path, *text);
  }

  void check_end(const fs::path& path, std::string_view text) {
    if (!text.empty() && text.back() != '\n') tell(path, "ends within a line");
  }

  // Rows of stability.csv and leaks.csv.
  void check_rows() {
    const auto check = [&](const char* name, const auto& log) {
      std::error_code ignored;
      const bool is_there = fs::exists(folder_ / name, ignored);
      found_ = found_ || is_there;
      if (!log) return tell(log.error());
      if (!is_there) return;
      if (const auto text = read_regular_file(folder_ / name)) check_end(folder_ / name, *text);
      rows_ += log->size();
    };
    check(StabilityRows::kFormat.file, StabilityLog::open(folder_.string()));
    check(LeakRows::kFormat.file, LeakLog::open(folder_.string()));
  }

  // Blocks that an experiment keeps, and pictures without a record.
  void check_file(const fs::path& path) {
    const std::string name = path.filename();
    if (path.extension() == ".blocks") {
      found_ = true;
      const auto text = read_regular_file(path);
      if (!text) return tell(text.error());
      check_end(path, *text);
      const std::string whole = text->substr(0, text->rfind('\n') + 1);
      if (!are_blocks(whole))
        tell(path, "is not what an experiment keeps, or was changed");
      else  // a block a line, but the first
        rows_ += static_cast<std::size_t>(std::max(std::ranges::count(whole, '\n') - 1, {}));
    } else if (is_picture(path)) {
      if (!records_.contains(name) && !errors_.contains(name)) pictures_.push_back(path);
    }
  }

  using RecordsByFile = std::map<std::string, std::vector<FrameRecord>>;

  // `is_right(record)` of one of the records of each file.
  template <class IsRight>
  void check_recorded(const RecordsByFile& recorded, const IsRight& is_right) {
    std::vector<std::pair<std::string, bool>> whole;
    for (const auto& [file, records] : recorded) whole.emplace_back(file, false);
    parallel_for(whole.size(), threads_, [&](std::size_t i) {
      whole[i].second = std::ranges::any_of(recorded.at(whole[i].first), is_right);
    });
    for (const auto& [file, is_as_recorded] : whole) {
      std::error_code ignored;
      const fs::file_status status = fs::symlink_status(folder_ / file, ignored);
      if (!is_as_recorded)
        tell(folder_ / file, !fs::exists(status)      ? "is missing"
                             : fs::is_symlink(status) ? "is a link, which no run leaves"
                                                      : "differs from its record");
    }
  }

  void check_pictures() {
    check_recorded(records_, [&](const FrameRecord& record) { return is_whole(record, folder_); });
    check_recorded(errors_, [&](const FrameRecord& record) {
      return is_error_image(record, folder_ / record.error_file);
    });
    const auto known = patterns();
    for (const fs::path& path : pictures_)
      if (known.empty() ||
          std::ranges::any_of(patterns_of(path.filename(), {}),
                              [&](const auto& one) { return known.contains(one.key); }))
        tell(path, "has no record");
  }

  struct Settings {
    std::string shown;
    std::set<std::string> scenes;  ///< and settings of its records
  };

  // By pattern. Where several numbers of a name are that of its frame, the pattern is the one that most
  // names have.
  std::map<std::string, Settings> patterns() const {
    std::map<std::string, std::size_t> names;
    for (const auto& [file, records] : records_)
      for (const Pattern& one : patterns_of(file, records.back().frame)) ++names[one.key];
    std::map<std::string, Settings> patterns;
    for (const auto& [file, records] : records_) {
      const std::vector<Pattern> own = patterns_of(file, records.back().frame);
      const auto best =
          std::ranges::max_element(own, {}, [&](const Pattern& one) { return names.at(one.key); });
      const Pattern chosen = best == own.end() ? Pattern{file, file} : *best;
      Settings& settings =
          patterns.try_emplace(chosen.key, Settings{chosen.shown, {}}).first->second;
      settings.scenes.insert(records.back().scene);
    }
    return patterns;
  }

  void check_settings() {
    for (const auto& [key, settings] : patterns())
      if (settings.scenes.size() > 1)
        tell(folder_ / settings.shown,
             fmt::format("frames are of {} scenes or settings", settings.scenes.size()));
  }

  const fs::path folder_;
  const unsigned threads_;
  bool found_ = false;
  std::size_t rows_ = 0;   ///< and blocks
  RecordsByFile records_;  ///< of all manifests, by picture
  RecordsByFile errors_;   ///< the same by picture of the error, where that is in the folder
  std::vector<fs::path> pictures_;  ///< without a record
  Diagnostics findings_;            ///< of each what is wrong with one file
};

Result<VerbOutput> run(const Options& options) {
  VerbOutput output;
  for (const std::string& folder : options.operands()) {
    FolderCheck check(folder, options.threads);
    if (auto done = check.run(); !done) return fail(std::move(done));
    check.add_to(output);
  }
  return output;
}

}  // namespace

extern const Verb entry = {
    "verify",
    "FOLDER...",
    "say whether frames, blocks and rows in a folder are as their records say; writes nothing",
    kCommand<Options, &run>,
    "  flatray verify out/demo\n"
    "  flatray verify out/demo --json | jq '.results[].problems'\n",
    "nothing judged"};

}  // namespace flatray::verify_verb
