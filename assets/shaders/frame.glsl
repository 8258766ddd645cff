// The uniforms of a frame. Frame coordinates: the axes of the world with +Y upwards, the eye at the origin, lengths
// in a unit of about the size of the world, so that floats suffice for worlds of any size and place. In an
// orthographic view, and on the way to one, the eye at the origin is that of the perspective view, so that
// shading that depends on the direction of sight is the same in both.
layout(std140) uniform Frame {
  mat4 clip_from_frame;
  vec4 camera_right;    // xyz unit; w: tangent of half the field of view, sideways
  vec4 camera_up;       // xyz unit; w: the same, upwards
  vec4 camera_forward;  // xyz unit; w: distance behind the origin at which the rays of the frame begin
  vec4 viewport;        // width and height in pixels, their inverses
  vec4 key_light;       // xyz unit, towards the light
  vec4 ground;          // height, x and z of the middle, radius of the disc
  vec4 grid;            // phase x and z and spacing of the fine lines, height of the world over the ground
  vec4 spot;            // xyz: point hit by the beam; w: reach of its light
  vec4 spot_colour;     // rgb, 0 when the beam is off
  vec4 beam;            // xyz: where the beam is emitted
  vec4 sky_high;        // rgb of the sky overhead
  vec4 sky_low;         // rgb of the sky near the horizon
  vec4 sky_band;        // rgb added by a band of light along the horizon
  vec4 sky_light;       // rgb of the light that falls on surfaces from above
  vec4 ground_light;    // rgb of the light that falls on surfaces from below; w: 1 if no ground blocks light
  vec4 ground_matt;     // rgb, the share of light that the ground reflects
  vec4 ground_line;     // rgb added by the lines of its grid; negative by day
  vec4 section;         // a place p is drawn where dot(section, vec4(p, 1)) >= 0: everywhere without a section plane
  vec4 body_look;       // x: most halvings of a face, y: 1 strong piece colours, 2 levels, z: backs are lit, w: K that the temperature
                        // view ends at, 0 without it
  vec4 face_view;       // x, y: the numbers of faces with the first and the last colour; z: their colour scale, 1 or 2, or 0 where they are not shown, w: 1 where
                        // faces are shaded by their planes
};
