#include "app/options/backend_choice.h"

#include "app/interrupt.h"
#include "base/entry_named.h"
#include "base/left_out.h"

namespace flatray {
namespace {

constexpr const char* kSoftware = "software";

Result<std::string> read_backend(const std::string& text, const Place& where) {
  if (const auto problem = if_left_out(where, "backend", text))
    return tl::unexpected(Diagnostics{*problem});
  const std::vector<std::string> known = backend_names();
  return word_of(text, where, known).map([&](std::size_t i) { return known[i]; });
}

}  // namespace

std::vector<std::string> backend_names() {
  std::vector<std::string> names = {kSoftware, "auto"};
  for (const Backend* one : backends())
    if (one->name != names.front()) names.emplace_back(one->name);
  return names;
}

void BackendOptions::rows(OptionTable& row) {
  constexpr Word<unsigned> kSamples[] = {{"4", 4}, {"16", 16}, {"64", 64}};
  row("--backend NAME", "what draws: software, gl, osmesa, egl, auto", name, &read_backend,
      &backend_names);
  row("--samples", "samples of a pixel, for the GL back ends", samples, kSamples);
  if (row.has("samples") && name == kSoftware)
    row.problem("samples", "the software back end takes no samples",
                "its coverage is exact; say --backend gl, or leave out --samples");
}

Result<std::shared_ptr<const Renderer>> chosen_renderer(const BackendOptions& options,
                                                        unsigned threads) {
  const Backend* backend = entry_named(backends(), options.name == "auto" ? "gl" : options.name);
  if (options.name == kSoftware || backend == nullptr) return nullptr;
  expect_crashes_of_gl();
  Result<std::unique_ptr<Renderer>> opened = backend->open({threads, options.samples});
  if (opened) return std::shared_ptr<const Renderer>(std::move(*opened));
  if (options.name == "auto") return nullptr;
  return fail(std::move(opened));
}

Result<std::unique_ptr<Renderer>> open_backend(const std::string& name,
                                               const BackendChoice& choice) {
  expect_crashes_of_gl();
  if (const Backend* backend = entry_named(backends(), name)) return backend->open(choice);
  return fail(named_place(name), "is not a back end of this build", "", Trouble::unavailable);
}

std::string backends_text() {
  std::string text = kSoftware;
  if (const Backend* gl = entry_named(backends(), "gl")) {
    expect_crashes_of_gl();
    const auto opened = gl->open({1, 4});
    text += opened ? ", " + (*opened)->description() : std::string("; no gl");
  }
  return text;
}

}  // namespace flatray
