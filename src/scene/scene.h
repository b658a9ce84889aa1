#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/source_text.h"
#include "geom/primitives/bezier.h"
#include "scene/paint.h"
#include "scene/wall_parts.h"

namespace flatray {

/// How a pixel is made of what it shows: its mean over the area, along some rays, or at its centre.
enum class Coverage { area, rows, centre };
enum class FillRule { nonzero, even_odd };

/// Largest coordinate of a scene, an import or a frame: products and differences of any two stay
/// finite where they are added, and what moves farther is held there.
inline constexpr double kFarthest = 1e300;

/// A shape in its own coordinates, made of parts that stay what they are: convex pieces, circles,
/// segments, paths of arcs, Bezier curves. Its pieces combine by union.
///
/// Convex pieces lie one after another in `vertices`, counter-clockwise, area > 0. Edges two pieces share
/// (same two doubles, opposite directions) are inside the shape; `edges` keeps the input's numbers.
struct Shape {
  std::vector<Vec2> vertices{};
  std::vector<std::uint32_t> begin{0};  ///< piece i is vertices [begin[i], begin[i + 1])
  /// Input edge from vertex k to the next of its piece; -1: a cut.
  std::vector<std::int32_t> edges{};
  /// By piece, as far as any is: whether it was given clockwise, so that its edges run the other way.
  std::vector<bool> clockwise{};
  std::vector<Circle> circles{};
  std::vector<Segment> segments{};
  std::vector<std::vector<Vec2>> crossing_rings{};  ///< drawn by even-odd, never traced
  std::vector<ArcPath> arc_paths{};                 ///< closed ones do not cross themselves
  std::vector<Bezier> beziers{};                    ///< lines, as segments are
  /// Index into Scene::changing_shapes; this shape is then what that one is at one of its times.
  std::uint32_t changes = kNoEntry;

  std::size_t piece_count() const { return begin.size() - 1; }
};
using ShapeId = std::uint32_t;  ///< index into Scene::shapes

struct ShapeType;

/// Arguments as they were read. Some of their numbers may be curves over time.
struct KeptArguments {
  struct Argument {
    const char* key;
    std::vector<Moving> numbers;  ///< two of a point; truth values, words and counts as numbers
    std::string text;
  };
  std::vector<Argument> arguments;
};

/// A shape some of whose numbers are curves over time.
struct ChangingShape : KeptArguments {
  const ShapeType* type;
};

class Spectrum;

/// How bright a lamp is, and of what colour.
struct LampLight {
  Moving power{1, {}};
  Paint colour{Colour{255, 255, 255, 255}};  ///< where none of the next three is set
  std::optional<Moving> wavelength;          ///< nm
  std::optional<Moving> temperature;         ///< of a blackbody, kelvin
  std::shared_ptr<const Spectrum> spectrum;  ///< of a file
};

/// What a Markov state or sub-state changes. What is not set stays as the entity or lamp has it.
struct Look {
  std::string name;  ///< of the sub-state, "" if unnamed
  std::optional<ShapeId> shape;
  std::optional<Paint> fill;
  std::optional<Stroke> stroke;
  std::optional<Vec2> velocity;
  std::shared_ptr<const LampLight> light;  ///< of a lamp
};

using StateId = std::uint32_t;

struct Transition {
  std::uint64_t cumulative;  ///< the first that is >= the draw is taken; the last is 2^64 - 1
  StateId to;
};

enum class ChainRepair { none, to_start, to_self, scaled };

struct MarkovChain {
  std::string name;
  unsigned hold = 1;  ///< frames between draws
  std::vector<std::string> states;
  std::vector<std::vector<Transition>> rows;       ///< by StateId; probability 0 is dropped
  std::vector<std::vector<double>> probabilities;  ///< rows x states, for reports: nearest doubles
  /// The same as exact fractions after the repair, "3/5" or "60/91", "0" where dropped: filled by
  /// the scene builder, so that reports can print closed forms exactly. Empty: not known beyond the
  /// doubles.
  std::vector<std::vector<std::string>> fractions;
  StateId start = 0;  ///< where repair = "to-start" sends the missing rest; else the first row
};

struct MarkovUse {
  std::uint32_t chain = 0;  ///< index into Scene::chains
  StateId start = 0;
  std::optional<StateId> hit;  ///< state it is in from the first frame after it met another
  std::vector<std::vector<Look>>
      looks;  ///< by StateId: its sub-states in order, one a frame; may be empty
};

/// A path of straight edges, each longer than 0. A closed path ends where it begins.
struct Path {
  std::vector<Vec2> points;
  std::vector<double> lengths;  ///< along the path from its first point to each
  bool closed = false;
};

class Scatterer;
using ScattererId = std::uint32_t;  ///< index into Scene::scatterers

/// Walks a path: `start` + `speed` * t / `duration` of its length at time t.
struct Follow {
  std::uint32_t path = 0;  ///< index into Scene::paths
  double speed = 0, duration = 1, start = 0;
  bool turn = false;  ///< whether it turns to look where it goes
};

/// What is added to `at` (of its group) and `angle` (radians) as time goes by.
struct Motion {
  std::optional<CurveId> x, y, angle;
  std::optional<Follow> follow;

