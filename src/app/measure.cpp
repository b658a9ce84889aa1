#include "app/measure.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "app/frame_encoder.h"
#include "base/check.h"
#include "base/processor_time.h"

namespace flatray {
namespace {

constexpr std::size_t kRounds = 3;

// One drawing of all frames.
struct Measured {
  std::vector<std::string> files;  // hashes of their bytes
  DrawCounts counts;
  std::size_t encoded = 0;
  std::uint64_t packed = 0, kept = 0;  // bands of PNGs
  std::array<double, kRounds> seconds{};

  double median() const {
    std::array<double, kRounds> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[kRounds / 2];
  }
};

Result<void> measure(const RenderJob& job, std::size_t round, Measured& out) {
  const double start = processor_seconds();
  const RenderPlan plan = make_plan(job.scene, job.keep_all, job.tracer);
  const Timeline timeline(job.scene, job.seed, job.last_frame);
  FrameEncoder encoder(job, 1);
  out.files.clear();
  for (const unsigned frame : job.frames) {
    if (plan.still && !out.files.empty()) {
      out.files.push_back(out.files.front());
      continue;
    }
    Result<const Encoded*> picture = encoder.encode(plan, timeline, frame);
    if (!picture) return fail(std::move(picture));
    out.files.push_back((*picture)->record.bytes);
  }
  out.counts = encoder.counts();
  out.encoded = encoder.encoded();
  out.packed = encoder.png().packed();
  out.kept = encoder.png().kept();
  out.seconds[round] = processor_seconds() - start;
  return {};
}

std::string share(std::uint64_t part, std::uint64_t whole) {
  return fmt::format(
      "{:.1f} %", whole == 0 ? 0.0 : 100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string milliseconds(double seconds, std::size_t frames) {
  return fmt::format("{:.2f} ms a frame", 1e3 * seconds / static_cast<double>(frames));
}

}  // namespace

Result<std::vector<Saving>> measured_savings(const RenderJob& job) {
  RenderJob all = job;
  all.keep_all = true;
  Measured some, every;
  for (std::size_t round = 0; round < kRounds; ++round) {
    if (auto drawn = measure(job, round, some); !drawn) return fail(std::move(drawn));
    if (auto drawn = measure(all, round, every); !drawn) return fail(std::move(drawn));
    FLATRAY_CHECK(some.files == every.files);  // leaving out changes no byte
  }
  const std::size_t frames = job.frames.size();
  const DrawCounts& counts = some.counts;
  return std::vector<Saving>{
      {"measured", fmt::format("{} frames", frames), "the same bytes as with everything kept"},
      {"measured: frames encoded", fmt::format("{} of {}", some.encoded, frames),
       "the others repeat the one before"},
      {"measured: bands carried", share(counts.kept_bands, counts.bands + counts.kept_bands),
       fmt::format("{} of {} bands of rows show what they showed", counts.kept_bands,
                   counts.bands + counts.kept_bands)},
      {"measured: bands of PNGs carried", share(some.kept, some.packed + some.kept),
       fmt::format("{} of {} bands of the frames encoded have the bytes they had", some.kept,
                   some.packed + some.kept)},
      {"measured: items still", share(counts.still_items, counts.items),
       fmt::format("{} of {} pieces in the bands drawn lie still below all that moves there",
                   counts.still_items, counts.items)},
      {"measured: items hidden", share(counts.hidden_items, counts.items),
       fmt::format("{} of {} pieces in the bands drawn lie below one that hides them",
                   counts.hidden_items, counts.items)},
      {"measured: time", milliseconds(some.median(), frames),
       fmt::format("{} with everything kept: {:.0f} % saved", milliseconds(every.median(), frames),
                   100 * (1 - some.median() / every.median()))}};
}

}  // namespace flatray
