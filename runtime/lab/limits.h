// SPDX-License-Identifier: MIT
// Limits of shots and pictures, and the list of the limits of all rooms.
#pragma once

#include <array>
#include <vector>

#include "base/limit.h"

namespace strobe::lab {

inline constexpr Limit kBeforeClipLimit{
    "before_clip", Limit::Kind::Warned, "the exposure begins before a clip of keys does",
    "what is keyed is held at its first keys there; take a later frame, a shorter exposure or another anchor"};
inline constexpr Limit kSharedTargetLimit{"shared_target", Limit::Kind::Warned, "clips drive one target",
                                          "the first clip in the file plays; --animation NAME chooses another"};
inline constexpr Limit kClipSeamLimit{
    "clip_seam", Limit::Kind::Warned, "the exposure spans the end of a clip, which then begins again",
    "what is keyed jumps back within the exposure and is blurred over the whole jump; take a frame whose exposure lies "
    "within the clip"};
inline constexpr Limit kNotFiniteLimit{"not_finite", Limit::Kind::Warned, "pixels of the picture are not finite",
                                       "measures of their colours have no value. Print the values of every pass there "
                                       "with `--pixel` and look for a division "
                                       "by zero"};
inline constexpr Limit kOutsideLimit{
    "outside", Limit::Kind::Known, "surfaces that the exposure shows were outside the picture at the raster time",
    "filters of one picture know nothing of it, and what is at the border stands in; truth shows it. Render a larger "
    "picture and crop it"};
inline constexpr Limit kHalfClampedLimit{
    "half_clamped", Limit::Kind::Warned, "a file of 16-bit floats is written of values beyond 65504",
    "they are stored as 65504, the largest half float; write the file without --half, or scale the lights down"};

inline constexpr std::array kLimits = {kBeforeClipLimit, kSharedTargetLimit, kClipSeamLimit,
                                       kNotFiniteLimit,  kHalfClampedLimit,  kOutsideLimit};

// Limits of devices, scenes, worlds and shots, in this order.
std::vector<Limit> allLimits();

}  // namespace strobe::lab
