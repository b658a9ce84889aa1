#include <algorithm>
#include <cmath>

#include "scene/keys/keys.h"
#include "scene/keys/motion_keys.h"
#include "scene/keys/scene_keys.h"

namespace flatray {
namespace {

constexpr Word<Coverage> kCoverages[] = {
    {"area", Coverage::area}, {"rows", Coverage::rows}, {"centre", Coverage::centre}};
constexpr Word<CameraMotion> kMotions[] = {{"frame-origin", CameraMotion::frame_origin},
                                           {"objects", CameraMotion::objects}};
constexpr Word<bool> kWindows[] = {{"pixels", true}};
constexpr std::int64_t kMaxSide = 2147483647;

void read_size(Builder& builder, const Field& field, Film& film) {
  if (!builder.in.is_pair(field, "two whole numbers")) return;
  const auto width = builder.in.integer(field.item(0), 1, kMaxSide);
  const auto height = builder.in.integer(field.item(1), 1, kMaxSide);
  if (!width || !height) return;
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(*width) * static_cast<std::uint64_t>(*height);
  if (pixels > builder.limits.max_pixels)
    return builder.in.problem(
        field, fmt::format("{} x {} is {} pixels", *width, *height, pixels),
        fmt::format("the limit is {}; --max-pixels raises it", builder.limits.max_pixels));
  film.width = static_cast<int>(*width);
  film.height = static_cast<int>(*height);
}

// The size has been read before.
void read_world(Builder& builder, const Field& field, Film& film) {
  if (field.value.kind == Value::Kind::string) {
    if (builder.in.word<bool>(field, kWindows))
      film.world = Bounds{{0, 0}, Vec2(film.width, film.height)};
  } else if (const auto world = builder.in.box(field)) {
    film.world = world;
    const Vec2 size = world->size();
    if (!std::isfinite(std::min(film.width / size.x(), film.height / size.y())))
      builder.in.problem(field, "is so small that a unit has no number of pixels",
                         "write a window of 1e-300 or more");
  }
}

constexpr Key<Film> kFilmKeys[] = {
    {{"size", "[width, height]", "[640, 360]"}, &read_size},
    {{"world", R"([[x0, y0], [x1, y1]] or "pixels")", "what the scene holds, and 5 %"},
     &read_world},
    {{"background", "\"#rrggbb\"", "\"#ffffff\"; with lamps \"#000000\""}, &set<&Film::background>},
    {{"coverage", R"("area", "rows" or "centre")", "\"area\""},
     &set_word<&Film::coverage, kCoverages>},
    {{"rows", "whole number", "4"}, &set_integer<&Film::rows, 1, 64>},
};

void read_camera_at(Builder& builder, const Field& field, Camera& camera) {
  camera.at = read_moving_point(builder, field);
}

std::optional<Moving> read_above_zero(Builder& builder, const Field& field, const char* hint) {
  const auto number = read_moving(builder, field);
  if (!number) return std::nullopt;
  if (lowest(builder.scene, *number) > 0) return number;
  return builder.in.refuse(field, "is not above 0", hint);
}

void read_height(Builder& builder, const Field& field, Camera& camera) {
  camera.height = read_above_zero(builder, field, "write the world units the picture is high");
}

void read_zoom(Builder& builder, const Field& field, Camera& camera) {
  const auto zoom = read_above_zero(builder, field, "write 2 to show everything twice as large");
  if (zoom) camera.zoom = *zoom;
}

constexpr Key<Camera> kCameraKeys[] = {
    {{"at", "[x, y] or a curve", "the middle of film.world"}, &read_camera_at},
    {{"height", "number or a curve", "that of film.world"}, &read_height},
    {{"zoom", "number or a curve", "1"}, &read_zoom},
    {{"follow", "\"ENTITY\"", "none"}, &set_entity<&Camera::follow>},
    {{"offset", "[dx, dy]", "[0, 0]"}, &set<&Camera::offset>},
    {{"velocity", "[vx, vy]", "[0, 0]"}, &set<&Camera::velocity>},
    {{"motion", R"("frame-origin" or "objects")", "\"frame-origin\""},
     &set_word<&Camera::motion, kMotions>},
};

}  // namespace

void read_film(Builder& builder, const Field& field, Scene& scene) {
  read_keys(builder, field.value, "film", kFilmKeys, scene.film);
}

void read_camera(Builder& builder, const Field& field, Scene& scene) {
  Camera& camera = scene.camera;
  read_keys(builder, field.value, "camera", kCameraKeys, camera);
  if (camera.follow && camera.at)
    builder.in.problem(field.value.where, "follow and at both say where the camera looks",
                       "leave at out: offset moves it beside what it follows");
  const Member* offset = field.value.find("offset");
  if (offset != nullptr && field.value.find("follow") == nullptr)
    builder.in.warning(offset->where, "offset moves nothing: the camera follows no entity",
                       "write follow = \"ENTITY\", or say where it looks by at");
}

std::vector<TableInfo> film_tables() {
  return {{"film", key_infos<Film>(kFilmKeys)}, {"camera", key_infos<Camera>(kCameraKeys)}};
}

}  // namespace flatray
