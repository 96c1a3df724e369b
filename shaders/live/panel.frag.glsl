// SPDX-License-Identifier: MIT
// Fragments of the window's panels: texture times vertex color, blended over the window.
// In:  uv: position in the texture.
//      color: vertex color, sRGB-encoded.
//      panel_tex: texture of the panel, sRGB-encoded.
// Out: color of the window.
// Method: blend the encoded values without decoding, so that the window shows the values of the image files.
layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 color;
layout(location = 0) out vec4 out_color;

layout(set = 0, binding = 0) uniform sampler2D panel_tex;

void main() {
  out_color = color * textureLod(panel_tex, uv, 0);
}
