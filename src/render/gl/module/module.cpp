// The entry of flatray_gl.so. Exceptions end here: what calls is another world.
#include "render/gl/module.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "render/gl/module/maker.h"
#include "render/gl/module/painter.h"

using flatray::gl::Functions;
using flatray::gl::Maker;
using flatray::gl::Painter;

struct FlatrayGlDevice {
  std::unique_ptr<Maker> maker;
  Functions functions{};
  bool functions_loaded = false;
};

struct FlatrayGlContext {
  std::unique_ptr<Maker::Context> context;
  Painter painter;
};

namespace {

// What `task` gives, or {} where it throws.
template <class Task>
auto guarded(FlatrayGlError* error, const Task& task) -> decltype(task()) {
  try {
    return task();
  } catch (const std::bad_alloc&) {
    error->out_of_memory = 1;
    return {};
  } catch (const std::exception& problem) {
    std::snprintf(error->text, sizeof error->text, "%s", problem.what());
    return {};
  }
}

// Mesa reads these when its first context is made. What the user set stays.
void choose_software(unsigned threads) {
  setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 0);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
}

FlatrayGlDevice* open_device(const char* name, unsigned threads, FlatrayGlError* error) {
  return guarded(error, [&] {
    choose_software(threads);
    return new FlatrayGlDevice{std::strcmp(name, "egl") == 0 ? flatray::gl::open_egl()
                                                             : flatray::gl::open_osmesa()};
  });
}

void close_device(FlatrayGlDevice* device) { delete device; }

// Makes a context current, as long as this lives.
class Current {
 public:
  explicit Current(Maker::Context& context) : context_(context) {
    if (!context.enter()) throw std::runtime_error("the context cannot be used");
  }
  ~Current() { context_.leave(); }

 private:
  Maker::Context& context_;
};

FlatrayGlContext* create_context(FlatrayGlDevice* device, FlatrayGlInfo* info,
                                 FlatrayGlError* error) {
  return guarded(error, [&] {
    std::unique_ptr<Maker::Context> context = device->maker->create();
    const Current current(*context);
    if (!device->functions_loaded) device->functions.load(*device->maker);
    device->functions_loaded = true;
    Painter painter(device->functions);
    try {
      painter.start(*info, device->maker->name());
    } catch (...) {
      painter.stop();
      throw;
    }
    return new FlatrayGlContext{std::move(context), std::move(painter)};
  });
}

void destroy_context(FlatrayGlContext* context) {
  if (context->context->enter()) context->painter.stop();
  context->context->leave();
  delete context;
}

int draw_tile(FlatrayGlContext* context, const FlatrayGlTile* tile, FlatrayGlError* error) {
  return guarded(error, [&] {
    const Current current(*context->context);
    context->painter.draw(*tile);
    return 1;
  });
}

constexpr FlatrayGlModule kModule = {FLATRAY_GL_ABI,  &open_device,     &close_device,
                                     &create_context, &destroy_context, &draw_tile};

}  // namespace

extern "C" __attribute__((visibility("default"))) const FlatrayGlModule* flatray_gl_module(void) {
  return &kModule;
}
