// The colour of a surface point by its branch's shading model; shading_models.glsl is made from the registry.
#include "light.glsl"
#include "shading_models.glsl"
