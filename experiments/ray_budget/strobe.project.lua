-- SPDX-License-Identifier: MIT
-- Marks this folder as a Strobe project, with its own pipeline, passes and shaders. The pipeline extends the shipped pipelines.
return { name = "ray_budget" }
