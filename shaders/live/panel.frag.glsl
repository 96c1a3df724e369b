// SPDX-License-Identifier: MIT
// Panels of the live window, fragment stage: texture times vertex colour, blended over the window by alpha.
// In:  `uv`: position in the panel's texture, 0 to 1.
//      `color`: vertex colour, sRGB-encoded, straight alpha.
//      `panel_tex`: texture of the panel, sRGB-encoded.
// Out: `out_color`: colour of the window, sRGB-encoded.
// Method: multiply and blend the encoded values without decoding, so that pictures in the window have the values of the image
//   files.
// Fails: blending is not linear in light, so that translucent panels look different from a mixture of light.
layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 color;
layout(location = 0) out vec4 out_color;

layout(set = 0, binding = 0) uniform sampler2D panel_tex;

void main() {
  out_color = color * textureLod(panel_tex, uv, 0);
}
