-- SPDX-License-Identifier: MIT
-- A road of two triangles, 4 m wide and 2 * `length` m long, along x, 1 m below a camera that looks along the road.
local scene = require "strobe.scene"

local long = scene.param("length", 1e7)
local corners = { { -long, -1, -2 }, { long, -1, -2 }, { long, -1, 2 }, { -long, -1, 2 } }
return scene {
  name = "road",
  nodes = {
    scene.node {
      name = "road", material = scene.material { name = "road", unlit = true },
      shape = scene.triangles { positions = corners, indices = { 1, 2, 3, 1, 3, 4 } },
    },
    scene.node {
      name = "camera", rotation = { 0, -90, 0 }, camera = scene.camera { name = "main", fov = 60, near = 0.1 },
    },
  },
}
