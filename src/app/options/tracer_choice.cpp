#include "app/options/tracer_choice.h"

#include <fmt/core.h>

namespace flatray {

std::vector<std::string> tracer_names() { return names_of(tracers()); }

Result<const Tracer*> usable_tracer(const std::string& name, const Place& where) {
  const Tracer* tracer = find_tracer(name);
  if (tracer == nullptr) return unknown_name(where, "tracer", name, tracer_names());
  const std::string missing = tracer->missing == nullptr ? "" : tracer->missing();
  if (!missing.empty())
    return fail(where, "cannot use " + name + ": " + missing, "", Trouble::unavailable);
  return tracer;
}

void row_of_tracer(OptionTable& row, const Tracer*& tracer) {
  row("--tracer NAME", "what finds hits; the exact ones give the same", tracer, &usable_tracer,
      &tracer_names);
}

void Precision::rows(OptionTable& row) {
  constexpr Word<bool> kPrecisions[] = {{"double", false}, {"certified", true}};
  row("--precision", "of orbits; certified proves every bounce, in as many bits as it takes",
      certified, kPrecisions);
  row("--bits N", "most bits of a certified orbit", most_bits, 128, 1U << 24);
  if (row.is_asked("bits") && !certified)
    row.problem("bits", "is about certified orbits", "say --precision certified, or leave it out");
  row_of_tracer(row, tracer);
}

void expect_tracer_of_view(OptionTable& row, const Tracer* tracer, const View& view) {
  if (tracer == nullptr || tracer->exact || !view.asks_for_all) return;
  std::string exact;
  for (const Tracer* other : tracers())
    if (other->exact) exact += (exact.empty() ? "" : " or ") + std::string(other->name);
  row.problem("tracer",
              fmt::format("'{}' finds the first wall of a ray alone, and the view {} asks for "
                          "all of them",
                          tracer->name, view.name),
              "say " + exact + ", or leave out --tracer");
}

}  // namespace flatray
