// SPDX-License-Identifier: MIT
// Histogram of the ray priorities of all pixels (lib/priority.glsl). priority_limit.glsl computes a threshold from the counts.
// In:  priority: ray priority of each pixel, 0 to 4095.
// Out: counts: entry i is the number of pixels with priority i. Entry 0 stays 0, because priority 0 is never selected.
// Method: the pass has fewer invocations than the picture has pixels. Each invocation counts every n-th pixel, where n is the
//      number of invocations, with atomic additions.
// Fails: does not fail.
#include "lib/priority.glsl"

void run(ivec2 own) {
  ivec2 size = textureSize(priority_tex, 0);
  int pixels = size.x * size.y, step_px = pass_size().x * pass_size().y;
  for (int i = own.y * pass_size().x + own.x; i < pixels; i += step_px) {
    uint priority = texelFetch(priority_tex, ivec2(i % size.x, i / size.x), 0).x;
    if (priority > 0u) atomicAdd(counts_buf.entries[min(priority, kPriorities - 1u)], 1u);
  }
}
