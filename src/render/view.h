#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "anim/world.h"
#include "image/image.h"
#include "render/film_transform.h"
#include "render/frame.h"
#include "trace/tracer.h"

namespace flatray {

/// One frame, and what of it a view is to draw.
struct ViewFrame {
  const Scene& scene;
  const FrameState& state;
  const Tracer* tracer;  ///< null: the one of choice
  Vec2 argument;         ///< world point, for views that take one
  PixelBox crop;
  unsigned threads;
};

/// Draws a row of the crop into `pixels`, three bytes each; by any thread. `row` counts from the top of
/// the film.
using RowDrawer = std::function<void(int row, std::uint8_t* pixels)>;
/// Takes what draws the rows of a frame, and has all of them drawn.
using EachRow = std::function<void(const RowDrawer& draw)>;

/// One kind of question asked of every pixel.
struct View {
  const char* name;
  const char* summary;  ///< one line, no full stop
  bool takes_point;     ///< as in "visibility:x,y"
  bool asks_for_all;    ///< walls of a ray, not for the first alone: so of exact tracers only
  /// Makes ready, once for all rows, what the rays of the view are asked of, and no more.
  void (*draw)(const ViewFrame& frame, const EachRow& each_row);
};

/// Registered views by name.
std::vector<const View*> views();

/// Centre of a pixel in the world.
Vec2 pixel_centre(const ViewFrame& frame, int column, int row);
/// World length of a pixel's side.
double pixel_side(const ViewFrame& frame);
/// One ray to the right from every pixel of a row, t = 1 a pixel on.
RayBatch rays_to_the_right(const ViewFrame& frame, int row);
/// Walls made ready by the tracer of the frame. Needs   `walls` to outlive it.
std::unique_ptr<Accelerator> made_ready(const Surfaces& walls, const ViewFrame& frame);
/// 255 at 0 and 0 from `most` on.
std::uint8_t grey_of(double value, double most);

/// The outlines of all that the scene shows, but for what no ray meets: rings that cross themselves.
class SeenWalls {
 public:
  SeenWalls(const ViewFrame& frame, World world)
      : world_(std::move(world)), walls_(made_ready(world_.surfaces, frame)) {}
  explicit SeenWalls(const ViewFrame& frame)
      : SeenWalls(frame, build_world(frame.scene, frame.state, WorldOf::everything)) {}
  SeenWalls(const SeenWalls&) = delete;
  SeenWalls& operator=(const SeenWalls&) = delete;

  /// What each ray of a row meets first.
  std::vector<NearestHit> nearest(const RayBatch& rays) const;
  /// Whether a ray meets any after its start and before its tip, at t = 1.
  bool crosses(const Ray& ray) const;
  const SurfaceOwner& owner(const NearestHit& hit) const { return world_.owner(hit.surface); }
  const Surfaces& surfaces() const { return world_.surfaces; }

 private:
  const World world_;
  const std::unique_ptr<Accelerator> walls_;
};

/// A view as the user asks for it.
struct ViewRequest {
  const View* view = nullptr;
  Vec2 point{0, 0};
};

/// Same bytes from every exact tracer (null: the one chosen by the number of walls), for any number
/// of threads and crop; no picture once `options.stop` has said so.
///
/// Needs   an exact tracer where the view asks for all walls of a ray.
Image draw_view(const ViewRequest& request, const Tracer* tracer, const Scene& scene,
                const FrameState& state, const FrameOptions& options);

}  // namespace flatray
