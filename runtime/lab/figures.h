// SPDX-License-Identifier: MIT
// What sheet, page and tables say alike: numbers and names of an exhibition in words.
#pragma once

#include "lab/exhibit.h"

namespace strobe::lab {

// Four significant digits; "–" where nothing was measured.
std::string shownError(double value);

// "12.3 ms" and the like; "–" where nothing was timed.
std::string shownMs(const Entry& entry);

// What was taken how: size, exposure, anchor, motion.
std::string describeShot(const ShotResult& result);

// Contrast of the background, empty where there is none.
std::string describeContrast(const ShotResult& result);

// Whether milliseconds are a GPU's.
std::string describeDevice(const Exhibition& exhibition);

// What a row of the tables is: "floor" and "truth" need telling apart from methods.
std::string describeRole(const DemoColumn& column);

struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

// One table per group: measures by region, time, clamped pixels.
Table tableOf(const Exhibition& exhibition, const ShotResult& result, const Group& group);

// All tables as plain text or Markdown.
std::string tablesText(const Exhibition& exhibition);
std::string tablesMarkdown(const Exhibition& exhibition);

// Every number and the run record of every column.
Json toJson(const Exhibition& exhibition);

}  // namespace strobe::lab
