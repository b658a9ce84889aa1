#include "render/gl/module/sheets.h"

#include <stdexcept>
#include <string>

namespace flatray::gl {

void Sheets::resize(const Size& size) {
  if (size == size_) return;
  stop();
  size_ = size;
  gl_.gen_renderbuffers(1, &marks_);
  gl_.bind_renderbuffer(GL_RENDERBUFFER, marks_);
  gl_.storage(GL_RENDERBUFFER, multisampled() ? size.samples : 0, GL_DEPTH24_STENCIL8, size.width,
              size.height);
  if (multisampled()) make(resolved, 1);
  draw_on(picture);
}

void Sheets::draw_on(Name name) {
  const Sheet& sheet = sheets_[name];
  if (sheet.framebuffer == 0) return make(name, size_.samples);
  gl_.bind_framebuffer(GL_FRAMEBUFFER, sheet.framebuffer);
}

void Sheets::make_texture(GLint format, int32_t samples) {
  const GLenum target = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  if (samples > 1) {
    gl_.image_of_samples(target, samples, static_cast<GLenum>(format), size_.width, size_.height,
                         GL_TRUE);
    return;
  }
  gl_.image(target, 0, format, size_.width, size_.height, 0, GL_RGBA, GL_FLOAT, nullptr);
  gl_.parameter(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // one level is all there is
}

void Sheets::make(Name name, int32_t samples) {
  const GLenum target = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  Sheet& sheet = sheets_[name];
  gl_.gen_textures(1, &sheet.texture);
  show(name);
  make_texture(name == sums ? GL_R32F : GL_RGBA32F, samples);
  gl_.gen_framebuffers(1, &sheet.framebuffer);
  gl_.bind_framebuffer(GL_FRAMEBUFFER, sheet.framebuffer);
  gl_.attach_texture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, sheet.texture, 0);
  if (name != resolved && name != sums)
    gl_.attach(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, marks_);
  if (gl_.framebuffer_status(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE &&
      gl_.get_error() == GL_NO_ERROR)
    return;
  stop();
  throw std::runtime_error("this GL has no framebuffer of floats with " + std::to_string(samples) +
                           " samples and a stencil, or no memory left");
}

void Sheets::show(Name name) {
  gl_.active_texture(GL_TEXTURE0 + static_cast<GLenum>(Unit::sheet));
  const bool samples = multisampled() && name != resolved;
  gl_.bind_texture(samples ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, sheets_[name].texture);
}

void Sheets::read(float* rgba) {
  if (multisampled()) {
    gl_.bind_framebuffer(GL_READ_FRAMEBUFFER, sheets_[picture].framebuffer);
    gl_.bind_framebuffer(GL_DRAW_FRAMEBUFFER, sheets_[resolved].framebuffer);
    gl_.blit(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT,
             GL_NEAREST);
    gl_.bind_framebuffer(GL_READ_FRAMEBUFFER, sheets_[resolved].framebuffer);
  }
  // Row 0 of the framebuffer is the film's top row: y was never turned over.
  gl_.read_pixels(0, 0, size_.width, size_.height, GL_RGBA, GL_FLOAT, rgba);
}

void Sheets::stop() {
  for (Sheet& sheet : sheets_) {
    gl_.delete_framebuffers(1, &sheet.framebuffer);  // of name 0: passed over
    gl_.delete_textures(1, &sheet.texture);
    sheet = {};
  }
  gl_.delete_renderbuffers(1, &marks_);
  marks_ = 0;
  size_ = {};
}

}  // namespace flatray::gl
