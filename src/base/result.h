#pragma once
#include <tl/expected.hpp>

#include "base/diagnostic.h"

namespace flatray {

/// A value, or everything that is wrong.
template <class T>
using Result = tl::expected<T, Diagnostics>;

/// A failed Result from one diagnostic.
inline tl::unexpected<Diagnostics> fail(Place where, std::string message, std::string hint = {},
                                        Trouble trouble = Trouble::invalid) {
  return tl::unexpected<Diagnostics>(
      Diagnostics{{std::move(where), std::move(message), std::move(hint), trouble}});
}

/// Passes the failure of one Result on as the failure of another type.
template <class T>
tl::unexpected<Diagnostics> fail(Result<T>&& failed) {
  return tl::unexpected<Diagnostics>(std::move(failed).error());
}

/// Declares a Result by that name, and passes its failure on: what follows it has a value.
#define FLATRAY_TRY(name, ...) \
  auto name = __VA_ARGS__;     \
  if (!(name)) return fail(std::move(name))

}  // namespace flatray