  bool any() const { return x || y || angle || follow; }
};

/// What stands somewhere, and how it moves.
struct Movable {
  std::string name;
  std::optional<std::uint32_t> group;  ///< index into Scene::groups: what `at` is seen from
  Vec2 at{0, 0};
  double angle = 0;             ///< radians, counter-clockwise
  Vec2 velocity{0, 0};          ///< world units a second
  double angular_velocity = 0;  ///< radians a second
  Motion motion;
  Place where;

  /// Whether it moves in its group.
  bool changes_place() const {
    return motion.any() || !velocity.isZero(0) || angular_velocity != 0;
  }
};

/// Things that move together. A copy of a group is a group of its own. It stands in one of a lower
/// number; what is in it turns about its origin.
struct Group : Movable {
  Moving scale{1, {}};  ///< > 0, a curve >= 0; what is in it grows about its origin
  int layer = 0;        ///< added to those of what is in it; the sum over the groups it stands in
};

/// What an entity does when it meets another.
enum class Response : std::uint8_t {
  none,    ///< nothing: it meets none
  mark,    ///< goes on, and so does the other; the first meeting of each pair is told
  stop,    ///< stands still from then on, or goes with the one that nothing moves
  bounce,  ///< elastically, without friction and turning
  slide,   ///< keeps its velocity along the contact, not the one against it
  remove   ///< vanishes; to the other it is a wall
};

struct Entity : Movable {
  ShapeId shape = 0;
  std::optional<Paint> fill;
  std::optional<Stroke> stroke;
  Moving opacity{1, {}};               ///< of fill and stroke together
  std::optional<Stroke> bounding_box;  ///< drawn when set
  int layer = 0;
  std::optional<Material> material;  ///< unset: scenery, which rays pass through
  ScattererId scatterer = kNoEntry;  ///< what it does with light; none: what `material` says
  /// Segments, as its shape is. Each leg of light meets its shape or one of these, by chance; all
  /// else meets its shape.
  std::vector<ShapeId> alternatives;
  std::optional<MarkovUse> markov;
  std::optional<Response> response;  ///< unset: that of Scene::collisions
  std::optional<double> mass;        ///< infinite: nothing moves it; unset: its area
  std::uint64_t order = 0;           ///< of drawing within a layer
};

/// A room, convex or simple, with pillars in it: rays bounce inside.
struct Chamber {
  std::string name;
  ShapeId shape = 0;
  Material material = Material::mirror;
  ScattererId scatterer = kNoEntry;
  std::optional<Paint> fill;
  std::optional<Stroke> stroke;
  double opacity = 1;  ///< of it and its pillars together
  int layer = 0;
  struct Pillar {
    std::string name;
    ShapeId shape = 0;
    Vec2 at{0, 0};
    double angle = 0;
    Material material = Material::mirror;
    ScattererId scatterer = kNoEntry;
    std::optional<Paint> fill;
    std::optional<Stroke> stroke;
    Place where;
    /// Whether it is a disc across periodic walls; and where this is a copy that reaches in from a
    /// neighbouring cell, of which pillar. Copies follow all other pillars.
    bool across = false;
    std::optional<std::uint32_t> copy_of;
  };
  std::vector<Pillar> pillars;
  std::vector<WallHole> holes;
  std::vector<WallPiece> parts;  ///< of all walls, in turn, where there are holes
  Shape kept;                    ///< lines along what the holes leave
  double field = 0;  ///< magnetic, across it: 1 / radius of flights, positive where they turn left
  Place where;
  std::uint64_t order = 0;
};

/// An orbit to trace and draw: starts at `at`, reflected by mirrors, ended by what absorbs.
struct RayPath : Movable {
  MovingPoint direction{{1, 0}, {}, {}};  ///< turned by its angle
  unsigned bounces = 0;                   ///< after which it flies once more
  /// With which it sets off, in frame 1; world units a second. It meets mirrors where they are when
  /// it comes there, and its way up to the frame is drawn. Unset: the mirrors of each frame stand
  /// still.
  std::optional<double> speed;
  Stroke stroke{1.5, true, Colour{0xd6, 0x27, 0x28, 255}};
  std::optional<Colour> hit_points;  ///< marks where it bounces
  std::optional<Colour> end_colour;  ///< of the line after its last bounce, gone over to evenly
  std::optional<Colour> numbers;     ///< counts its bounces
  /// Goes along the path as time goes by; the path is drawn as far as it has come.
  struct Ball {
    double speed = 0;  ///< world units a second; not used where the ray has a speed of its own
    Moving radius{1, {}};
    Colour colour;
  };
  std::optional<Ball> ball;
  /// Rays that a scene file writes as one; the scene holds each of them by itself.
  struct Fan {
    unsigned count = 1;
    Moving spread{};   ///< radians from the first direction to the last
    Moving width{};    ///< from the first start to the last, across the direction
    double place = 0;  ///< of this one among them, from -1/2 to 1/2
  };
  std::optional<Fan> fan;
  std::string written_name;  ///< of the fan it is one of; else its own
  Moving opacity{1, {}};     ///< of the line and its marks together
  int layer = 0;
  std::uint64_t order = 0;
};

struct LampType;

/// What sends out light, `power` a second in all directions together, per unit of depth.
struct Lamp : Movable, LampLight {
  const LampType* type = nullptr;  ///< how its rays set off
  KeptArguments source;            ///< of the type
  std::optional<MarkovUse> markov;
};

enum class LightSampler : std::uint8_t {
  sorted,  ///< Owen-scrambled Sobol numbers for lamps; bounces in order of place take a net
  random   ///< independent numbers
};

/// Which way light is followed.
enum class LightEstimator : std::uint8_t {
  automatic,  ///< backward where a small part of the scene is shown, and it can; else forward
  forward,    ///< from lamps: all pixels that a path crosses get some
  backward    ///< from each pixel, until a lamp is met
};

/// How light in [0, infinity) becomes a picture.
enum class ToneCurve : std::uint8_t {
  linear,  ///< as it is; above 1 it is white
  soft,    ///< x (1 + x / 16) / (1 + x): white at 4
  filmic,  ///< a curve with a foot and a shoulder
  gamma    ///< levels are x^(1 / gamma), whatever the eye makes of them
};

/// How the light of lamps is traced and shown.
struct LightSettings {
  std::uint64_t rays = 1'000'000;
  unsigned bounces = 1000;      ///< at most; what is left is cut off, and counted
  bool bounces_chosen = false;  ///< by the scene: then what is cut off is not warned of
  unsigned scrambles = 1;       ///< pictures of a part of the rays each: their spread is the error
  std::optional<double> exposure;  ///< light of 1 is shown as this; unset: chosen by the picture
  ToneCurve tone = ToneCurve::soft;
  double gamma = 2.2;  ///< of that curve
  LightSampler sampler = LightSampler::sorted;
  LightEstimator estimator = LightEstimator::automatic;
  bool noise_moves = false;  ///< other random numbers in each frame
  int layer = -1;            ///< where it is added to what is drawn
  Place where;
};

/// The paper's Figure 4: the edges of one entity as rays against another, the inside part thick,
/// the entering and exiting points marked.
struct EdgeRays {
  std::uint32_t from = 0, against = 0;  ///< entities
  Stroke stroke;                        ///< of the rays; the inside part is three times as wide
  Colour inside, enter, exit;
  int layer = 0;
  Place where;
  std::uint64_t order = 0;
};

/// What follows where entities meet.
struct Collisions {
  Response response = Response::none;  ///< of entities that do not say
  std::uint64_t most = 1'000'000;      ///< events
  std::optional<Colour> points;        ///< marks where they met
  std::optional<Stroke> normals;       ///< of lines along the normals
  std::optional<Stroke> ghosts;        ///< outlines of both at the instant they met
  std::optional<Stroke> time_bar;      ///< all events of the scene, and the time of the frame
  std::optional<double> shown;         ///< seconds until what is drawn of an event has faded
  int layer = 1;
  Place where;
  std::uint64_t order = 0;
};

/// How the window moves (the paper's Figure 3). `frame_origin` moves the window; `objects` moves
/// everything else the other way and must give the same picture.
enum class CameraMotion { frame_origin, objects };

struct Camera {
  /// World position of the window's centre; unset: film.world or content.
  std::optional<MovingPoint> at;
  std::optional<Moving> height;         ///< world units the picture is high
  Moving zoom{1, {}};                   ///< how many times larger than that things are shown
  std::optional<std::uint32_t> follow;  ///< entity kept at the window's centre plus `offset`
  Vec2 offset{0, 0};
  Vec2 velocity{0, 0};  ///< of the window's origin, world units a second
  CameraMotion motion = CameraMotion::frame_origin;
};

struct Film {
  int width = 640, height = 360;
  std::optional<Bounds> world;  ///< window wanted; grown to the film's aspect
  Colour background{255, 255, 255, 255};
  Coverage coverage = Coverage::area;
  int rows = 4;  ///< rays of each row of pixels, of Coverage::rows
};

/// A validated scene: finite, convex pieces counter-clockwise, chains summing to 1. Never changed
/// once built.
struct Scene {
  std::string name;  ///< file name without folder and extension
  Place where;       ///< the file, by its name
  Film film;
  Camera camera;
  std::uint64_t max_corners = std::uint64_t{1} << 25;  ///< of all that one frame draws
  unsigned frames = 1;
  bool ends = false;  ///< after these frames: none can be drawn beyond them
  double fps = 24;
  std::uint64_t seed = 0;
  std::vector<Shape> shapes;
  std::vector<ChangingShape> changing_shapes;
  std::vector<Gradient> gradients;
  std::vector<std::vector<double>> dashes;  ///< line, gap, ...: an even number, not all 0
  std::vector<Curve> curves;
  std::vector<Path> paths;
  std::vector<Group> groups;
  std::vector<Entity> entities;
  std::vector<Chamber> chambers;
  double field() const { return chambers.empty() ? 0 : chambers.front().field; }
  std::vector<RayPath> rays;
  std::vector<EdgeRays> edge_rays;
  std::vector<Lamp> lamps;
  LightSettings light;
  std::vector<std::shared_ptr<const Scatterer>> scatterers;
  std::optional<Collisions> collisions;
  std::vector<MarkovChain> chains;
  std::uint64_t hash = 0;  ///< of the source text, its imports and overrides
};

}  // namespace flatray
