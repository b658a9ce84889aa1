#pragma once
#include <span>
#include <string>
#include <vector>

#include "anim/world.h"
#include "base/result.h"
#include "render/film_shape.h"

namespace flatray {

struct LightGoal;
struct LightReport;
struct ShownLight;
struct Tracer;

/// Whether a pass runs on a scene, and why: shown by `flatray explain`.
struct Need {
  bool needed;
  std::string reason;
};
inline Need run(std::string reason) { return {true, std::move(reason)}; }
inline Need skip(std::string reason) { return {false, std::move(reason)}; }

/// How the light of a frame is traced.
struct LightRun {
  unsigned threads = 1;
  bool (*stop)() = nullptr;          ///< FrameOptions::stop
  bool raw = false;                  ///< fluence itself, not exposed and toned for the eye
  const LightGoal* goal = nullptr;   ///< null: all rays of the scene
  LightReport* report = nullptr;     ///< where to tell of it, if anywhere
  const ShownLight* kept = nullptr;  ///< light of all frames, instead of tracing it
};

/// What a pass draws from and into. Items are ordered by layer, then by their place in the scene
/// file.
class DrawContext {
 public:
  DrawContext(const Timeline& timeline, const FrameState& state, const Tracer* tracer);

  const Timeline& timeline;
  const Scene& scene;
  const FrameState& state;
  const Tracer* const tracer;  ///< of rays; null: the one of choice
  const FilmTransform film_from_world;
  LightRun light{};

  /// Light of the whole film, added to what lies below.
  void add_light(std::shared_ptr<const LightPicture> picture);

  /// `shape` posed in the world, filled and outlined; nothing where it lies beside the film.
  void add_shape(const Shape& shape, const Pose& world_from_shape, const std::optional<Paint>& fill,
                 const std::optional<Stroke>& stroke);
  /// Lines of one stroke as one region: where they cross, nothing shows twice. World coordinates.
  void add_lines(std::span<const Segment> world, const Stroke& stroke);
  /// A round mark; radius in film pixels.
  void add_mark(const Vec2& world, double radius_px, const Colour& colour);

  /// What `draw` adds is one picture, which is then faded.
  template <class Draw>
  void fade(double opacity, const Draw& draw) {
    const std::size_t first = items_.size(), parts = parts_;
    draw();
    if (opacity < 1) fade_from(first, parts_ - parts, static_cast<float>(opacity));
  }

  /// Half the width of a stroke, film pixels.
  double half_width_px(const Stroke& stroke) const;

  /// Whether the frame has too many corners: what is added from now on is not looked at.
  bool refused() const { return refused_.has_value(); }

  /// Where the next items belong, and what table of the scene they come from.
  void place(int layer, std::uint64_t order, const Place& where);
  /// Error   the table that takes more corners than Scene::max_corners leave it.
  Result<std::vector<DrawItem>> sorted_items() &&;

 private:
  struct Placed {
    int layer;
    std::uint64_t order;
    DrawItem item;
  };
  void add(DrawItem&& item);
  void add_regions(std::vector<Region>&& regions, const Paint& paint, const Pose& place);
  void add_outline(const FilmShape& there, const Stroke& stroke, const Pose& place);
  void fade_from(std::size_t first, std::size_t parts, float opacity);
  bool take(std::uint64_t corners);
  LineLook look_of(const Stroke& stroke) const;

  std::vector<Placed> items_;
  int layer_ = 0;
  std::uint64_t order_ = 0;
  Place where_;
  CornerBudget corners_;
  std::optional<Place> refused_;  ///< who asked for more
  std::size_t parts_ = 0;         ///< items, and those left out beside the film
  std::uint32_t layers_ = 0;      ///< numbers given to DrawItem::layer
};

/// One kind of thing drawn. `need` decides once a scene; `draw` adds a frame's items.
struct Pass {
  const char* name;
  Need (*need)(const Scene&);
  void (*draw)(DrawContext&);
};

/// Registered passes by name.
std::vector<const Pass*> passes();

}  // namespace flatray
