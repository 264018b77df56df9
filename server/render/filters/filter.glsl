// What every filter reads and writes: one branch's colours (display-encoded, not premultiplied; coverage in alpha).

uniform sampler2D colour_texture;
uniform sampler2D silhouette_texture;  // coverage as if no lens had taken anything away
uniform sampler2D surface_texture;     // see branches.glsl; one or more texels a pixel
uniform int supersampling;             // rays a pixel, each way
uniform bool is_cut;                   // the branch may be seen through the cutaway's lens

const vec3 LUMA_WEIGHTS = vec3(0.2126, 0.7152, 0.0722);  // Rec. 709, on display-encoded values

float brightness(vec3 colour) { return dot(colour, LUMA_WEIGHTS); }

bool is_in_picture(ivec2 pixel) {
  return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(colour_texture, 0)));
}
