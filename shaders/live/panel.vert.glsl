// SPDX-License-Identifier: MIT
// Vertices of the window's panels.
// In:  position_px: position from the window's top left corner, px, y down.
//      uv: position in the texture.
//      color: vertex color, sRGB-encoded, straight alpha.
// Out: clip position; uv and color unchanged.
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
