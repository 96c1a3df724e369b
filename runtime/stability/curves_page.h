// SPDX-License-Identifier: MIT
// A report of extremes as a page (one offline HTML file, readable without a script), as text for a terminal and as
// Markdown. All of them are made of the report alone.
#pragma once

#include "stability/curves_report.h"

namespace strobe::stability::curves {

std::string pageOf(const Report& report);

// The same reading without pictures. `page`: where the page is from there.
std::string markdownOf(const Report& report, const std::string& page);

// Where each method stops, aligned.
std::string textOf(const Report& report);

// `text` with {LABEL @ VALUE} replaced by the error of that method, the floor or truth's standard error ("truth")
// there, {from LABEL} and {to LABEL} by the ends of where the method keeps its usual error. Throws `Error` for anything
// else in braces.
std::string filled(const Report& report, const ReportAxis& axis, const std::string& text);

// The same of a variant: {LABEL, VALUE @ CASE} by the error there, {change LABEL, VALUE @ CASE} by the largest
// difference.
std::string filled(const Report& report, const ReportVariant& variant, const std::string& text);

}  // namespace strobe::stability::curves
