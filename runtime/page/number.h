// SPDX-License-Identifier: MIT
// Numbers as people read them: in tables, beside marks, along axes.
#pragma once

#include <string>

namespace strobe::page {

// Shown where nothing was measured.
inline constexpr const char* kNotMeasured = "–";

// An error of linear values (RMSE, FLIP): five decimals, so that columns line up; two digits below 0.0001, "0.000012";
// an exponent below a millionth, "1.2e-07"; NaN as kNotMeasured.
std::string shownError(double value);

// A share of 1 as a percentage of three significant digits; NaN as kNotMeasured.
std::string shownShare(double share);

// A number of pixels, rounded to an integer; NaN as kNotMeasured.
std::string shownCount(double count);

// "9.12 ms", "12 ms"; NaN as kNotMeasured.
std::string shownMs(double ms);

// A length or a count that need not be whole: one decimal below 1000.
std::string shownPixels(double pixels);

// A round number, as along an axis: "0.01", "1000", "3·10⁻⁶".
std::string shownNumber(double value);

}  // namespace strobe::page
