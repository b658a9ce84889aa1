// The entry of flatray_gl.so. Exceptions end here: what calls is another world.
#include "render/gl/module.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "render/gl/module/maker.h"
#include "render/gl/module/painter.h"

using flatray::gl::Functions;
using flatray::gl::Maker;
using flatray::gl::Painter;

struct FlatrayGlDevice {
  std::unique_ptr<Maker> maker;
  Functions functions;
  bool functions_loaded = false;
};

struct FlatrayGlContext {
  std::unique_ptr<Maker::Context> context;
  Painter painter;
};

namespace {

void say(FlatrayGlError* error, const std::string& text) {
  std::snprintf(error->text, sizeof error->text, "%s", text.c_str());
}

// What `task` gives, or {} where it throws.
template <class Task>
auto guarded(FlatrayGlError* error, const Task& task) -> decltype(task()) {
  try {
    return task();
  } catch (const std::bad_alloc&) {
    error->out_of_memory = 1;
    return {};
  } catch (const std::exception& problem) {
    say(error, problem.what());
    return {};
  }
}

// Mesa reads these when its first context is made. What the user set stays.
void choose_software(unsigned threads) {
  setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 0);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
}

FlatrayGlDevice* open_device(const char* name, unsigned threads, FlatrayGlError* error) {
  return guarded(error, [&]() -> FlatrayGlDevice* {
    choose_software(threads);
    std::string problem;
    std::unique_ptr<Maker> maker = std::strcmp(name, "egl") == 0
                                       ? flatray::gl::open_egl(problem)
                                       : flatray::gl::open_osmesa(problem);
    if (maker) return new FlatrayGlDevice{std::move(maker), {}, false};
    say(error, problem);
    return nullptr;
  });
}

void close_device(FlatrayGlDevice* device) { delete device; }

// Destroys what a context holds, with the context current; leaves none current.
struct Leave {
  Maker::Context& context;
  ~Leave() { context.leave(); }
};

FlatrayGlContext* create_context(FlatrayGlDevice* device, FlatrayGlInfo* info,
                                 FlatrayGlError* error) {
  return guarded(error, [&]() -> FlatrayGlContext* {
    std::string problem;
    std::unique_ptr<Maker::Context> context = device->maker->create(problem);
    if (context && !context->enter()) problem = "the context cannot be used", context.reset();
    if (!context) return say(error, problem), nullptr;
    const Leave leave{*context};
    if (!device->functions_loaded)
      if (const char* lacking = device->functions.load(*device->maker))
        return say(error, std::string("this GL has no ") + lacking), nullptr;
    device->functions_loaded = true;
    Painter painter(device->functions);
    if (!painter.start(*info, device->maker->name(), problem))
      return painter.stop(), say(error, problem), nullptr;
    return new FlatrayGlContext{std::move(context), std::move(painter)};
  });
}

void destroy_context(FlatrayGlContext* context) {
  if (context->context->enter()) context->painter.stop();
  context->context->leave();
  delete context;
}

int draw_tile(FlatrayGlContext* context, const FlatrayGlTile* tile, FlatrayGlError* error) {
  return guarded(error, [&]() -> int {
    if (!context->context->enter()) return say(error, "the context cannot be used"), 0;
    const Leave leave{*context->context};
    std::string problem;
    if (context->painter.draw(*tile, problem)) return 1;
    say(error, problem);
    return 0;
  });
}

constexpr FlatrayGlModule kModule = {FLATRAY_GL_ABI,  &open_device,     &close_device,
                                     &create_context, &destroy_context, &draw_tile};

}  // namespace

extern "C" __attribute__((visibility("default"))) const FlatrayGlModule* flatray_gl_module(void) {
  return &kModule;
}
