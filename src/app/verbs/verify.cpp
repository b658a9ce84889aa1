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

bool is_picture(const fs::path& extension) {
  if (extension.empty()) return false;
  const PictureFormat* format = find_picture_format(extension.string().substr(1));
  return format != nullptr && !format->is_video();  // videos have no record
}

struct Options : Arguments {
  unsigned threads = 1;

  void rows(OptionTable& row) {
    row_of_threads(row, threads);
    row(kJsonRow);
  }
};

// "frame_####.png" of "frame_0003.png": a name with its last number taken out.
std::string pattern_of(std::string name) {
  constexpr const char* kDigits = "0123456789";
  const std::size_t last = name.find_last_of(kDigits);
  if (last == std::string::npos) return name;
  const std::size_t before = name.find_last_not_of(kDigits, last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return name.replace(first, last + 1 - first, last + 1 - first, '#');
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
      if (const auto record = parse_manifest_line(line))
        records_[record->file].push_back(*record);
      else
        tell(path, fmt::format("line {} is no record", number));
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
      if (const auto text = read_regular_file(path); !text)
        tell(text.error());
      else if (!are_blocks(*text))
        tell(path, "is not what an experiment keeps, or was changed");
      else  // a block a line, but the first
        rows_ += static_cast<std::size_t>(std::max(std::ranges::count(*text, '\n') - 1, {}));
    } else if (is_picture(path.extension())) {
      if (!records_.contains(name)) pictures_.push_back(path);
    }
  }

  void check_pictures() {
    std::vector<std::pair<std::string, bool>> whole;
    for (const auto& [file, records] : records_) whole.emplace_back(file, false);
    parallel_for(whole.size(), threads_, [&](std::size_t i) {
      const auto& all = records_.at(whole[i].first);
      whole[i].second = std::ranges::any_of(
          all, [&](const FrameRecord& record) { return is_whole(record, folder_); });
    });
    for (const auto& [file, is_as_recorded] : whole) {
      std::error_code ignored;
      const bool there = fs::exists(fs::symlink_status(folder_ / file, ignored));
      if (!is_as_recorded) tell(folder_ / file, there ? "differs from its record" : "is missing");
    }
    const auto known = patterns();
    for (const fs::path& path : pictures_)
      if (known.empty() || known.contains(pattern_of(path.filename()))) tell(path, "has no record");
  }

  // By pattern, the scenes and settings its records are of.
  std::map<std::string, std::set<std::string>> patterns() const {
    std::map<std::string, std::set<std::string>> patterns;
    for (const auto& [file, records] : records_)
      patterns[pattern_of(file)].insert(records.back().scene);
    return patterns;
  }

  void check_settings() {
    for (const auto& [pattern, settings] : patterns())
      if (settings.size() > 1)
        tell(folder_ / pattern,
             fmt::format("frames are of {} scenes or settings", settings.size()));
  }

  const fs::path folder_;
  const unsigned threads_;
  bool found_ = false;
  std::size_t rows_ = 0;                                     ///< and blocks
  std::map<std::string, std::vector<FrameRecord>> records_;  ///< by file, of all manifests
  std::vector<fs::path> pictures_;                           ///< without a record
  Diagnostics findings_;  ///< of each what is wrong with one file
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
