#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <cstdlib>

#include "filler.h"

namespace bench {
namespace {

struct Vertex {
  float x, y;
  std::array<std::uint8_t, 4> colour;
};

class OsMesa : public Filler {
 public:
  explicit OsMesa(bool multisampled)
      : multisampled_(multisampled), pixels_(4ULL * kWidth * kHeight) {
    setenv("LP_NUM_THREADS", "0", 1);  // all in the thread that is measured
    context_ = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
    bind();
    if (!multisampled_) return;
    glGenFramebuffers(1, &frame_);
    glGenRenderbuffers(1, &samples_);
    glBindRenderbuffer(GL_RENDERBUFFER, samples_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, kWidth, kHeight);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_);
  }
  ~OsMesa() override { OSMesaDestroyContext(context_); }
  OsMesa(const OsMesa&) = delete;
  OsMesa& operator=(const OsMesa&) = delete;

  std::string name() const override { return multisampled_ ? "OSMesa, 4x MSAA" : "OSMesa, no AA"; }

  void fill(const std::vector<Polygon>& polygons) override {
    bind();
    if (collected_ != polygons.size()) collect(polygons);
    if (multisampled_) glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glViewport(0, 0, kWidth, kHeight);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, kWidth, kHeight, 0, -1, 1);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, sizeof(Vertex), &vertices_[0].x);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), &vertices_[0].colour);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
    if (multisampled_) {
      glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
      glBlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
    }
    glFinish();
  }

  std::array<double, 3> pixel(int x, int y) const override {
    const unsigned char* at = &pixels_[4ULL * (static_cast<unsigned>(y) * kWidth) + 4U * x];
    return {1.0 * at[0], 1.0 * at[1], 1.0 * at[2]};
  }

 private:
  void bind() {
    OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, kWidth, kHeight);
    OSMesaPixelStore(OSMESA_Y_UP, 0);
  }

  void collect(const std::vector<Polygon>& polygons) {
    vertices_.clear();
    collected_ = polygons.size();
    for (const Polygon& polygon : polygons) {
      const auto& [r, g, b] = polygon.colour;
      const auto put = [&](const flatray::Vec2& v) {
        vertices_.push_back({static_cast<float>(v.x()), static_cast<float>(v.y()), {r, g, b, 255}});
      };
      const auto& corners = polygon.corners;
      for (std::size_t i = 2; i < corners.size(); ++i)
        put(corners[0]), put(corners[i - 1]), put(corners[i]);
    }
  }

  const bool multisampled_;
  std::vector<unsigned char> pixels_;
  std::vector<Vertex> vertices_;
  std::size_t collected_ = 0;
  OSMesaContext context_;
  GLuint frame_ = 0, samples_ = 0;
};

}  // namespace

void add_osmesa(Fillers& all) {
  all.push_back(std::make_unique<OsMesa>(false));
  all.push_back(std::make_unique<OsMesa>(true));
}

}  // namespace bench
