#include "app/measure.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "app/frame_encoder.h"
#include "base/check.h"
#include "base/processor_time.h"
#include "collide/scene_timeline.h"

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
  // Half of the range of the rounds, in percent of their median.
  double spread() const {
    const auto [low, high] = std::minmax_element(seconds.begin(), seconds.end());
    return 50 * (*high - *low) / median();
  }
};

// Something left out that is kept for once, to see what that saves.
struct Kept {
  std::string part;
  const Pass* pass = nullptr;  // one that is not needed
  bool each_frame = false;     // though all are one picture
  bool painting = false;       // what is hidden, and what has not changed
};

// All of a scene that is left out, one by one.
std::vector<Kept> omissions(const RenderJob& job) {
  std::vector<Kept> all;
  for (const Pass* pass : passes())
    if (!pass->need(job.scene).needed) all.push_back({std::string("pass ") + pass->name, pass});
  if (make_plan(job.scene, false).still) all.push_back({"frames drawn once", nullptr, true});
  all.push_back({"hidden and unchanged parts", nullptr, false, true});
  return all;
}

RenderPlan plan_with(const RenderJob& job, const Kept& kept) {
  RenderPlan plan = make_plan(job.scene, job.keep_all, job.tracer);
  if (kept.each_frame) plan.still = false;
  if (kept.pass == nullptr) return plan;
  const std::vector<const Pass*> needed = std::move(plan.passes);
  plan.passes.clear();
  for (const Pass* pass : passes())
    if (pass == kept.pass || std::find(needed.begin(), needed.end(), pass) != needed.end())
      plan.passes.push_back(pass);
  return plan;
}

Result<void> measure(const RenderJob& given, const Kept& kept, std::size_t round, Measured& out) {
  RenderJob job = given;
  job.keep_all = given.keep_all || kept.painting;
  const double start = processor_seconds();
  const RenderPlan plan = plan_with(given, kept);
  auto timeline = make_timeline(job.scene, job.seed, job.last_frame);
  if (!timeline) return fail(std::move(timeline));
  FrameEncoder encoder(job, 1);
  out.files.clear();
  for (const unsigned frame : job.frames) {
    if (plan.still && !out.files.empty()) {
      out.files.push_back(out.files.front());
      continue;
    }
    Result<const Encoded*> picture = encoder.encode(plan, *timeline, frame);
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

Saving saving_of(const Kept& kept, const Measured& without, const Measured& with,
                 std::size_t frames) {
  return {"saved by: " + kept.part,
          fmt::format("{:.0f} %", 100 * (1 - without.median() / with.median())),
          fmt::format("{} with it kept, the same bytes; spread {:.0f} %",
                      milliseconds(with.median(), frames), with.spread())};
}

}  // namespace

Result<std::vector<Saving>> measured_savings(const RenderJob& job) {
  RenderJob all = job;
  all.keep_all = true;
  Measured some, every;
  const std::vector<Kept> parts = omissions(job);
  std::vector<Measured> with(parts.size());
  for (std::size_t round = 0; round < kRounds; ++round) {
    if (auto drawn = measure(job, {}, round, some); !drawn) return fail(std::move(drawn));
    if (auto drawn = measure(all, {}, round, every); !drawn) return fail(std::move(drawn));
    FLATRAY_CHECK(some.files == every.files);  // leaving out changes no byte
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (auto drawn = measure(job, parts[i], round, with[i]); !drawn)
        return fail(std::move(drawn));
      FLATRAY_CHECK(some.files == with[i].files);
    }
  }
  const std::size_t frames = job.frames.size();
  const DrawCounts& counts = some.counts;
  std::vector<Saving> rows{
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
  for (std::size_t i = 0; i < parts.size(); ++i)
    rows.push_back(saving_of(parts[i], some, with[i], frames));
  return rows;
}

}  // namespace flatray
