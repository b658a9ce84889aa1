#include "render/gl/loaded_module.h"

#include <new>

#include "base/module_file.h"

namespace flatray::gl {
namespace {

tl::unexpected<Diagnostics> unavailable(std::string message, std::string hint) {
  return fail(named_place("OpenGL"), std::move(message), std::move(hint), Trouble::unavailable);
}

// What the module says has failed. Memory that ends says nothing of what there is to draw with.
tl::unexpected<Diagnostics> unavailable(const FlatrayGlError& error, std::string hint) {
  if (error.out_of_memory != 0) throw std::bad_alloc();
  return unavailable(std::string(error.text), std::move(hint));
}

Result<const FlatrayGlModule*> find_module() {
  const auto found =
      load_table(kGlModule, FLATRAY_GL_ENTRY, &FlatrayGlModule::abi, std::uint32_t{FLATRAY_GL_ABI});
  if (found.table != nullptr) return found.table;
  return unavailable(found.problem,
                     "tools/setup --gl installs what it is built from; then build again, or say "
                     "--backend software");
}

}  // namespace

Result<std::unique_ptr<LoadedModule>> LoadedModule::open(const std::string& maker,
                                                         unsigned threads) {
  FLATRAY_TRY(module, find_module());
  std::vector<std::string> makers = {maker};
  if (maker == "gl") makers = {"osmesa", "egl"};
  Diagnostics problems;
  for (const std::string& one : makers) {
    std::unique_ptr<LoadedModule> loaded(new LoadedModule(**module));
    const Result<void> started = loaded->start(one, threads);
    if (started) return loaded;
    problems.insert(problems.end(), started.error().begin(), started.error().end());
  }
  return tl::unexpected(std::move(problems));
}

Result<void> LoadedModule::start(const std::string& maker, unsigned threads) {
  FlatrayGlError error{};
  device_ = module_.open(maker.c_str(), threads, &error);
  FlatrayGlContext* first = device_ == nullptr ? nullptr : module_.create(device_, &info_, &error);
  if (first == nullptr) return unavailable(error, "or say --backend software");
  free_.push_back(first);
  return {};
}

LoadedModule::~LoadedModule() {
  for (FlatrayGlContext* context : free_) module_.destroy(context);
  if (device_ != nullptr) module_.close(device_);
}

Result<FlatrayGlContext*> LoadedModule::take() {
  const std::lock_guard lock(mutex_);
  if (free_.empty()) {
    FlatrayGlInfo info;
    FlatrayGlError error{};
    if (FlatrayGlContext* made = module_.create(device_, &info, &error)) return made;
    return unavailable(error, "say --backend software");
  }
  FlatrayGlContext* context = free_.back();
  free_.pop_back();
  return context;
}

Result<void> LoadedModule::draw(const FlatrayGlTile& tile) {
  FLATRAY_TRY(context, take());
  FlatrayGlError error{};
  const bool drawn = module_.draw(*context, &tile, &error) != 0;
  {
    const std::lock_guard lock(mutex_);
    free_.push_back(*context);
  }
  if (!drawn) return unavailable(error, "say --backend software");
  return {};
}

}  // namespace flatray::gl
