#include <fmt/core.h>

#include "render/frame.h"
#include "study/accuracy/linear_error.h"

namespace flatray::flattening_choice {
namespace {

constexpr double kTruthSagitta = 0x1p-18, kDoubtSagitta = 0x1p-16;  // px

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

LinearImage drawn(const DrawnFrame& curves, const DrawList& list) {
  return render_linear(list, {std::nullopt, curves.threads});
}

// Of chords all but nothing is rounded, of curves nothing else is.
std::function<Outcome()> judged(const std::shared_ptr<DrawnFrame>& curves, bool chords) {
  return [curves, chords] {
    const double error = rms_difference(curves->drawn.pixels, curves->truth.pixels);
    Outcome outcome{error, 0, developed(curves->drawn)};
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

std::string left_out(const Scene& scene) {
  for (const Shape& shape : scene.shapes)
    if (!shape.circles.empty() || !shape.arc_paths.empty()) return "";
  return "the scene has no curves";
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  FLATRAY_TRY(frame, frame_to_draw(context));
  const std::shared_ptr<DrawnFrame>& curves = *frame;
  if (in_chords(curves->list, 1).chords == 0)
    return fail(context.scene.where,
                fmt::format("frame {} shows no curve", middle_frame(context.scene)));
  curves->truth = drawn(*curves, in_chords(curves->list, kTruthSagitta).list);
  const LinearImage rough = drawn(*curves, in_chords(curves->list, kDoubtSagitta).list);
  const double doubt = rms_difference(curves->truth.pixels, rough.pixels);
  ChoiceSettings made;
  made.unit = "root mean square of linear light, 1 is white";
  made.reference = fmt::format(
      "frame {} with chords within 2^-18 px, by the exact coverage of polygons; those within 2^-16 "
      "px differ by {:.2g}",
      middle_frame(context.scene), doubt);
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
