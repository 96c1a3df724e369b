-- SPDX-License-Identifier: MIT
-- Marks this folder as a Strobe project, with the pipelines, passes and shaders of the rival designs.
return { name = "adaptive_design" }
