// The light that every shading model has to do with.

uniform vec3 light_direction;  // unit, towards the light, patient space
