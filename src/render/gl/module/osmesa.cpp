#include <memory>
#include <stdexcept>

#include "render/gl/module/maker.h"

#ifdef FLATRAY_HAVE_OSMESA
#include <GL/osmesa.h>
#endif

namespace flatray::gl {

#ifdef FLATRAY_HAVE_OSMESA
namespace {

struct Functions {
  const InstalledLibrary library{"libOSMesa.so.8", "libosmesa6"};
  decltype(&OSMesaCreateContextAttribs) create =
      library.find<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
  decltype(&OSMesaDestroyContext) destroy =
      library.find<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext");
  decltype(&OSMesaMakeCurrent) make_current =
      library.find<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
  decltype(&OSMesaGetProcAddress) function =
      library.find<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress");
};

class OsmesaContext final : public Maker::Context {
 public:
  OsmesaContext(const Functions& functions, OSMesaContext context)
      : functions_(functions), context_(context) {}
  ~OsmesaContext() override { functions_.destroy(context_); }

  bool enter() override {
    return functions_.make_current(context_, own_picture_, GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
  }
  void leave() override { functions_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

 private:
  const Functions& functions_;
  OSMesaContext context_;
  unsigned char own_picture_[4] = {};  // OSMesa wants one; we draw into framebuffer objects
};

class OsmesaMaker final : public Maker {
 public:
  const char* name() const override { return "OSMesa"; }
  std::unique_ptr<Context> create() override {
    constexpr int kWanted[] = {OSMESA_FORMAT,
                               OSMESA_RGBA,
                               OSMESA_PROFILE,
                               OSMESA_CORE_PROFILE,
                               OSMESA_CONTEXT_MAJOR_VERSION,
                               3,
                               OSMESA_CONTEXT_MINOR_VERSION,
                               3,
                               0};
    if (OSMesaContext context = functions_.create(kWanted, nullptr))
      return std::make_unique<OsmesaContext>(functions_, context);
    throw std::runtime_error("OSMesa makes no context of OpenGL 3.3");
  }
  void* function(const char* name) const override {
    return reinterpret_cast<void*>(functions_.function(name));
  }

 private:
  const Functions functions_{};
};

}  // namespace

std::unique_ptr<Maker> open_osmesa() { return std::make_unique<OsmesaMaker>(); }
#else
std::unique_ptr<Maker> open_osmesa() {
  throw std::runtime_error("OSMesa is not in this build: install libosmesa6-dev and build again");
}
#endif

}  // namespace flatray::gl
