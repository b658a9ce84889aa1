// flatray stability --leaks.
#include <chrono>

#include "app/chunk_log.h"
#include "app/interrupt.h"
#include "app/option_values.h"
#include "app/scene_input.h"
#include "app/stability_reports.h"
#include "app/tracer_choice.h"
#include "base/isa.h"
#include "base/parallel.h"

namespace flatray {
namespace {

ChunkLog::Key key_of(const StabilityRequest& request, const RoomPlace& place, const Tracer& tracer,
                     std::uint64_t block) {
  return {place.name, tracer.name, isa_name(active_isa()), request.seed, block};
}

// Blocks not yet in the log.
Result<void> run_blocks(const StabilityRequest& request, const RoomPlace& place,
                        const Tracer& tracer, std::uint64_t blocks, LeakLog& log) {
  std::vector<std::uint64_t> open;
  for (std::uint64_t block = 0; block < blocks; ++block)
    if (!log.has(key_of(request, place, tracer, block))) open.push_back(block);
  std::vector<LeakTally> tallies(open.size());
  return in_rounds(
      open.size(), request.threads,
      [&](std::size_t i) { tallies[i] = count_leaks(tracer, place, request.seed, open[i]); },
      [&](std::size_t i, double seconds) {
        return log.add(key_of(request, place, tracer, open[i]), tallies[i], seconds);
      });
}

}  // namespace

Result<void> in_rounds(std::size_t count, unsigned threads,
                       const std::function<void(std::size_t)>& work,
                       const std::function<Result<void>(std::size_t, double)>& keep) {
  for (std::size_t begin = 0; begin < count && !interrupted(); begin += threads) {
    const std::size_t round = std::min<std::size_t>(threads, count - begin);
    const auto start = std::chrono::steady_clock::now();
    parallel_for(round, threads, [&](std::size_t i) { work(begin + i); });
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    for (std::size_t i = begin; i < begin + round; ++i)
      if (auto kept = keep(i, time.count() / static_cast<double>(round)); !kept) return kept;
  }
  return {};
}

VerbOutput stability_output(const Arguments& arguments, const ReportTable& table, bool sound) {
  const int code = interrupted() ? 130 : sound ? 0 : 1;
  if (arguments.has("json"))
    return VerbOutput{json_report("stability", arguments, as_objects(table), 0), code};
  return VerbOutput{aligned_text(table), code};
}

Result<VerbOutput> report_leaks(const Arguments& arguments, const StabilityRequest& request) {
  const auto rays = arguments.whole("leaks", 1, 1, std::uint64_t{1} << 40);
  if (!rays) return tl::unexpected(rays.error());
  const auto places = chosen_names(arguments, "places", "place", names_of(room_places()));
  if (!places) return tl::unexpected(places.error());
  const std::uint64_t blocks = (*rays + kRaysALeakBlock - 1) / kRaysALeakBlock;
  auto log = LeakLog::open(arguments.text("output"));
  if (!log) return fail(std::move(log));
  catch_interrupts();
  ReportTable table{
      {"place", "tracer", "rays", "bounces", "leaks", "corners", "first_wall_wrong", "first_t_off",
       "asked", "beside", "nothing", "through_end", "through", "invented"},
      {}};
  bool sound = true;
  for (const RoomPlace& place : room_places()) {
    if (std::find(places->begin(), places->end(), place.name) == places->end()) continue;
    for (const Tracer* tracer : request.tracers) {
      if (auto done = run_blocks(request, place, *tracer, blocks, *log); !done)
        return fail(std::move(done));
      const LeakTally sum = log->sum(key_of(request, place, *tracer, 0), blocks);
      sound = sound && sum.leaks + sum.wrong + sum.wrong_t == 0;
      table.rows.push_back({place.name, tracer->name, sum.rays, sum.bounces, sum.leaks, sum.corners,
                            sum.wrong, sum.wrong_t, sum.asked, sum.beside, sum.nothing,
                            sum.through_end, sum.through, sum.invented});
    }
  }
  return stability_output(arguments, table, sound);
}

}  // namespace flatray
