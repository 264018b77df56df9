// The two ways in which a point can be drawn, and what a pixel of a branch's surface buffer holds.
//
// Surface buffer, RGBA32F: xyz = normal in patient space, facing the viewer, whose length is 1, a unit longer where the
// cutaway's lens lies between the eye and the context, and two where it is the face of a cut through material, by the lens
// or by the volume's end; w = distance from the eye in mm where the branch holds the pixel, else one of the negative reasons
// below.

const int CONTEXT = 0;
const int FOCUS = 1;

const float REASON_LEFT_VOLUME = -1.0;   // neither branch holds the pixel
const float REASON_OTHER_BRANCH = -2.0;  // the lens has given the pixel to the other branch or taken this one away
const float REASON_LEFT_LENS = -3.0;     // focus: the lens was crossed and nothing was hit

const float BEHIND_LENS_LENGTH = 1.0;
const float CUT_FACE_LENGTH = 2.0;

bool holds(vec4 surface) { return surface.w >= 0.0; }
float length_of_place(vec4 surface) { return max(round(length(surface.xyz)), 1.0); }
bool is_cut_face(vec4 surface) { return dot(surface.xyz, surface.xyz) > 6.25; }
bool lies_behind_lens(vec4 surface) { return mod(length_of_place(surface), 2.0) == 0.0; }
vec3 normal_of(vec4 surface) { return surface.xyz / length_of_place(surface); }
