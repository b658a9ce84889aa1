#include "study/accuracy/linear_error.h"

namespace flatray {

Result<std::shared_ptr<DrawnFrame>> frame_to_draw(const AccuracyContext& context) {
  constexpr std::uint64_t kMostRays = 1 << 12;  // light is the same however the rest is drawn
  FLATRAY_TRY(list, middle_list(context, kMostRays));
  list->coverage = Coverage::area;
  return std::make_shared<DrawnFrame>(DrawnFrame{std::move(*list), context.threads});
}

}  // namespace flatray
