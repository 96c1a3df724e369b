-- SPDX-License-Identifier: MIT
-- Ray reveal: a ray through each masked pixel, advanced past the object in front until it hits another object.
-- Source: Tan, Cui, Bhojan, "Hybrid MBlur", SIGGRAPH '20 Posters, section "Ray Reveal".
local pass      = require "strobe.pass"
local gbuffer   = require "passes.gbuffer.gbuffer"
local shade     = require "passes.gbuffer.shade"
local quantised = require "passes.lib.quantised"

local nothing = { color = 0, depth = 0, id = 0, velocity = 0, valid = 0, found = 0 }

return pass.trace {
  doc    = "Colour, depth, ids and displacement of the background behind the foreground, by a ray through each masked pixel",
  size   = { of = "hit" },
  reads  = {
    hit  = { uint = true, doc = "foreground surface, by indices: instance + 1 (0 for the sky), geometry, triangle" },
    mask = { doc = "mask, above 1/2 where a ray is traced" },
  },
  writes = {
    color = { cleared = true, format = quantised.color, doc = "colour of the revealed surface, linear radiance; 0 where " ..
        "none is revealed" },
    depth = { cleared = true, format = "r32f",
      doc = "linear view depth of the revealed surface, metres; +inf for the sky, 0 where none is revealed" },
    id       = { cleared = true, format = "rg32ui",
      doc = "instance index + 1, geometry index + 1 of the revealed surface; 0 for the sky and where none is revealed" },
    velocity = { cleared = true, format = quantised.velocity,
      doc = "screen displacement of the revealed surface, px over the exposure; 0 where none is revealed" },
    found    = { cleared = true, format = "rgba32ui",
      doc = "revealed surface, by indices: instance + 1 (0 for the sky and where none is revealed), geometry, triangle" },
    valid    = { cleared = true, format = "r8_unorm", doc = "mask, 1 where a surface or the sky is revealed" },
  },
  if_no = { mask = nothing, moving_rect = nothing },
  -- The mask may contain pixels outside of the moving rectangle (the rectangle that contains all moving objects).
  runs   = "everywhere",
  fails  = "Finds one surface per pixel; further surfaces behind it stay hidden. Of two surfaces whose depths " ..
           "differ by at most 4 units in the last place of a float (more with advance = restart), the farther one " ..
           "is lost. Glass is revealed as if it were opaque.",
  params = {
    displacement = gbuffer.params.displacement,
    velocity_format = quantised.velocity_format,
    color_format    = quantised.color_format,
    depth_encoding  = quantised.depth_encoding,
    termination = pass.choice { "luminance", "geometry", "instance", "motion", "disoccluded", default = "instance",
      doc = "rule that decides which hit along the ray is on another object than the foreground; the ray ends at this hit",
      values = {
        luminance = "First hit whose luminance differs from the luminance of the foreground, as published. Passes through a " ..
                    "background of equal luminance, stops inside an object with a differently lit or painted back, and " ..
                    "never stops in the dark. The picture is not a linear function of the light.",
        geometry  = "First hit on another geometry (a part of a mesh with its own material) or another instance. Stops at " ..
                    "the next part of the same object, which moves with the foreground and is not disoccluded.",
        instance  = "First hit on another instance. Treats an object made of several instances as several objects, and " ..
                    "misses self-occlusion.",
        motion    = "First hit that does not move as if fixed to the foreground. Misses a background that happens to move " ..
                    "with the foreground; such a background is not disoccluded within the exposure.",
        disoccluded = "First hit, on any object, whose displacement differs from the foreground's at this pixel. " ..
                      "Parts that move with the foreground are skipped; other parts of a rotating object are revealed. " ..
                      "Visits every hit, also hits on the foreground. Fails for a rotating closed object with two-sided " ..
                      "triangles: the first such hit is inside the object.",
      },
      breaks = { luminance = { linear = "luminances are compared, so that another lighting may end rays at other hits" } } },
    advance = pass.choice { "instance_filter", "origin_kept", "restart", default = "instance_filter",
      doc = "continuation of a ray past a hit that still counts as foreground",
      values = {
        instance_filter = "One traversal of the same ray that ignores the instance in front (with termination = geometry, " ..
                          "only the geometry in front). Instance and geometry termination need one ray and never reach " ..
                          "`max_layers`; luminance and motion termination visit the hits on other instances in turn. " ..
                          "Luminance termination then never stops at the back of the foreground.",
        origin_kept     = "Hit by hit along the same ray: the ray's lower bound is set to 4 units in the last place beyond " ..
                          "the last hit. Loses only layers that coincide. Each layer needs a ray, so `max_layers` may be " ..
                          "reached.",
        restart         = "Hit by hit with a new ray from the last hit, moved forward by 0.00001 of the depth, as " ..
                          "published. Loses layers closer together than that, and far from the origin may find the same " ..
                          "hit again.",
      } },
    max_layers = pass.int { 8, min = 1, max = 31,
      doc = "largest number of hits along a ray that do not count as another object. A ray that reaches this number ends, " ..
            "with the result that `on_cap` chooses" },
    on_cap = pass.choice { "fallback", "last_hit", default = "fallback",
      doc = "result of a ray that ends because it reaches `max_layers`",
      values = {
        fallback = "Nothing is revealed: the pixel is blurred as without rays. A background behind `max_layers` or more " ..
                   "layers is missed.",
        last_hit = "The last hit of the ray counts as the revealed surface, although this hit may still be foreground.",
      } },
    same_motion = pass.float { 1, min = 0, max = 1000, unit = "px",
      doc = "largest difference between the screen motions of a hit and of the foreground that counts as equal motion; used " ..
            "with termination = motion or disoccluded" },
    tolerance = pass.float { 0.01, min = 0, max = 1,
      doc = "relative difference from the foreground's luminance above which a hit counts as another object; an absolute " ..
            "tolerance of 0.0001 is added. Used with termination = luminance" },
    luminance_of = pass.choice { "radiance", "base_color", "material", default = "radiance",
      doc = "quantity compared by termination = luminance; the paper does not define the luminance of an object",
      values = {
        radiance   = "Radiance towards the camera, as in the picture. Treats a surface and its own back as different " ..
                     "objects if their lighting differs.",
        base_color = "Base colour of the surface, with textures and without lighting. Treats a surface and a pattern on it " ..
                     "as different objects, and ignores emission.",
        material   = "Mean base colour of the material: one luminance per material. Treats two objects of one material as " ..
                     "the same object; ignores vertex colours and emission.",
      } },
  },
  counters = {
    revealed  = "rays that reveal a surface or the sky",
    capped    = {
      doc   = "rays that end because they reach `max_layers`",
      limit = "the background behind `max_layers` or more layers was not found; `on_cap` chooses the result. Raise " ..
              "`max_layers`, or use advance = instance_filter, which skips the object in front at once",
    },
    passed = {
      doc   = "rays that pass through another instance as bright as the foreground",
      limit = "a surface behind that instance was revealed instead. Use termination = instance",
    },
    not_finite = shade.counters.not_finite,
    met_again = "repeated hits on the triangle that a ray has just left; these hits do not count as layers",
    velocity_clamped = quantised.counters.velocity_clamped,
    color_clamped    = quantised.counters.color_clamped,
    depth_lost       = quantised.counters.depth_lost,
  },
}
