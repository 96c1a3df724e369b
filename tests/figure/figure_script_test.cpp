// SPDX-License-Identifier: MIT
// Data that scripts/strobe/figure.lua makes from a figure: cells inherit fields from figure, row and column; all
// mistakes are reported together, each at its line.
#include <gtest/gtest.h>

#include "figures.h"

namespace strobe::figure {
namespace figure_script_test {

TEST(FigureScript, CellsOverrideFieldsAndAddMarks) {
  FigureData figure = figureFrom(dataOf(R"(name = "x", shot = "still", zoom = 2, arrows = { { to = { 1, 1 } } },
    rows = { { label = "near", crop = { 0, 0, 8, 8 } }, { zoom = 3 } },
    columns = { { arm = "plain", label = "Plain" }, { arm = "truth", zoom = 4, arrows = { { to = { 2, 2 } } } } },
    cells = { { row = "near", column = "Plain", zoom = 5, arrows = { { to = { 3, 3 } } } }, { row = 2, column = 1, empty = true } })"));
  ASSERT_EQ(figure.cells.size(), 3u);
  EXPECT_EQ(figure.columns, (std::vector<std::string>{"Plain", "truth"}));
  EXPECT_EQ(figure.rows, (std::vector<std::string>{"near", ""}));
  EXPECT_EQ(figure.cells[0].zoom, 5) << "the cell's own";
  EXPECT_EQ(figure.cells[0].marks.size(), 2u) << "of the figure and of the cell";
  EXPECT_EQ(figure.cells[1].zoom, 4) << "column overrides figure";
  EXPECT_EQ(figure.cells[1].marks.size(), 2u);
  EXPECT_EQ(figure.cells[2].zoom, 4) << "column overrides row";
  EXPECT_EQ(figure.cells[2].row, 1);
  EXPECT_EQ(figure.cells[2].column, 1);
  EXPECT_TRUE(figure.cells[1].crop && !figure.cells[2].crop);
  EXPECT_EQ(figure.width, 64);
}

TEST(FigureScript, ColoursAreNamesOrHexadecimal) {
  FigureData figure = figureFrom(dataOf(R"(name = "x", shot = "still", arm = "plain",
    circles = { { at = { 1, 1 }, radius = 2, color = "#ff0080" }, { at = { 1, 1 }, radius = 2, color = "white" } })"));
  EXPECT_EQ(figure.cells[0].marks[0].colour, (Colour{1, 0, 128 / 255.0f}));
  EXPECT_EQ(figure.cells[0].marks[1].colour, (Colour{1, 1, 1}));
}

TEST(FigureScript, EveryMistakeIsReportedAtItsLine) {
  struct Mistake {
    const char *lua, *line, *text;
  };
  // The table begins in line 11, these fields in line 13.
  const Mistake mistakes[] = {
      {"nam = 'y'", "13", "has no field 'nam'"},
      {"cells = { { row = 2, zoom = 2 } }", "13", "'row' of a cell is 2; it must be a number from 1 to 1 or a label"},
      {"rows = { { arm = 'plai' } }", "13",
       "the arm is 'plai', which is not one of plain, truth; did you mean 'plain'?"},
      {"shot = 'stil'", "13", "the shot is 'stil', which is not one of still, other; did you mean 'still'?"},
      {"arrows = { { to = { 1, 2 }, on = 'ball' } }", "13", "an arrow must have either 'to' = { x, y } or 'on'"},
      {"arrows = {\n { to = { 1, 2 } },\n { to = { 1 } } }", "15", "'to' of an arrow takes 2 numbers"},
      {"arrows = { to = { 1, 2 } }", "13", "arrows must be a list: { { ... }, ... }"},
      {"circles = { { at = { 1, 2 } } }", "13", "has no 'radius'"},
      {"insets = { { crop = { 1, 2, 3, 4 }, boxes = { { area = { 0.5, 0, 1, 1 } } } } }", "13",
       "whole pixels of the capture"},
      {"texts = { { at = { 1, 2 }, text = 'a', color = 'yelow' } }", "13", "'yelow' is not a colour"},
      {"zoom = 1.5", "13", "'zoom' is 1.5; it must be a whole number from 1 to 64"},
      {"zoom = 2, shrink = 2", "11", "has both a zoom and a shrink"},
      {"gain = 4", "11", "has a gain, but no 'against'"},
      {"against = 'truth', difference = 'flip', gain = 4", "11", "FLIP has a fixed scale"},
      {"against = 'truth', difference = 'heat'", "13",
       "the difference is 'heat', which is not one of mean, channels, flip"},
      {"caption = 'FLIP {flop}'", "13", "did you mean 'flip'?"},
      {"caption = 'FLIP {flip'", "13", "a caption has an unpaired brace"},
      {"caption = '{exposure inner}'", "13", "cannot have a region"},
      {"kind = 'heat'", "13", "the kind of a view is 'heat', which is not one of auto, colour"},
      {"fps = 24", "13", "has no field 'fps'"},
      {"columns = { { title = 'a' } }", "13", "column 1 has no field 'title'"},
      {"rows = { { note = '{flop}' } }", "13", "did you mean 'flip'?"},
      {"caption = '{displacement inner}'", "13", "has no region: it is measured over all moving"},
      {"crop = { 'inner', 4 }", "13", "{ x, y, width, height } or { REGION, width, height }"},
      {"zoom = 2, cell_width = 64", "11", "has a zoom, but its size is set by the figure's cell_width"},
  };
  for (const Mistake& mistake : mistakes) {
    std::string cell = std::string(mistake.lua).find("shot") == 0 ? "" : "shot = 'still', ";
    std::string arm = std::string(mistake.lua).find("plai'") != std::string::npos ? "" : "arm = 'plain', ";
    try {
      dataOf("name = 'x', " + cell + arm + "\n" + mistake.lua);
      ADD_FAILURE() << mistake.lua;
    } catch (const Error& error) {
      std::string text = error.what();
      EXPECT_NE(text.find(mistake.text), std::string::npos) << mistake.lua << "\n" << text;
      EXPECT_NE(text.find(std::string("x.lua:") + mistake.line), std::string::npos) << mistake.lua << "\n" << text;
    }
  }
  try {
    dataOf("name = '../x', arm = 'plain', zoom = 0, crop = { 1, 2 }");
    ADD_FAILURE();
  } catch (const Error& error) {
    for (const char* part : {"'../x' is not a file name", "has no shot", "'zoom' is 0", "the crop takes 4 numbers"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}  // namespace figure_script_test
}  // namespace strobe::figure
