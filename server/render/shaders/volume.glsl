// The volume. Values are as stored (0..1 for 16-bit textures): iso-values come converted, so that no sample pays for the
// rescale. Positions are texture coordinates, 0..1 over all voxels, so that no sample pays for a conversion either.

uniform sampler3D volume_texture;
uniform vec3 voxel_size;        // of one voxel, in texture coordinates
uniform vec3 volume_size_mm;    // of all voxels
uniform mat3 volume_direction;  // columns: the i, j, k axes in patient space

float stored_value(vec3 position) { return textureLod(volume_texture, position, 0.0).r; }
