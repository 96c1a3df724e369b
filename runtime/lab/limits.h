// SPDX-License-Identifier: MIT
// Limits of shots and pictures, and the list of the limits of all rooms.
#pragma once

#include <array>
#include <vector>

#include "base/limit.h"

namespace strobe::lab {

inline constexpr Limit kBeforeClipLimit{
    "before_clip", Limit::Kind::Warned, "the exposure begins before the first key of a clip",
    "keyed values stay at the first key until then; use a later frame, a shorter exposure or another anchor"};
inline constexpr Limit kSharedTargetLimit{"shared_target", Limit::Kind::Warned, "several clips drive the same target",
                                          "the first clip in the file plays; --animation NAME chooses another"};
inline constexpr Limit kClipSeamLimit{
    "clip_seam", Limit::Kind::Warned, "the exposure spans the end of a clip, which then begins again",
    "keyed values jump back within the exposure and are blurred over the whole jump; use a frame with an exposure "
    "within the clip"};
inline constexpr Limit kNotFiniteLimit{
    "not_finite", Limit::Kind::Warned, "pixels of the picture are not finite",
    "measures of their colours have no value. Print the values of every pass at such a pixel "
    "with `--pixel` and look for a division "
    "by zero"};
inline constexpr Limit kOutsideLimit{
    "outside", Limit::Kind::Known, "a surface visible during the exposure is outside the picture at the raster time",
    "filters of one picture have no data of the surface and use pixels at the border instead; ground truth shows the "
    "surface. Render a larger picture and crop it"};
inline constexpr Limit kHalfClampedLimit{
    "half_clamped", Limit::Kind::Warned, "values beyond 65504 are written to a file of 16-bit floats",
    "the file stores them as 65504, the largest half float; write the file without --half, or scale the lights down"};

inline constexpr std::array kLimits = {kBeforeClipLimit, kSharedTargetLimit, kClipSeamLimit,
                                       kNotFiniteLimit,  kHalfClampedLimit,  kOutsideLimit};

// Limits of devices, scenes, worlds and shots, in this order.
std::vector<Limit> allLimits();

}  // namespace strobe::lab
