-- SPDX-License-Identifier: MIT
-- Passes that no picture needs, for tests of what filters do with numbers that are none, and of buffers.
return { name = "oracle_tests" }
