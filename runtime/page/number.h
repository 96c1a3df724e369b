// SPDX-License-Identifier: MIT
// Numbers as text, for tables, marks and axes.
#pragma once

#include <string>

namespace strobe::page {

// Text for a value that was not measured.
inline constexpr const char* kNotMeasured = "–";

// Error of linear values (RMSE, FLIP): five decimals, so that columns line up; two significant digits below 0.0001,
// "0.000012"; an exponent below a millionth, "1.2e-07"; NaN: kNotMeasured.
std::string shownError(double value);

// Fraction of 1 as a percentage with three significant digits; NaN: kNotMeasured.
std::string shownShare(double share);

// Number of pixels, rounded to an integer; NaN: kNotMeasured.
std::string shownCount(double count);

// Milliseconds: "9.12 ms", "12 ms"; NaN: kNotMeasured.
std::string shownMs(double ms);

// Length or fractional count: one decimal below 1000, no decimals above.
std::string shownPixels(double pixels);

// Round number, for example of a tick: "0.01", "1000", "3·10⁻⁶".
std::string shownNumber(double value);

}  // namespace strobe::page
