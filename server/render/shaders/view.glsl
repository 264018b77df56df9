// The camera, in patient space (mm) and in the volume's texture coordinates.

uniform vec3 eye_mm;             // perspective: where rays start; orthographic: the middle of the plane they start on
uniform vec3 view_forward;       // unit
uniform vec3 view_right;         // to the right edge: perspective per unit of forward, orthographic in mm
uniform vec3 view_up;            // to the upper edge, likewise
uniform bool is_perspective;
uniform mat3 patient_to_volume;  // linear part, texture coordinates per mm
uniform vec3 eye_in_volume;
uniform vec2 first_fragment;     // of what is drawn, in the whole picture
uniform vec2 whole_fragments;    // of the whole picture, each way
uniform vec2 tile_centre;        // of the part that is drawn, in the whole picture of -1..1, y down
uniform vec2 tile_scale;         // its share of the whole picture
