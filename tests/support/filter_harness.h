// A filter's pass on pictures that a test makes up.
#pragma once

#include <functional>

#include "scene/scene.h"
#include "support/reference_image.h"

namespace cutaway::test {

reference::BranchImage filtered_on_gpu(const reference::BranchImage& input, const Module& filter);

/// A filter by its name, with its defaults where `parameters` says nothing.
Module filter_module(const char* name, const Json& parameters = Json::object());
Module kuwahara(int radius);
Module sobel(double strength, const char* mode, const char* norm = "raw",
             const char* gradient = "l1", const char* source = "colour", bool silhouettes = true);

/// Numbers that a half float holds exactly, so that both sides start from the same picture.
double representable(double value);

/// All covered; `level` of each pixel, 0..1.
reference::BranchImage grey(glm::ivec2 size, const std::function<double(int, int)>& level);

/// A quarter turn.
reference::BranchImage turned(const reference::BranchImage& image);

/// Random colours, with background and pixels that the lens has taken; nothing else in common.
reference::BranchImage random_picture(unsigned seed, glm::ivec2 size = {48, 40});

}  // namespace cutaway::test
