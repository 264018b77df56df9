// One triangle over the whole viewport, behind everything that a depth test can find: its corners, from gl_VertexID.

vec2 viewport_corner() { return vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0); }

vec4 behind_everything(vec2 corner) { return vec4(corner, 1.0, 1.0); }
