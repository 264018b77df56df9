#include "render/filters/filter_registry.h"

namespace cutaway {

extern const ImageFilter kKuwaharaFilter;
extern const ImageFilter kAnisotropicKuwaharaFilter;
extern const ImageFilter kSobelFilter;
extern const ImageFilter kDepthLinesFilter;
extern const ImageFilter kDogFilter;
extern const ImageFilter kXdogFilter;
extern const ImageFilter kFdogFilter;
extern const ImageFilter kCannyFilter;
extern const ImageFilter kLuminanceQuantisationFilter;
extern const ImageFilter kHatchingFilter;

std::span<const ImageFilter> image_filters() {
  static const ImageFilter filters[] = {kKuwaharaFilter,
                                        kAnisotropicKuwaharaFilter,
                                        kSobelFilter,
                                        kDepthLinesFilter,
                                        kDogFilter,
                                        kXdogFilter,
                                        kFdogFilter,
                                        kCannyFilter,
                                        kLuminanceQuantisationFilter,
                                        kHatchingFilter};
  return filters;
}

}  // namespace cutaway
