#include "app/experiment_monitor.h"

#include "app/interrupt.h"
#include "app/option_values.h"
#include "base/file.h"
#include "base/number_text.h"

namespace flatray {
namespace {

std::string_view next_line(std::string_view& rest) {
  const std::string_view line = rest.substr(0, rest.find('\n'));
  rest.remove_prefix(std::min(rest.size(), line.size() + 1));
  return line;
}

std::optional<std::pair<std::size_t, Numbers>> read_block(std::string_view line) {
  const std::vector<std::string_view> cells = split_commas(line);
  const auto block = parse_whole(cells.front());
  if (!block) return std::nullopt;
  Numbers numbers;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const auto number = parse_number(cells[i]);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return std::pair{static_cast<std::size_t>(*block), std::move(numbers)};
}

}  // namespace

Result<std::unique_ptr<ExperimentMonitor>> ExperimentMonitor::open(
    const std::optional<std::filesystem::path>& kept_in, const std::string& key) {
  auto monitor = std::make_unique<ExperimentMonitor>();
  if (!kept_in) return monitor;
  monitor->path_ = *kept_in;
  std::error_code error;
  std::filesystem::create_directories(kept_in->parent_path(), error);
  if (error) return fail(named_place(kept_in->string()), error.message(), "", Trouble::output);
  auto begun = std::filesystem::exists(*kept_in) ? monitor->read(key) : append_line(*kept_in, key);
  if (!begun) return fail(std::move(begun));
  return monitor;
}

Result<void> ExperimentMonitor::read(const std::string& key) {
  const auto text = read_whole_lines(path_);
  if (!text) return tl::unexpected(text.error());
  std::string_view rest = *text;
  if (rest.empty()) return append_line(path_, key);
  if (next_line(rest) != key)
    return fail(named_place(path_.string()), "was kept by another run",
                "remove it, or name another folder with -o");
  while (!rest.empty()) {
    auto block = read_block(next_line(rest));
    if (!block)
      return fail(named_place(path_.string()), "has a line that is not a block",
                  "remove it, and the run begins anew");
    kept_.insert(std::move(*block));
  }
  return {};
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
  if (path_.empty() || kept_.contains(block)) return;
  std::string line = std::to_string(block);
  for (const double number : result) line += "," + number_text(number);
  const std::lock_guard lock(mutex_);
  if (failure_) return;
  if (auto written = append_line(path_, line); !written) failure_ = written.error();
}

bool ExperimentMonitor::stopped() {
  if (interrupted()) return true;
  const std::lock_guard lock(mutex_);
  return failure_.has_value();
}

Result<void> ExperimentMonitor::finish(bool over) {
  if (progress_) progress_->finish();
  if (failure_) return tl::unexpected(*failure_);
  if (!over || path_.empty()) return {};
  std::error_code error;
  std::filesystem::remove(path_, error);
  if (error) return fail(named_place(path_.string()), error.message(), "", Trouble::output);
  return {};
}

}  // namespace flatray
