// One of the volume's coarser copies, or the volume itself; positions are texture coordinates of the volume.

uniform sampler3D coarse_texture;
uniform vec3 coarse_from_volume;  // its last texels may reach beyond the volume

float coarse_value(vec3 position) { return textureLod(coarse_texture, position * coarse_from_volume, 0.0).r; }
