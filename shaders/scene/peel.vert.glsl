// SPDX-License-Identifier: MIT
// As what is nearest is drawn.
#include "scene/visibility.vert.glsl"
