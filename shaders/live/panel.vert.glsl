// SPDX-License-Identifier: MIT
// Panels of the live window, vertex stage.
// In:  `position_px`: position in the coordinates of the user interface, px, x right, y down.
//      `uv`: position in the panel's texture, 0 to 1.
//      `color`: vertex colour, sRGB-encoded, straight alpha.
//      `window`: clip units per px, and clip position of the coordinate 0.
// Out: clip position; uv and color unchanged.
// Method: scale and shift the position.
// Fails: never.
layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
layout(location = 0) out vec2 out_uv;
layout(location = 1) out vec4 out_color;

layout(push_constant) uniform Window {
  vec2 clip_per_px;
  vec2 origin_clip;
} window;

void main() {
  out_uv = uv;
  out_color = color;
  gl_Position = vec4(position_px * window.clip_per_px + window.origin_clip, 0, 1);
}
