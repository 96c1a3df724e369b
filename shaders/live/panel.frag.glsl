// SPDX-License-Identifier: MIT
// Pixels of the window's panels: the texture times the vertices' color, blended over what is there.
// In:  uv; color; both sRGB-encoded, and blended as such: what is shown is what the pictures' files hold.
// Out: color of the window.
layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 color;
layout(location = 0) out vec4 out_color;

layout(set = 0, binding = 0) uniform sampler2D panel_tex;

void main() {
  out_color = color * textureLod(panel_tex, uv, 0);
}
