// SPDX-License-Identifier: MIT
#include "common/pages.h"

#include <algorithm>
#include <sstream>

#include "common/source.h"

namespace strobe::testing {

namespace {

struct Block {
  std::string language, target, text;
};

std::vector<Block> blocksOf(const std::string& page) {
  std::vector<Block> blocks;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    bool fence = line.starts_with("```");
    if (fence && !inside) {
      size_t space = std::min(line.find(' '), line.size());
      blocks.push_back({line.substr(3, space - 3), line.substr(std::min(space + 1, line.size())), ""});
    } else if (!fence && inside) {
      blocks.back().text += line + "\n";
    }
    inside = inside != fence;
  }
  return blocks;
}

std::vector<std::string> commandsIn(const std::string& text) {
  std::vector<std::string> commands;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("./strobe ") || line.starts_with("strobe "))
      commands.push_back(line.substr(line.find(' ') + 1));
  return commands;
}

void add(Page& page, const Block& block) {
  bool of_file = block.language == "lua" || block.language == "glsl" || block.language == "json";
  size_t colon = block.target.find(':');
  if (of_file && !block.target.empty()) {
    if (colon == std::string::npos) page.files[block.target] = block.text;
    else
      page.mistakes.push_back(
          {block.target.substr(0, colon), block.text, "", "", std::stoi(block.target.substr(colon + 1))});
  }
  if (block.language == "sh" && block.target == "fails")
    page.mistakes.push_back({"", "", commandsIn(block.text).at(0), "", 0});
  if (block.language == "sh" && block.target.empty())
    for (const std::string& command : commandsIn(block.text)) page.commands.push_back(command);
  if (block.target == "error" && !page.mistakes.empty())
    page.mistakes.back().error = block.text.substr(0, block.text.size() - 1);
}

}  // namespace

Page readPage(const std::string& name) {
  Page page;
  for (const Block& block : blocksOf(readText(sourceFolder() / "docs" / name))) add(page, block);
  return page;
}

std::string withLine(const std::string& text, int number, const std::string& line) {
  size_t start = 0;
  for (int i = 1; i < number; ++i) start = text.find('\n', start) + 1;
  return text.substr(0, start) + line + text.substr(text.find('\n', start) + 1);
}

}  // namespace strobe::testing
