#include "render/gl/module/painter.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>

namespace flatray::gl {
namespace {

constexpr GLsizei kViewport = FLATRAY_GL_TILE;  // as the vertex shader has it
constexpr std::size_t kTexel = 16;              // bytes of what a table is read in
static_assert(sizeof(FlatrayGlGradient) == 3 * kTexel && sizeof(FlatrayGlStop) == 2 * kTexel);

enum class Ink { none, over, add, replace };

// How the batches of a kind are drawn: what becomes of the light, and of the marks.
struct Manner {
  Task task;
  Ink ink;
  GLenum test = GL_ALWAYS;  // of `reference` against the marks
  GLint reference = 0;
  GLenum front = GL_KEEP, back = GL_KEEP;
};
constexpr Manner kManners[] = {
    {Task::paint, Ink::over},                                            // paint
    {Task::paint, Ink::none, GL_ALWAYS, 0, GL_INCR_WRAP, GL_DECR_WRAP},  // count
    {Task::paint, Ink::none, GL_ALWAYS, 0, GL_INVERT, GL_INVERT},        // flip
    {Task::sum, Ink::add},                                               // sum
    {Task::find, Ink::none, GL_ALWAYS, 1, GL_REPLACE, GL_REPLACE},       // find
    {Task::paint, Ink::over, GL_NOTEQUAL, 0, GL_ZERO, GL_ZERO},          // cover
    {Task::paint, Ink::replace},                                         // layer
    {Task::lay, Ink::over}                                               // lay
};
static_assert(FLATRAY_GL_COVER == 5 && FLATRAY_GL_LAY + 1 == std::size(kManners));

void set_ink(const Functions& gl, Ink ink) {
  const GLboolean mask = ink == Ink::none ? GL_FALSE : GL_TRUE;
  gl.colour_mask(mask, mask, mask, mask);
  if (ink == Ink::replace) return gl.disable(GL_BLEND);
  gl.enable(GL_BLEND);
  gl.blend(GL_ONE, ink == Ink::add ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
}

void set_marks(const Functions& gl, const Manner& manner) {
  if (manner.front == GL_KEEP) return gl.disable(GL_STENCIL_TEST);
  gl.enable(GL_STENCIL_TEST);
  gl.stencil_func(manner.test, manner.reference, 0xff);
  gl.stencil_op_of(GL_FRONT, GL_KEEP, GL_KEEP, manner.front);
  gl.stencil_op_of(GL_BACK, GL_KEEP, GL_KEEP, manner.back);
}

// "4.5 (Core Profile) Mesa 22.3.6" has what counts at its end.
std::string mesa_of(const char* version) {
  const char* mesa = std::strstr(version, "Mesa");
  return mesa == nullptr ? version : mesa;
}

}  // namespace

void Painter::start(FlatrayGlInfo& info, const char* maker) {
  const auto text = [&](GLenum what) {
    const GLubyte* found = gl_.get_string(what);
    return found == nullptr ? "" : reinterpret_cast<const char*>(found);
  };
  std::snprintf(info.version, sizeof info.version, "%s, %s, %s", maker,
                mesa_of(text(GL_VERSION)).c_str(), text(GL_RENDERER));
  GLint samples = 1;
  gl_.get_integers(GL_MAX_SAMPLES, &samples);
  info.most_samples = samples >= 4 ? 4 : 1;
  gl_.gen_vertex_arrays(1, &vertex_array_);
  gl_.bind_vertex_array(vertex_array_);
  gl_.gen_buffers(1, &buffer_);
  gl_.bind_buffer(GL_ARRAY_BUFFER, buffer_);
  gl_.attribute(0, 2, GL_FLOAT, GL_FALSE, sizeof(FlatrayGlVertex), nullptr);
  gl_.attribute(1, 4, GL_FLOAT, GL_FALSE, sizeof(FlatrayGlVertex),
                reinterpret_cast<const void*>(offsetof(FlatrayGlVertex, paint)));
  gl_.enable_attribute(0);
  gl_.enable_attribute(1);
  gl_.clamp_colour(GL_CLAMP_READ_COLOR, GL_FALSE);
  sheets_.resize({1, 1, info.most_samples});
}

// What a shader reads by number.
void Painter::fill_table(Unit unit, const void* data, std::size_t bytes) {
  if (bytes == 0) return;
  GLint most = 0;
  gl_.get_integers(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (bytes / kTexel > static_cast<std::size_t>(most))
    throw std::runtime_error("this GL has no room for so many gradients");
  Table& table = tables_[static_cast<std::size_t>(unit)];
  if (table.buffer == 0) {
    gl_.gen_buffers(1, &table.buffer);
    gl_.gen_textures(1, &table.texture);
  }
  gl_.bind_buffer(GL_TEXTURE_BUFFER, table.buffer);
  gl_.buffer_data(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
  gl_.active_texture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.bind_texture(GL_TEXTURE_BUFFER, table.texture);
  gl_.texture_buffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, table.buffer);
}

void Painter::draw(const FlatrayGlTile& tile) {
  sheets_.resize({tile.width, tile.height, tile.samples});
  fill_table(Unit::gradients, tile.gradients, tile.gradient_count * sizeof *tile.gradients);
  fill_table(Unit::stops, tile.stops, tile.stop_count * sizeof *tile.stops);
  gl_.buffer_data(GL_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(tile.vertex_count * sizeof(FlatrayGlVertex)),
                  tile.vertices, GL_STREAM_DRAW);
  gl_.viewport(0, 0, kViewport, kViewport);
  const std::size_t floats =
      4 * static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
  if (tile.shift_count > 1) again_.resize(floats);
  for (std::size_t i = 0; i < tile.shift_count; ++i) {
    programs_.set({{tile.shifts[i][0], tile.shifts[i][1]}, {tile.x, tile.y}});
    draw_batches(tile);
    sheets_.read(i == 0 ? tile.rgba : again_.data());
    if (i > 0) std::transform(again_.begin(), again_.end(), tile.rgba, tile.rgba, std::plus<>());
  }
  if (tile.shift_count > 1) {
    const auto count = static_cast<float>(tile.shift_count);
    std::for_each(tile.rgba, tile.rgba + floats, [count](float& value) { value /= count; });
  }
  if (const GLenum code = gl_.get_error(); code != GL_NO_ERROR)
    throw std::runtime_error(code == GL_OUT_OF_MEMORY ? "GL has no memory left"
                                                      : "GL reports error " + std::to_string(code));
}

void Painter::draw_batches(const FlatrayGlTile& tile) {
  target_ = Sheets::picture;
  sheets_.draw_on(target_);
  set_ink(gl_, Ink::over);
  gl_.clear_colour(tile.background[0], tile.background[1], tile.background[2], tile.background[3]);
  gl_.clear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  for (std::size_t i = 0; i < tile.batch_count; ++i) draw_batch(tile.batches[i]);
}

void Painter::draw_batch(const FlatrayGlBatch& batch) {
  const Manner& manner = kManners[batch.kind];
  choose_sheet(batch.kind);
  const bool gradients =
      batch.gradients != 0 && manner.task == Task::paint && manner.ink == Ink::over;
  programs_.use(gradients ? Task::gradient : manner.task, sheets_.multisampled());
  set_ink(gl_, manner.ink);
  set_marks(gl_, manner);
  if (manner.task != Task::find && manner.task != Task::lay) return draw_triangles(batch);
  sheets_.show(manner.task == Task::find ? Sheets::sums : Sheets::layer);
  draw_samples(batch);
}

void Painter::choose_sheet(int32_t kind) {
  if (kind == FLATRAY_GL_LAYER) target_ = Sheets::layer;
  if (kind == FLATRAY_GL_LAY) target_ = Sheets::picture;
  if (kind == FLATRAY_GL_LAYER || kind == FLATRAY_GL_LAY || kind == FLATRAY_GL_FIND)
    return sheets_.draw_on(target_);
  if (kind != FLATRAY_GL_SUM) return;
  sheets_.draw_on(Sheets::sums);
  set_ink(gl_, Ink::add);
  gl_.clear_colour(0, 0, 0, 0);
  gl_.clear(GL_COLOR_BUFFER_BIT);
}

void Painter::draw_triangles(const FlatrayGlBatch& batch) {
  gl_.draw_arrays(GL_TRIANGLES, static_cast<GLint>(batch.first), static_cast<GLsizei>(batch.count));
}

// Each sample shows the sample of the sheet that it lies on.
void Painter::draw_samples(const FlatrayGlBatch& batch) {
  gl_.enable(GL_SAMPLE_MASK);
  for (int sample = 0; sample < sheets_.samples(); ++sample) {
    programs_.read_sample(sample);
    gl_.sample_mask(0, GLbitfield{1} << sample);
    draw_triangles(batch);
  }
  gl_.disable(GL_SAMPLE_MASK);
}

void Painter::stop() {
  sheets_.stop();
  gl_.delete_buffers(1, &buffer_);
  gl_.delete_vertex_arrays(1, &vertex_array_);
  for (const Table& table : tables_) {
    gl_.delete_textures(1, &table.texture);
    gl_.delete_buffers(1, &table.buffer);
  }
  programs_.stop();
}

}  // namespace flatray::gl
