#include <fmt/core.h>

#include <array>
#include <cmath>

#include "base/processor_time.h"
#include "image/hdr.h"
#include "render/frame.h"
#include "study/accuracy/linear_error.h"

namespace flatray::flattening_choice {
namespace {

// A reference: chords within 2^-bits pixels, and the pieces in one pixel that are crossed pair by pair.
struct Fineness {
  int bits;
  std::size_t crowd;
};
constexpr std::array kFineness = {Fineness{12, 64}, Fineness{14, 128}, Fineness{16, 256},
                                  Fineness{18, 512}};

// The chords of a closed path, as edges; reversed where they bound a hole.
void add_chords(const ArcPath& path, double sagitta, bool hole, FillPath& out) {
  const std::vector<Vec2> points = flattened(path, sagitta);
  for (std::size_t i = 1; i < points.size(); ++i)
    out.edges.push_back(hole ? Segment{points[i], points[i - 1]}
                             : Segment{points[i - 1], points[i]});
}

ArcPath circle(const Vec2& centre, double radius) {
  return {{EllipseArc{centre, {radius, 0}, {0, radius}}}};
}

// The list with every curve as chords that stay within `sagitta` pixels of it, and their number.
struct Flattened {
  DrawList list;
  std::size_t chords = 0;
};
Flattened in_chords(const DrawList& list, double sagitta) {
  Flattened made{list};
  for (DrawItem& item : made.list.items) {
    FillPath path;
    if (const auto* ring = std::get_if<FillRing>(&item.region)) {
      add_chords(circle(ring->centre, ring->radius), sagitta, false, path);
      if (ring->inner_radius > 0)
        add_chords(circle(ring->centre, ring->inner_radius), sagitta, true, path);
    } else if (const auto* arcs = std::get_if<FillArcs>(&item.region)) {
      add_chords(arcs->path, sagitta, false, path);
    } else {
      continue;
    }
    made.chords += path.edges.size();
    item.region = std::move(path);
  }
  return made;
}

DrawList in_chords(const DrawList& list, const Fineness& fineness) {
  DrawList made = in_chords(list, std::ldexp(1.0, -fineness.bits)).list;
  made.crowd = fineness.crowd;
  return made;
}

LinearImage drawn(const DrawnFrame& curves, const DrawList& list) {
  return render_linear(list, {std::nullopt, curves.threads});
}

// Of chords all but nothing is rounded, of curves nothing else is.
std::function<Outcome()> judged(const std::shared_ptr<DrawnFrame>& curves, bool chords) {
  return [curves, chords] {
    const double error = rms_difference(curves->drawn.pixels, curves->truth.pixels);
    Outcome outcome{error, 0, develop(curves->drawn)};
    outcome.parts[static_cast<std::size_t>(ErrorKind::discretisation)] = chords ? error : 0;
    if (!chords) outcome.parts[static_cast<std::size_t>(ErrorKind::rounding)] = error;
    return outcome;
  };
}

Setting chords(const std::shared_ptr<DrawnFrame>& curves, int part) {
  const double sagitta = 1.0 / part;
  const std::size_t count = in_chords(curves->list, sagitta).chords;
  return {
      fmt::format("chords within 1/{} px", part), static_cast<double>(count),
      [curves, sagitta] { curves->drawn = drawn(*curves, in_chords(curves->list, sagitta).list); },
      judged(curves, true)};
}

// The finest there is time for, and how far the one before is from it.
struct Truth {
  Fineness finest, rough;
  double doubt;
};
Truth find_truth(DrawnFrame& curves, double seconds) {
  const double start = processor_seconds();
  LinearImage before = drawn(curves, in_chords(curves.list, kFineness[0]));
  for (std::size_t i = 1;; ++i) {
    const double begin = processor_seconds();
    curves.truth = drawn(curves, in_chords(curves.list, kFineness[i]));
    const double end = processor_seconds();
    // One step finer takes some four times as long.
    if (i + 1 == kFineness.size() || end + 4 * (end - begin) - start > seconds)
      return {kFineness[i], kFineness[i - 1], rms_difference(curves.truth.pixels, before.pixels)};
    before = std::move(curves.truth);
  }
}

std::string no_curve(const std::string& what) {
  return fmt::format("no curve bounds what {} fills; lines along curves are drawn as polygons",
                     what);
}

std::string left_out(const Scene& scene) {
  for (const Shape& shape : scene.shapes)
    if (!shape.circles.empty() || !shape.arc_paths.empty()) return "";
  return no_curve("the scene");
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  FLATRAY_TRY(frame, frame_to_draw(context));
  const std::shared_ptr<DrawnFrame>& curves = *frame;
  if (in_chords(curves->list, 1).chords == 0)
    return fail(context.scene.where,
                no_curve(fmt::format("frame {}", middle_frame(context.scene))));
  const auto [finest, rough, doubt] = find_truth(*curves, reference_budget(context));
  ChoiceSettings made;
  made.unit = "root mean square of linear light, 1 is white";
  made.reference = fmt::format(
      "frame {} with chords within 2^-{} px, by the exact coverage of polygons; those within 2^-{} "
      "px differ by {:.2g}",
      middle_frame(context.scene), finest.bits, rough.bits, doubt);
  if (finest.bits < kFineness.back().bits)
    made.cut = fmt::format("reference of chords within 2^-{} px instead of 2^-{} px", finest.bits,
                           kFineness.back().bits);
  made.doubt = doubt;
  made.grows = "chords";
  for (const int part : {1, 4, 16, 64, 256, 1024}) made.settings.push_back(chords(curves, part));
  made.settings.push_back({"curves as they are", 0,
                           [curves] { curves->drawn = drawn(*curves, curves->list); },
                           judged(curves, false)});
  return made;
}

}  // namespace

extern const Choice entry = {"flattening", "What would it cost to draw curves as polygons?",
                             ErrorKind::discretisation, &left_out, &settings};

}  // namespace flatray::flattening_choice
