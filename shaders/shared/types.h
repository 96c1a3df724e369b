// SPDX-License-Identifier: MIT
// Macros that open and close the namespace of structures that C++ fills and GLSL reads, from one source file. Both sides use
// the scalar layout: members follow each other as in C++, without padding to 16 bytes.
#ifndef STROBE_SHARED_TYPES_H
#define STROBE_SHARED_TYPES_H
#ifdef __cplusplus
#include <cstdint>

#include "math/geometry.h"
namespace strobe::shared {
using uint = uint32_t;
}
#define STROBE_SHARED_BEGIN namespace strobe::shared {
#define STROBE_SHARED_END }
#else
#define STROBE_SHARED_BEGIN
#define STROBE_SHARED_END
#endif
#endif
