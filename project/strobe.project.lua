-- SPDX-License-Identifier: MIT
-- This file marks the folder of a Strobe project. Commands that run inside the folder find its files and the shipped files.
return { name = "PROJECT" }
