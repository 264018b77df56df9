// What the rays of all pixels are made from: the vertex shader hands it on, as in all_rays.glsl. HANDED is `out` there, `in`
// in the fragment shader.

HANDED PixelRays {
  flat vec4 place;   // xy: of what is drawn in the whole picture, in fragments; zw: 2 / the whole picture's fragments
  flat vec2 shifts;  // how far a step across moves a ray's begin, and its direction: 0 or 1
  flat vec3 from_mm;
  flat vec3 toward_mm;
  flat vec3 right_mm;  // to the picture's right edge
  flat vec3 up_mm;     // to its upper edge
  flat vec3 from_in_volume;
  flat vec3 toward_in_volume;
  flat vec3 right_in_volume;
  flat vec3 up_in_volume;
} pixel_rays;
