#include "render/gl/module/programs.h"

#include <stdexcept>
#include <utility>

#include "render/gl/module.h"

namespace flatray::gl {
namespace {

constexpr const char* kVersion = "#version 330 core\n";
constexpr const char* kSamples = "#define SHEET sampler2DMS\n";
constexpr const char* kPixels = "#define SHEET sampler2D\n";  // level 0 is called like sample 0

// Powers of two, so that nothing is rounded on the way from the grid to the rasterizer's own.
constexpr const char* kVertex = R"(
layout(location = 0) in vec2 place;
layout(location = 1) in vec4 paint;
uniform vec2 shift;
flat out vec4 given;
void main() {
  given = paint;
  gl_Position = vec4((place + shift) / 1024.0 - 1.0, 0.0, 1.0);
}
)";
static_assert(FLATRAY_GL_TILE == 2 * 1024);

constexpr const char* kPaint = R"(
flat in vec4 given;
out vec4 shown;
void main() { shown = given; }
)";

// As GradientPainter::at, number for number: in floats a pixel's centre may come to lie on the
// other side of a stop. A picture that is moved for its samples keeps the pixels' centres.
constexpr const char* kGradient = R"(
#extension GL_ARB_gpu_shader_fp64 : require
#extension GL_ARB_gpu_shader5 : require
flat in vec4 given;
uniform ivec2 corner;
uniform usamplerBuffer gradients, stops;
out vec4 shown;
dvec2 numbers(uvec4 words) { return dvec2(packDouble2x32(words.xy), packDouble2x32(words.zw)); }
double stop_at(int i) { return packDouble2x32(texelFetch(stops, 2 * i).xy); }
vec4 stop_light(int i) { return uintBitsToFloat(texelFetch(stops, 2 * i + 1)); }
void main() {
  int record = 3 * int(given.x);
  uvec4 head = texelFetch(gradients, record);
  dvec2 origin = numbers(texelFetch(gradients, record + 1));
  dvec2 axis = numbers(texelFetch(gradients, record + 2));
  precise dvec2 d = dvec2(corner + ivec2(gl_FragCoord.xy)) + 0.5 - origin;
  precise double xx = d.x * d.x, yy = d.y * d.y, along_x = d.x * axis.x, along_y = d.y * axis.y;
  precise double t = head.x != 0u ? sqrt(xx + yy) * axis.x : along_x + along_y;
  int first = int(head.y), end = first + int(head.z), next = first;
  while (next < end && stop_at(next) <= t) ++next;
  if (next == first || next == end) {
    shown = stop_light(next == first ? first : end - 1);
    return;
  }
  double from = stop_at(next - 1);
  float share = float((t - from) / (stop_at(next) - from));
  vec4 before = stop_light(next - 1);
  precise vec4 more = (stop_light(next) - before) * share;
  precise vec4 light = before + more;
  shown = light;
}
)";

constexpr const char* kSum = R"(
out vec4 shown;
void main() { shown = vec4(gl_FrontFacing ? 1.0 : -1.0); }
)";

constexpr const char* kFind = R"(
uniform SHEET sheet;
uniform int seen;
out vec4 shown;
void main() {
  shown = texelFetch(sheet, ivec2(gl_FragCoord.xy), seen);
  if (shown.r == 0.0) discard;
}
)";

constexpr const char* kLay = R"(
flat in vec4 given;
uniform SHEET sheet;
uniform int seen;
out vec4 shown;
void main() { shown = texelFetch(sheet, ivec2(gl_FragCoord.xy), seen) * given.x; }
)";

constexpr std::array<const char*, 5> kFragments = {kPaint, kGradient, kSum, kFind, kLay};

}  // namespace

void Programs::use(Task task, bool multisampled) {
  multisampled = multisampled && (task == Task::find || task == Task::lay);
  Program& program = programs_[2 * static_cast<std::size_t>(task) + (multisampled ? 1 : 0)];
  if (program.name == 0 && !make(task, multisampled, program))
    throw std::runtime_error(task == Task::gradient
                                 ? "this GL has no doubles in its shaders, which gradients need"
                                 : "the shaders do not compile");
  sample_ = program.sample;
  gl_.use_program(program.name);
  gl_.set_floats(program.shift, place_.shift[0], place_.shift[1]);
  gl_.set_integers(program.corner, place_.corner[0], place_.corner[1]);
}

bool Programs::make(Task task, bool multisampled, Program& program) {
  const GLuint name = gl_.create_program();
  for (const auto& [kind, source] :
       {std::pair(GL_VERTEX_SHADER, kVertex),
        std::pair(GL_FRAGMENT_SHADER, kFragments[static_cast<std::size_t>(task)])}) {
    const GLuint shader = gl_.create_shader(static_cast<GLenum>(kind));
    const char* const parts[] = {kVersion, multisampled ? kSamples : kPixels, source};
    gl_.shader_source(shader, 3, parts, nullptr);
    gl_.compile_shader(shader);
    gl_.attach_shader(name, shader);
    gl_.delete_shader(shader);
  }
  gl_.link_program(name);
  GLint linked = GL_FALSE;
  gl_.program_value(name, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) return gl_.delete_program(name), false;
  const auto place = [&](const char* uniform) { return gl_.uniform_place(name, uniform); };
  gl_.use_program(name);  // what it lacks has place -1, which is passed over
  gl_.set_integer(place("gradients"), static_cast<GLint>(Unit::gradients));
  gl_.set_integer(place("stops"), static_cast<GLint>(Unit::stops));
  gl_.set_integer(place("sheet"), static_cast<GLint>(Unit::sheet));
  program = {name, place("shift"), place("corner"), place("seen")};
  return true;
}

void Programs::stop() {
  for (const Program& program : programs_) gl_.delete_program(program.name);  // 0 is passed over
}

}  // namespace flatray::gl
