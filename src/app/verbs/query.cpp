#include "app/query/query.h"

#include <cerrno>
#include <cstdio>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "app/files/scene_input.h"
#include "app/options/tracer_choice.h"
#include "app/query/line_stream.h"
#include "app/verb.h"
#include "base/file.h"
#include "base/parallel.h"
#include "precise/certified_orbit.h"

namespace flatray::query_verb {
namespace {

struct Options : Arguments {
  Precision precision;
  unsigned threads = 1;

  void rows(OptionTable& row) {
    precision.rows(row);
    row_of_threads(row, threads);
  }
};

// Questions are answered in waves, so that few answers wait for one before them: long ones, of
// orbits, make a wave short.
constexpr std::size_t kLinesAThread = 128;
constexpr std::size_t kLongAnswers = std::size_t{1} << 22;

bool is_blank(const StreamLine& line) {
  return !line.too_long && line.text.find_first_not_of(" \t\r") == std::string_view::npos;
}

// Answers of a wave: each is written as soon as those to all questions before it are.
class AnswersInOrder {
 public:
  explicit AnswersInOrder(std::size_t count) : answers_(count) {}

  void put(std::size_t number, Answer answer) {
    const std::lock_guard lock(mutex_);
    sound_ = sound_ && answer.ok;
    size_ += answer.line.size();
    answers_[number] = std::move(answer.line);
    if (number != written_) return;
    for (; written_ < answers_.size() && answers_[written_]; ++written_) {
      const std::string line = *std::exchange(answers_[written_], std::nullopt);
      if (error_ == 0 && std::fwrite(line.data(), 1, line.size(), stdout) != line.size())
        error_ = errno;
    }
    if (error_ == 0 && std::fflush(stdout) != 0) error_ = errno;
  }

  // Once all are there.
  bool sound() const { return sound_; }
  std::size_t size() const { return size_; }
  Result<void> written() const {
    if (error_ == 0) return {};
    return cannot("write", "standard output", error_, Trouble::output);
  }

 private:
  std::mutex mutex_;
  std::vector<std::optional<std::string>> answers_;
  std::size_t written_ = 0, size_ = 0;
  bool sound_ = true;
  int error_ = 0;  // the system's, of writing
};

// Of a line, with its end; of a blank one nothing.
Answer answer(const StreamLine& line, const Precision& precision) {
  if (is_blank(line)) return {"", true};
  Answer answer =
      line.too_long ? answer_to_long_line(LineStream::kLongest) : answer_line(line.text, precision);
  answer.line += '\n';
  return answer;
}

Result<VerbOutput> run(const Options& options) {
  if (options.precision.certified)
    if (auto able = can_certify(); !able) return tl::unexpected(able.error());
  FLATRAY_TRY(stream,
              LineStream::open(options.operands().empty() ? "-" : options.operands().front()));
  bool sound = true;
  std::size_t lines_a_thread = kLinesAThread;
  while (true) {
    FLATRAY_TRY(lines, stream->next());
    if (lines->empty()) return VerbOutput{.exit_code = sound ? 0 : 1};
    for (std::span<const StreamLine> rest = *lines; !rest.empty();) {
      const std::size_t wave = std::min(rest.size(), options.threads * lines_a_thread);
      AnswersInOrder answers(wave);
      parallel_for(wave, options.threads,
                   [&](std::size_t i) { answers.put(i, answer(rest[i], options.precision)); });
      if (auto written = answers.written(); !written) return tl::unexpected(written.error());
      sound = sound && answers.sound();
      lines_a_thread = answers.size() > kLongAnswers ? 1 : kLinesAThread;
      rest = rest.subspan(wave);
    }
  }
}

}  // namespace

extern const Verb entry = {
    "query", "[FILE|-]", "answer geometry questions, one JSON object a line",
    kCommand<Options, &run>,
    "  echo '{\"op\":\"clip\",\"polygon\":[[0,0],[1,0],[1,1]],\"origin\":[-1,0.5],"
    "\"direction\":[1,0]}' | flatray query\n"
    "  flatray query questions.jsonl -j 2 > answers.jsonl\n"};

}  // namespace flatray::query_verb
