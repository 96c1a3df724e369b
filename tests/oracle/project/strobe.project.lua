-- SPDX-License-Identifier: MIT
-- Passes for tests of filters with invalid numbers, and of buffers.
return { name = "oracle_tests" }
