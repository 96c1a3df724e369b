-- SPDX-License-Identifier: MIT
-- Marks the folder of a Strobe project: inside it, commands find its files beside those that ship.
return { name = "PROJECT" }
