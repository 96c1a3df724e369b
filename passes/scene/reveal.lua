-- SPDX-License-Identifier: MIT
-- What lies behind: a ray through each masked pixel, advanced past the object in front until another one is hit.
-- Source: Tan, Cui, Bhojan, "Hybrid MBlur", SIGGRAPH '20 Posters, section "Ray Reveal".
local pass    = require "strobe.pass"
local gbuffer = require "passes.scene.gbuffer"
local shade   = require "passes.scene.shade"
local stored  = require "passes.lib.stored"

local nothing = { color = 0, depth = 0, id = 0, velocity = 0, valid = 0, found = 0 }

return pass.trace {
  name   = "reveal",
  shader = "scene/reveal",
  doc    = "Colour, depth, ids and displacement of the surface behind the masked foreground",
  size   = { of = "hit" },
  reads  = {
    hit  = { uint = true, doc = "instance + 1 (0 = sky), geometry, primitive of the foreground" },
    mask = { doc = "1 where a ray is wanted" },
  },
  writes = {
    color    = { cleared = true, format = stored.color, doc = "linear radiance of what is revealed; 0 where nothing is" },
    depth    = { cleared = true, format = "r32f",
      doc = "its linear view depth, metres; sky = +inf, 0 where nothing is revealed" },
    id       = { cleared = true, format = "rg32ui", doc = "its instance + 1, geometry + 1; 0 for sky and where nothing is" },
    velocity = { cleared = true, format = stored.velocity, doc = "its displacement over the exposure, px" },
    found    = { cleared = true, format = "rgba32ui",
      doc = "what is revealed: instance + 1 (0 = sky, or nothing), geometry, primitive" },
    valid    = { cleared = true, format = "r8_unorm", doc = "1 where something is revealed" },
  },
  without = { mask = nothing, reached = nothing },
  fails  = "A second layer behind the revealed one stays hidden. Of two surfaces in one place (within 4 " ..
           "representable numbers of depth, more under restart) the second is lost. Glass is revealed " ..
           "as if it were opaque.",
  params = {
    mask_reached = pass.bool { false, wired = true, role = "within_reach",
      doc = "the mask is 0 wherever nothing in motion reaches" },
    displacement = gbuffer.params.displacement,
    velocity_format = stored.velocity_format,
    color_format    = stored.color_format,
    depth_encoding  = stored.depth_encoding,
    termination = pass.choice { "luminance", "geometry", "instance", "motion", "uncovered", default = "instance",
      doc = "what counts as another object than the one in front",
      values = {
        luminance = "The first hit whose luminance differs from that of the surface in front, as published. " ..
                    "Passes through a background of equal luminance, stops inside an object whose back is lit or " ..
                    "painted differently, and never stops in the dark. The picture is no linear function of the " ..
                    "light.",
        geometry  = "The first hit on another geometry (a part of a mesh with its own material) or another " ..
                    "instance. Stops at the next part of the same object, which moves along and is not what gets " ..
                    "uncovered.",
        instance  = "The first hit on another instance. Takes an object made of several instances for several " ..
                    "objects, and never sees one that covers itself.",
        motion    = "The first hit that does not move as if fixed to the surface in front. Misses a background " ..
                    "that happens to move alike, which would be uncovered only later than the exposure.",
        uncovered = "The first hit that moves otherwise on the screen than the foreground does at this pixel, whatever " ..
                    "it belongs to: parts that go along uncover nothing, a turning object uncovers itself. Goes from " ..
                    "hit to hit, the foreground's own included. Fails where the first that does is inside of a closed " ..
                    "object, seen from both sides, that turns.",
      },
      breaks = { luminance = { linear = "luminances are compared: another light may reveal another layer" } } },
    advance = pass.choice { "instance_filter", "origin_kept", "restart", default = "instance_filter",
      doc = "how a ray goes on past a hit",
      values = {
        instance_filter = "One traversal of the same ray that ignores the instance in front (under geometry " ..
                          "termination: that geometry of it). Instance and geometry termination need one ray and " ..
                          "meet no cap; luminance and motion go from hit to hit among the other instances. " ..
                          "Luminance then never stops at the object's own back.",
        origin_kept     = "Hit by hit along the same ray, whose lower bound is raised by 4 representable numbers. " ..
                          "Loses no layer but one in the same place as another; a ray per layer, so it may meet " ..
                          "the cap.",
        restart         = "Hit by hit, a new ray from the hit that starts 0.00001 of the depth later, as " ..
                          "published. Loses layers closer together than that, and far from the origin may find " ..
                          "the same hit again.",
      } },
    max_layers = pass.int { 8, min = 1, max = 31, doc = "most hits tried that are no other object" },
    on_cap = pass.choice { "fallback", "last_hit", default = "fallback",
      doc = "what is revealed at the cap on layers",
      values = {
        fallback = "Nothing: the pixel is blurred as without rays. A background behind more layers than the cap " ..
                   "is missed.",
        last_hit = "The last hit. Where the foreground has more layers than the cap that is still the foreground " ..
                   "itself.",
      } },
    same_motion = pass.float { 1, min = 0, max = 1000, unit = "px",
      doc = "motion and uncovered: a surface that goes no farther from where the foreground would carry it, or goes, " ..
            "belongs to it" },
    tolerance = pass.float { 0.01, min = 0, max = 1,
      doc = "luminance only: another object differs by more than this share of the brighter one, and 0.0001 more" },
    luminance_of = pass.choice { "radiance", "base_color", "material", default = "radiance",
      doc = "luminance only: of what; the paper speaks of the luminance of an object",
      values = {
        radiance   = "Of the radiance towards the camera, as the picture has it. Tells a surface from its own back by " ..
                     "their light.",
        base_color = "Of the surface's base colour, textures included, lights not. Tells a surface from a pattern on " ..
                     "it, and does not see what emits light.",
        material   = "Of the mean base colour of the material: one luminance for all of an object. Cannot tell two " ..
                     "objects of one material; vertex colours and emission do not count.",
      } },
  },
  counters = {
    revealed  = "rays that revealed a surface or sky",
    capped    = {
      doc   = "rays that met the cap on layers",
      limit = "what is behind more layers than `max_layers` was not found; `on_cap` says what stands in. Raise " ..
              "`max_layers`, or take advance = instance_filter, which passes over the object in front at once",
    },
    passed = {
      doc   = "rays that passed through another instance, as bright as the foreground",
      limit = "what lies behind that was revealed instead of it. Take termination = instance",
    },
    not_finite = shade.counters.not_finite,
    met_again = "hits on the triangle just left, which are no layers",
    velocity_clamped = stored.counters.velocity_clamped,
    color_clamped    = stored.counters.color_clamped,
    depth_lost       = stored.counters.depth_lost,
  },
}
