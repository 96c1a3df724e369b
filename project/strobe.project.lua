-- SPDX-License-Identifier: MIT
-- Marks the folder of a Strobe project. Commands that run inside it find its files and the shipped files.
return { name = "PROJECT" }
