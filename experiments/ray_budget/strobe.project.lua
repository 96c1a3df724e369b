-- SPDX-License-Identifier: MIT
-- Marks the folder of a Strobe project: its pipeline extends a shipped one.
return { name = "ray_budget" }
