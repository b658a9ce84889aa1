
#include "base/counted.h"
#include "scene/imports/obj_chunk.h"
#include "scene/imports/obj_text.h"
#include "scene/outlines/ring.h"
#include "scene/reading/format.h"
#include "scene/reading/made_values.h"
#include "scene/reading/vocabulary.h"

namespace flatray::obj_format {
namespace {

// Of the corners of faces and lines: other vertices are not seen.
Vec2 centre_of(const ObjText& obj) {
  Bounds bounds;
  for (const auto chains : {&obj.faces, &obj.lines})
    for (const std::uint32_t corner : chains->corners) bounds.add(obj.vertices[corner]);
  return bounds.empty() ? Vec2(0, 0) : bounds.centre();
}

// Where the vertices go before any decision is made about them, so that decisions are about the
// final doubles. Gives the number of the first that lies too far away, or how many there are.
std::size_t lay(ObjText& obj, const OutlineOptions& options) {
  const Vec2 origin = options.centre ? centre_of(obj) : Vec2(0, 0);
  std::vector<Vec2>& vertices = obj.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (options.centre) vertices[i] -= origin;
    vertices[i] *= options.scale;
    if (!(vertices[i].cwiseAbs().maxCoeff() <= kFarthest)) return i;
  }
  return vertices.size();
}

// Makes a shape of faces and lines, counting what it must leave out.
struct ShapeMaker {
  const ObjText& obj;
  Shape shape{};
  std::int32_t next_edge = 0;
  std::vector<std::size_t> flat{}, crossing{};  ///< numbers of the faces left out
  std::size_t face = 0;

  void add_face(std::span<const std::uint32_t> corners) {
    const auto count = static_cast<std::int32_t>(corners.size());
    if (count == 3)
      add_three(corners);
    else
      add_many(corners);
    next_edge += count;
    ++face;
  }

  void add_three(std::span<const std::uint32_t> corners) {
    const std::array<Vec2, 3> points = {obj.vertices[corners[0]], obj.vertices[corners[1]],
                                        obj.vertices[corners[2]]};
    const Sign turn = orientation(points[0], points[1], points[2]);
    if (turn == Sign::zero)
      flat.push_back(face);
    else
      add_triangle(shape, points, turn == Sign::negative, next_edge);
  }

  void add_many(std::span<const std::uint32_t> corners) {
    std::vector<Vec2> points;
    points.reserve(corners.size());
    for (const std::uint32_t corner : corners) points.push_back(obj.vertices[corner]);
    if (is_flat(points))
      flat.push_back(face);
    else if (non_convex_vertex(points) && crossing_edges(points))
      crossing.push_back(face);
    else
      add_ring(shape, points, next_edge);
  }

  void add_line(std::span<const std::uint32_t> corners) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const Segment segment{obj.vertices[corners[i]], obj.vertices[corners[i + 1]]};
      if (segment.a != segment.b) shape.segments.push_back(segment);
    }
  }
};

template <class Add>
void each(const ObjText::Chains& chains, const Add& add) {
  for (std::size_t i = 0; i < chains.size(); ++i)
    add(std::span(chains.corners).subspan(chains.begin[i], chains.begin[i + 1] - chains.begin[i]));
}

void warn(const ShapeMaker& maker, const ObjText& obj, const SourcePtr& source,
          Diagnostics& warnings) {
  const auto left_out = [&](const std::vector<std::size_t>& faces, const char* why,
                            const char* hint) {
    if (!faces.empty())
      warnings.push_back(
          {obj_record_place(source, "f", faces.front()),
           counted(faces.size(), "face") + why + (faces.size() == 1 ? "" : "; this is the first"),
           hint});
  };
  left_out(maker.flat, " without area left out", "z is dropped: faces seen edge-on have none");
  left_out(maker.crossing, " left out because of edges that cross", "cut it where they do");
  const Place file = named_place(source->name());
  if (!obj.ignored.empty())
    warnings.push_back({file, comma_list(obj.ignored) + " ignored", "v, f and l are read"});
}

Result<Shape> outline(const SourcePtr& source, const OutlineOptions& options,
                      Diagnostics& warnings) {
  FLATRAY_TRY(obj, parse_obj(source, options.threads));
  const Place file = named_place(source->name());
  if (const std::size_t far = lay(*obj, options); far < obj->vertices.size())
    return fail(obj_record_place(source, "v", far), "this vertex comes to lie beyond 1e300",
                "choose a smaller scale");
  ShapeMaker maker{*obj};
  maker.shape.vertices.reserve(obj->faces.corners.size());
  maker.shape.edges.reserve(obj->faces.corners.size());
  maker.shape.begin.reserve(obj->faces.size() + 1);
  each(obj->faces, [&](auto corners) { maker.add_face(corners); });
  each(obj->lines, [&](auto corners) { maker.add_line(corners); });
  warn(maker, *obj, source, warnings);
  const bool empty = maker.shape.piece_count() == 0 && maker.shape.segments.empty();
  if (empty && !maker.crossing.empty())
    return fail(obj_record_place(source, "f", maker.crossing.front()),
                "edges of this face cross, and nothing else in the file has extent",
                "cut it where they do");
  if (empty)
    return fail(file, "the file holds no face or line with extent", "v, f and l records are read");
  return std::move(maker.shape);
}

// The whole scene: one entity, imported from the very file.
Result<SceneDesc> read(const SourcePtr& source, const LoadLimits&) {
  const Place file{source, 0, 1};
  const auto text = [&](const char* key, std::string content) {
    return member(key, string_value(file, std::move(content)));
  };
  Value shape = table_of(
      file, member("import", table_of(file, text("file", source->name()), text("format", "obj"))));
  Value entity =
      table_of(file, text("name", scene_name(source->name())), member("shape", std::move(shape)));
  return SceneDesc{table_of(file, Member{"flatray", file, built_in_number(1)},
                            member("entity", array_value(file, {std::move(entity)})))};
}

bool recognises(std::string_view text) {
  const std::string_view line = first_line(text);
  const std::string_view record = line.substr(0, line.find_first_of(" \t"));
  for (const std::string_view known :
       {"v", "vn", "vt", "o", "g", "f", "l", "s", "mtllib", "usemtl"})
    if (record == known && line.find('=') == std::string_view::npos) return true;
  return false;
}

constexpr std::string_view kExtensions[] = {"obj", "obj2d"};

}  // namespace

extern const Format entry = {"obj",       "Wavefront OBJ and obj2d: v, f, l; z is dropped",
                             kExtensions, &recognises,
                             &read,       &outline};

}  // namespace flatray::obj_format
