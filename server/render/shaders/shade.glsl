// The colour of a surface point by its branch's shading model; shading_models.glsl is made from the registry.

uniform vec3 light_direction;  // unit, towards the light, patient space

#include "shading_models.glsl"
