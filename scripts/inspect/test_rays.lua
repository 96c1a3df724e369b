-- SPDX-License-Identifier: MIT
-- What the tracing backends are held against each other with. Not a picture of the scene.
local pipeline = require "strobe.pipeline"
local rays     = require "passes.inspect.test_rays"

return pipeline {
  doc    = "A ray of its own for each pixel through the scene, and what it hits, to compare tracing backends",
  params = { ray_kind = rays.params.ray_kind },
  build  = function(p)
    local found = rays { ray_kind = p.ray_kind }
    return { color = found.color, origin = found.origin, direction = found.direction, hit = found.hit, blocked = found.blocked }
  end,
}
