#include "render/filters/filter_registry.h"

namespace cutaway {

extern const ImageFilter kKuwaharaFilter;
extern const ImageFilter kSobelFilter;

std::span<const ImageFilter> image_filters() {
  static const ImageFilter filters[] = {kKuwaharaFilter, kSobelFilter};
  return filters;
}

}  // namespace cutaway
