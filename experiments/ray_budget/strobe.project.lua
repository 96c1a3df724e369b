-- SPDX-License-Identifier: MIT
-- Marks this folder as a Strobe project. Its pipeline extends a shipped pipeline.
return { name = "ray_budget" }
