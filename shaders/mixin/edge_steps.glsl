// SPDX-License-Identifier: MIT
// Needs: params.depth_threshold, params.normal_threshold, PARAM_combine.
// Steps of depth and normal, each against its own threshold. depth_threshold is a share of the pixel's own depth,
// normal_threshold a length.
#ifndef STROBE_EDGE_STEPS_GLSL
#define STROBE_EDGE_STEPS_GLSL

// Above 1 on an edge. `max`: either step suffices; `sum`: both count together; `and`: both must be there.
float combined(float depth_step, float normal_step) {
  float in_depth = depth_step / params.depth_threshold;
  float in_normal = normal_step / params.normal_threshold;
#if PARAM_combine == combine_sum
  return in_depth + in_normal;
#elif PARAM_combine == combine_and
  return min(in_depth, in_normal);
#else
  return max(in_depth, in_normal);
#endif
}

#endif
