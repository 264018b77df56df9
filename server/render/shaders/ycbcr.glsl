// JPEG's colour space: full-range YCbCr with the weights of Rec. 601 (ITU-T T.871).
const vec3 TO_Y = vec3(0.299, 0.587, 0.114);
const vec3 TO_CB = vec3(-0.168735892, -0.331264108, 0.5);
const vec3 TO_CR = vec3(0.5, -0.418687589, -0.081312411);

uniform sampler2D picture;
