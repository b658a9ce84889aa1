#include "app/query/query.h"

#include <cstdio>
#include <span>

#include "app/files/scene_input.h"
#include "app/options/tracer_choice.h"
#include "app/query/line_stream.h"
#include "app/verb.h"
#include "base/parallel.h"
#include "precise/certified_orbit.h"

namespace flatray::verbs {
namespace {

struct Options : Arguments {
  Precision precision;
  unsigned threads = 1;

  void rows(OptionTable& row) {
    precision.rows(row);
    row_of_threads(row, threads);
  }
};

// Questions are answered in waves, whose answers are written before the next: long answers, of
// orbits, make a wave short.
constexpr std::size_t kLinesATask = 16, kTasksAThread = 8;
constexpr std::size_t kLongAnswers = std::size_t{1} << 22;

// Answers to `lines`, in their order; whether all were questions.
struct Answers {
  std::vector<std::string> texts;
  std::vector<char> sound;
};

bool is_blank(const StreamLine& line) {
  return !line.too_long && line.text.find_first_not_of(" \t\r") == std::string_view::npos;
}

Answers answer(std::span<const StreamLine> lines, const Precision& precision, unsigned threads) {
  const std::size_t tasks = (lines.size() + kLinesATask - 1) / kLinesATask;
  Answers answers{std::vector<std::string>(tasks), std::vector<char>(tasks, 1)};
  parallel_for(tasks, std::min<unsigned>(threads, static_cast<unsigned>(tasks)),
               [&](std::size_t task) {
                 const std::size_t last = std::min(lines.size(), (task + 1) * kLinesATask);
                 for (std::size_t i = task * kLinesATask; i < last; ++i) {
                   if (is_blank(lines[i])) continue;
                   const Answer one = lines[i].too_long ? answer_to_long_line(LineStream::kLongest)
                                                        : answer_line(lines[i].text, precision);
                   answers.texts[task] += one.line;
                   answers.texts[task] += '\n';
                   if (!one.ok) answers.sound[task] = 0;
                 }
               });
  return answers;
}

std::size_t size_of(const Answers& answers) {
  std::size_t size = 0;
  for (const std::string& text : answers.texts) size += text.size();
  return size;
}

Result<void> write(const Answers& answers) {
  bool written = true;
  for (const std::string& text : answers.texts)
    written = written && std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return {};
  return fail(named_place("standard output"), "cannot write", "", Trouble::output);
}

Result<VerbOutput> run(const Options& options) {
  if (options.precision.certified)
    if (auto able = can_certify(); !able) return tl::unexpected(able.error());
  auto stream = LineStream::open(options.operands().empty() ? "-" : options.operands().front());
  if (!stream) return tl::unexpected(stream.error());
  bool sound = true;
  std::size_t lines_at_once = kLinesATask * kTasksAThread;
  while (true) {
    const auto lines = stream->next();
    if (!lines) return tl::unexpected(lines.error());
    if (lines->empty()) return VerbOutput{.exit_code = sound ? 0 : 1};
    for (std::span<const StreamLine> rest = *lines; !rest.empty();) {
      const std::size_t wave = std::min(rest.size(), std::size_t{options.threads} * lines_at_once);
      const Answers answers = answer(rest.first(wave), options.precision, options.threads);
      if (auto written = write(answers); !written) return tl::unexpected(written.error());
      for (const char one : answers.sound) sound = sound && one != 0;
      lines_at_once = size_of(answers) > kLongAnswers ? 1 : kLinesATask * kTasksAThread;
      rest = rest.subspan(wave);
    }
  }
}

}  // namespace

extern const Verb query = {
    "query",
    "[FILE|-]",
    "answer geometry questions, one JSON object a line",
    0,
    1,
    kCommand<Options, &run>,
    "  echo '{\"op\":\"clip\",\"polygon\":[[0,0],[1,0],[1,1]],\"origin\":[-1,0.5],"
    "\"direction\":[1,0]}' | flatray query\n"
    "  flatray query questions.jsonl -j 2 > answers.jsonl\n",
    ""};

}  // namespace flatray::verbs
