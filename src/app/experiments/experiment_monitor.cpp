#include "app/experiments/experiment_monitor.h"

#include <charconv>

#include "app/interrupt.h"
#include "app/options/option_values.h"
#include "base/file.h"
#include "base/number_text.h"

namespace flatray {
namespace {

std::optional<std::pair<std::size_t, Numbers>> read_block(std::string_view line) {
  const auto text = unchecked(line);
  if (!text) return std::nullopt;
  const std::vector<std::string_view> cells = split(*text, ',');
  const auto block = parse_whole(cells.front());
  if (!block) return std::nullopt;
  Numbers numbers;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    // Infinities and NaN, too, as number_text() writes them.
    const char* const last = cells[i].data() + cells[i].size();
    const auto [end, error] = std::from_chars(cells[i].data(), last, numbers.emplace_back());
    if (error != std::errc{} || end != last) return std::nullopt;
  }
  return std::pair{static_cast<std::size_t>(*block), std::move(numbers)};
}

}  // namespace

Result<std::unique_ptr<ExperimentMonitor>> ExperimentMonitor::open(
    const std::optional<std::filesystem::path>& kept_in, const Fields& setting,
    const Outputs& outputs) {
  auto monitor = std::make_unique<ExperimentMonitor>();
  if (!kept_in) return monitor;
  const std::string key = json_text(setting);
  if (auto allowed = outputs.make_way(*kept_in, key); !allowed) return fail(std::move(allowed));
  remove_leftovers(folder_of(*kept_in));
  FLATRAY_TRY(claim, Claim::take(folder_of(*kept_in), kept_in->filename(), key, outputs.force()));
  monitor->claim_.emplace(std::move(*claim));
  monitor->journal_.emplace(*kept_in, key + "\n");
  if (auto read = monitor->read(key, outputs.force()); !read) return fail(std::move(read));
  return monitor;
}

Result<void> ExperimentMonitor::read(const std::string& key, bool force) {
  FLATRAY_TRY(text, journal_->read());
  if (text->empty()) return {};
  const std::string head = text->substr(0, text->find('\n'));
  std::string problem = head == key ? "" : "was kept by another run: " + differences(head, key);
  each_line(std::string_view(*text).substr(head.size() + 1), [&](std::string_view line) {
    auto block = read_block(line);
    if (block)
      kept_.insert(std::move(*block));
    else if (problem.empty())
      problem = "has a line that is not a block, or was changed";
  });
  if (problem.empty()) return {};
  kept_.clear();
  if (force) return journal_->remove();
  return fail(named_place(journal_->path().string()), problem,
              "name another folder with -o; --force begins anew", Trouble::output);
}

bool are_blocks(const std::string& text) {
  const std::size_t head = text.find('\n');
  if (head == std::string::npos || !parse_json(text.substr(0, head))) return text.empty();
  bool sound = text.back() == '\n';
  each_line(std::string_view(text).substr(head + 1),
            [&](std::string_view line) { sound = sound && read_block(line); });
  return sound;
}

void ExperimentMonitor::begin(std::size_t blocks) {
  progress_ = std::make_unique<Progress>(blocks, ProgressMode::automatic, "blocks");
}

std::optional<Numbers> ExperimentMonitor::kept(std::size_t block) {
  const auto found = kept_.find(block);
  return found == kept_.end() ? std::nullopt : std::optional(found->second);
}

void ExperimentMonitor::done(std::size_t block, const Numbers& result) {
  progress_->step();
  if (!journal_ || kept_.contains(block)) return;
  std::string line = std::to_string(block);
  for (const double number : result) line += "," + number_text(number);
  const std::lock_guard lock(mutex_);
  if (failure_) return;
  auto written = journal_->add(checked(line) + "\n", [this] { return claim_->expect_held(); });
  if (!written) failure_ = written.error();
}

bool ExperimentMonitor::stopped() {
  if (interrupted()) return true;
  const std::lock_guard lock(mutex_);
  return failure_.has_value();
}

Result<void> ExperimentMonitor::finish() {
  if (progress_) progress_->finish();
  if (failure_) return tl::unexpected(*failure_);
  return {};
}

Result<void> ExperimentMonitor::forget() {
  if (!journal_) return {};
  claim_.reset();
  if (auto removed = journal_->remove(); !removed) return removed;
  std::error_code not_empty;
  std::filesystem::remove(folder_of(journal_->path()), not_empty);
  return {};
}

}  // namespace flatray
