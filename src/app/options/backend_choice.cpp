#include "app/options/backend_choice.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/interrupt.h"
#include "base/left_out.h"

namespace flatray {
namespace {

constexpr const char* kSoftware = "software";

const Backend* find_backend(const std::string& name) {
  for (const Backend* one : backends())
    if (name == one->name) return one;
  return nullptr;
}

Result<unsigned> samples(const Arguments& arguments, const std::string& backend) {
  const auto word = arguments.one_of("samples", {"4", "16", "64"});
  if (!word) return tl::unexpected(word.error());
  if (arguments.has("samples") && backend == kSoftware)
    return usage_error(arguments.where("samples"), "the software back end takes no samples",
                       "its coverage is exact; say --backend gl, or leave out --samples");
  return static_cast<unsigned>(std::stoul(*word));
}

}  // namespace

std::vector<std::string> backend_names() {
  std::vector<std::string> names = {kSoftware, "auto"};
  for (const Backend* one : backends())
    if (one->name != names.front()) names.emplace_back(one->name);
  return names;
}

Result<std::shared_ptr<const Renderer>> chosen_renderer(const Arguments& arguments,
                                                        unsigned threads) {
  const std::string asked = arguments.text("backend").value_or("");
  if (const auto problem = if_left_out(arguments.where("backend"), "backend", asked))
    return tl::unexpected(Diagnostics{*problem});
  const Result<std::string> name = arguments.one_of("backend", backend_names());
  if (!name) return tl::unexpected(name.error());
  const Result<unsigned> count = samples(arguments, *name);
  if (!count) return tl::unexpected(count.error());
  const Backend* backend = find_backend(*name == "auto" ? "gl" : *name);
  if (*name == kSoftware || backend == nullptr) return nullptr;
  expect_crashes_of_gl();
  Result<std::unique_ptr<Renderer>> opened = backend->open({threads, *count});
  if (opened) return std::shared_ptr<const Renderer>(std::move(*opened));
  if (*name == "auto") return nullptr;
  return fail(std::move(opened));
}

Result<std::unique_ptr<Renderer>> open_backend(const std::string& name,
                                               const BackendChoice& choice) {
  expect_crashes_of_gl();
  if (const Backend* backend = find_backend(name)) return backend->open(choice);
  return fail(named_place(name), "is not a back end of this build", "", Trouble::unavailable);
}

std::string backends_text() {
  std::string text = kSoftware;
  if (const Backend* gl = find_backend("gl")) {
    expect_crashes_of_gl();
    const auto opened = gl->open({1, 4});
    text += opened ? ", " + (*opened)->description() : std::string("; no gl");
  }
  return text;
}

}  // namespace flatray
