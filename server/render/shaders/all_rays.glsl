// What is the same for all rays. The vertex shader hands it on: a software rasteriser reads a uniform lane by lane, again
// for each eight pixels, and a flat input once. HANDED is `out` in the vertex shader, `in` in the fragment shader.

HANDED AllRays {
  flat vec3 voxel_size;        // of one voxel, in texture coordinates
  flat vec3 size_mm;           // of the volume
  flat mat3 axes;              // columns: the i, j, k axes in patient space
  flat vec2 context_band;      // lower and upper limit, stored units; NO_UPPER_LIMIT: larger than any value
  flat vec2 focus_band;
  flat float step_mm;
  flat float samples_per_mm;
  flat float brick_mm;         // a brick's shortest edge
  flat vec3 brick_in_map;      // a brick's size, in texture coordinates of the distance maps
  flat vec3 bricks_per_volume;    // from texture coordinates of the volume to bricks
  flat float first_centre_bricks; // the middle of the first voxel, where the first brick begins
} all_rays;
