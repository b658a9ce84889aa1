// flatray stability --leaks.
#include <fmt/core.h>

#include "app/answers/stability_reports.h"
#include "app/files/chunk_log.h"
#include "app/interrupt.h"
#include "app/report/report.h"
#include "base/isa.h"

namespace flatray {
VerbOutput stability_output(Table table, bool sound) {
  const int code = interrupted() ? interrupted_code() : sound ? 0 : 1;
  if (interrupted()) report_note(fmt::format("flatray: {}; {}", interruption(), kRowsKept));
  return {.table = std::move(table), .exit_code = code};
}

Result<VerbOutput> report_leaks(const StabilityRequest& request) {
  const Chunks blocks{*request.leaks, kRaysALeakBlock};
  const std::vector<std::string>& places = request.places;
  FLATRAY_TRY(log, LeakLog::open(request.text("output"), Outputs(request)));
  Table table({"place", "tracer", "rays", "bounces", "leaks", "corners", "first_wall_wrong",
               "first_t_off", "asked", "beside", "nothing", "through_end", "through", "invented"});
  bool sound = true;
  for (const RoomPlace& place : room_places()) {
    if (std::ranges::find(places, place.name) == places.end()) continue;
    for (const Tracer* tracer : request.tracers) {
      const ChunkLog::Key key{place.name, tracer->name, isa_name(active_isa()), request.seed, 0};
      FLATRAY_TRY(done, log->run({key}, blocks, request.scene.limits.threads,
                                 [&](std::uint64_t first, std::uint64_t count, const auto&) {
                                   return std::vector{count_leaks(*tracer, place, request.seed,
                                                                  first / blocks.size, count)};
                                 }));
      const LeakTally sum = log->sum(key, blocks.number());
      sound = sound && sum.leaks + sum.wrong + sum.wrong_t == 0;
      table.add({place.name, tracer->name, sum.rays, sum.bounces, sum.leaks, sum.corners, sum.wrong,
                 sum.wrong_t, sum.asked, sum.beside, sum.nothing, sum.through_end, sum.through,
                 sum.invented});
    }
  }
  return stability_output(std::move(table), sound);
}

}  // namespace flatray
