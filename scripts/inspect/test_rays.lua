-- SPDX-License-Identifier: MIT
-- Test rays that compare tracing backends with each other. The output is not a picture of the scene.
local pipeline = require "strobe.pipeline"
local rays     = require "passes.inspect.test_rays"

return pipeline {
  doc    = "One test ray through the scene per pixel, and the hit of this ray, to compare tracing backends",
  params = { ray_kind = rays.params.ray_kind },
  build  = function(p)
    local found = rays { ray_kind = p.ray_kind }
    return { color = found.color, origin = found.origin, direction = found.direction, hit = found.hit, blocked = found.blocked }
  end,
}
