#include "app/answers/measure.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/answers/cost.h"
#include "app/frames/frame_encoder.h"
#include "base/check.h"
#include "base/counted.h"
#include "base/processor_time.h"
#include "base/shuffled.h"
#include "collide/scene_timeline.h"

namespace flatray {
namespace {

// What one drawing of all frames gives; the same every time.
struct Drawn {
  std::vector<std::string> files;  // hashes of their bytes
  DrawCounts counts;
  std::size_t encoded = 0;
  std::uint64_t packed = 0, kept = 0;  // bands of PNGs
};

// A way to draw the frames: something left out that is kept for once, to see what that saves.
struct Kept {
  std::string part;
  const Pass* pass = nullptr;  // one that is not needed
  bool each_frame = false;     // though all are one picture
  bool painting = false;       // what is hidden, and what has not changed
  bool everything = false;
};

// As the job is, with everything kept, and with each thing kept by itself.
std::vector<Kept> ways_to_draw(const RenderJob& job) {
  std::vector<Kept> all{{}, {"", nullptr, false, false, true}};
  for (const Pass* pass : passes())
    if (!pass->need(job.scene).needed) all.push_back({std::string("pass ") + pass->name, pass});
  if (make_plan(job.scene, false).still) all.push_back({"frames drawn once", nullptr, true});
  all.push_back({"hidden and unchanged parts", nullptr, false, true});
  return all;
}

RenderPlan plan_with(const RenderJob& job, const Kept& kept) {
  RenderPlan plan = make_plan(job.scene, job.keep_all || kept.everything, job.tracer);
  if (kept.each_frame) plan.still = false;
  if (kept.pass == nullptr) return plan;
  const std::vector<const Pass*> needed = std::move(plan.passes);
  plan.passes.clear();
  for (const Pass* pass : passes())
    if (pass == kept.pass || std::ranges::find(needed, pass) != needed.end())
      plan.passes.push_back(pass);
  return plan;
}

Result<Drawn> draw(const RenderJob& given, const Kept& kept) {
  RenderJob job = given;
  job.keep_all = given.keep_all || kept.painting || kept.everything;
  const RenderPlan plan = plan_with(given, kept);
  FLATRAY_TRY(timeline, make_timeline(job.scene, job.seed, job.last_frame));
  FrameEncoder encoder(job, 1);
  Drawn out;
  for (const unsigned frame : job.frames) {
    if (plan.still && !out.files.empty()) {
      out.files.push_back(out.files.front());
      continue;
    }
    FLATRAY_TRY(picture, encoder.encode(plan, *timeline, frame));
    out.files.push_back((*picture)->record.bytes);
  }
  out.counts = encoder.counts();
  out.encoded = encoder.encoded();
  out.packed = encoder.png().packed();
  out.kept = encoder.png().kept();
  return out;
}

std::string share(std::uint64_t part, std::uint64_t whole) {
  return fmt::format(
      "{:.1f} %", whole == 0 ? 0.0 : 100 * static_cast<double>(part) / static_cast<double>(whole));
}

// What each way costs in each round, each in an order of its own, so that none comes always after the same.
Result<std::vector<CostRounds>> costs_of(const RenderJob& job, const std::vector<Kept>& ways,
                                         const Drawn& expected) {
  std::vector<std::vector<Cost>> costs(ways.size());
  const auto turn = [&](std::size_t i) -> Result<void> {
    Result<Drawn> drawn;
    costs[i].push_back(cost_of([&] { drawn = draw(job, ways[i]); }));
    if (!drawn) return fail(std::move(drawn));
    FLATRAY_CHECK(drawn->files == expected.files);  // leaving out changes no byte
    return {};
  };
  const auto all_in_turn = [&](std::size_t round) -> Result<void> {
    const Shuffled order(ways.size(), round, Stream::experiment);
    for (std::size_t i = 0; i < ways.size(); ++i)
      if (auto done = turn(order[i]); !done) return done;
    return {};
  };
  // The first round tells how many there is time for, and does not count: caches were cold.
  const double start = thread_seconds();
  if (auto done = all_in_turn(0); !done) return fail(std::move(done));
  const std::size_t rounds = rounds_for(thread_seconds() - start);
  for (auto& of_way : costs) of_way.clear();
  for (std::size_t round = 0; round < rounds; ++round)
    if (auto done = all_in_turn(round + 1); !done) return fail(std::move(done));
  return in_one_unit(costs);
}

// "7 of 12 bands".
std::string part_of(std::uint64_t part, std::uint64_t whole, const char* one, const char* several) {
  return fmt::format("{} of {}", part, counted(whole, one, several));
}

// What was drawn and what was not, in counts that are the same every time.
Savings counts_of(const Drawn& some, std::size_t frames) {
  const DrawCounts& counts = some.counts;
  const std::uint64_t bands = counts.bands + counts.kept_bands, packed = some.packed + some.kept;
  return {{"measured", counted(frames, "frame"), "the same bytes as with everything kept"},
          {"measured: frames encoded", fmt::format("{} of {}", some.encoded, frames),
           "the others repeat the one before"},
          {"measured: bands carried", share(counts.kept_bands, bands),
           part_of(counts.kept_bands, bands, "band of rows", "bands of rows") + " as before"},
          {"measured: bands of PNGs carried", share(some.kept, packed),
           part_of(some.kept, packed, "band", "bands") +
               " of the frames encoded with the bytes of before"},
          {"measured: pixels carried", share(counts.kept_pixels, counts.pixels),
           part_of(counts.kept_pixels, counts.pixels, "pixel", "pixels") +
               " of the bands drawn, beside what changed there"},
          {"measured: items hidden", share(counts.hidden_items, counts.items),
           part_of(counts.hidden_items, counts.items, "piece", "pieces") +
               " in the bands drawn below one that hides them"}};
}

}  // namespace

Result<Savings> measured_savings(const RenderJob& job) {
  const std::vector<Kept> ways = ways_to_draw(job);
  FLATRAY_TRY(drawn, draw(job, {}));
  FLATRAY_TRY(costs, costs_of(job, ways, *drawn));
  const CostRounds &some = costs->at(0), &every = costs->at(1);
  const std::size_t frames = job.frames.size();
  Savings rows = counts_of(*drawn, frames);
  rows.push_back({"measured: by", some.instructions ? "instructions" : "processor time",
                  fmt::format("{} in turns; medians, and in brackets where they lie with {:.0f} % "
                              "confidence{}",
                              counted(some.values.size(), "round"), 100 * kConfidence,
                              some.instructions ? "" : "; this machine counts no instructions")});
  rows.push_back({"measured: cost", amount_words(some, frames), "as it is drawn"});
  rows.push_back({"saved by: all of it", saving_words(some, every),
                  amount_words(every, frames) + " with everything kept, the same bytes"});
  for (std::size_t i = 2; i < ways.size(); ++i)
    rows.push_back({"saved by: " + ways[i].part, saving_words(some, costs->at(i)),
                    amount_words(costs->at(i), frames) + " with it kept, the same bytes"});
  return rows;
}

}  // namespace flatray
