#include "trace/tracer.h"

#include "base/check.h"
#include "base/counted.h"
#include "base/entry_named.h"

namespace flatray {
namespace {

// Up to here every wall against every ray is faster than a walk through cells: measured crossover
// (docs/adr/0010-tracers.md).
constexpr std::size_t kFewSegments = 24;

}  // namespace

#include "tracers.inc"  // tracers()

const Tracer* find_tracer(std::string_view name) { return entry_named(tracers(), name); }

TracerChoice choose_tracer(const Surfaces& walls, const Tracer* asked) {
  if (asked != nullptr) return {asked, "asked for"};
  const std::size_t segments = walls.segments.size();
  const Tracer* brute = find_tracer("brute");
  const Tracer* grid = find_tracer("grid");
  FLATRAY_CHECK(brute != nullptr || grid != nullptr, "no exact tracer is registered in this build");
  const std::size_t curves = walls.size() - segments;
  const std::string many =
      counted(segments, "segment") + (curves == 0 ? "" : " beside " + counted(curves, "curve"));
  if (grid == nullptr) return {brute, "no other in this build"};
  if (brute == nullptr) return {grid, "no other in this build"};
  if (segments <= kFewSegments) return {brute, many + ": fewer than cells pay for"};
  return {grid, many + ": more than " + std::to_string(kFewSegments)};
}

std::unique_ptr<Accelerator> accelerate(const Surfaces& walls, unsigned threads) {
  return choose_tracer(walls).tracer->build(walls, active_isa(), threads);
}

}  // namespace flatray
