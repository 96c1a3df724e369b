// SPDX-License-Identifier: MIT
// Reference pages in the tree match the declarations, and every alternative states its failures.
#include "lab/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "common/home.h"
#include "script/evaluate.h"

namespace strobe::lab {
namespace reference_test {

namespace fs = std::filesystem;

std::set<std::string> filesBelow(const Path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(entry.path().lexically_relative(folder).generic_string());
  return files;
}

TEST(ReferencePages, AreUpToDate) {
  Path folder = home().shipped() / "docs/reference";
  std::set<std::string> committed = filesBelow(folder), current;
  std::vector<std::string> differ;
  for (const ReferencePage& page : referencePages(home())) {
    current.insert(page.path);
    if (!committed.count(page.path) || readText(folder / page.path) != page.text) differ.push_back(page.path);
  }
  for (const std::string& path : committed)
    if (!current.count(path)) differ.push_back(path);
  EXPECT_TRUE(differ.empty()) << fmt::format("{}", fmt::join(differ, "\n"))
                              << "\nregenerate with: strobe help --write docs/reference";
}

// Every link of a page leads to another page.
TEST(ReferencePages, LinksLeadToPages) {
  std::vector<ReferencePage> pages = referencePages(home());
  std::set<std::string> known;
  for (const ReferencePage& page : pages) known.insert(page.path);
  for (const ReferencePage& page : pages)
    for (size_t at = page.text.find("]("); at != std::string::npos; at = page.text.find("](", at + 1)) {
      std::string link = page.text.substr(at + 2, page.text.find(')', at) - at - 2);
      EXPECT_TRUE(known.count((Path(page.path).parent_path() / link).lexically_normal().generic_string()))
          << page.path << ": " << link;
    }
}

// --- Descriptions of alternatives

const std::set<std::string> kFamilies = {"edge", "mask", "gather", "composite"};

bool isAlternative(const plan::PassDesc& pass) {
  Path file = pass.place.file;
  return kFamilies.count(file.parent_path().filename()) || file == "passes/hybrid/ray_reveal.lua";
}

// Choices without a description. Choices that are files of the passes folder named like the parameter need none: their
// pages describe them.
std::vector<std::string> undescribed(const std::string& owner, const std::vector<plan::ParamDesc>& params) {
  std::vector<std::string> missing;
  for (const plan::ParamDesc& param : params) {
    for (const std::string& choice : param.choices) {
      auto is_it = [&](const auto& value) { return value.first == choice; };
      bool described = std::any_of(param.values.begin(), param.values.end(), is_it);
      bool has_page = fs::exists(home().shipped() / "passes" / param.name / (choice + ".lua"));
      if (!described && !has_page)
        missing.push_back(fmt::format("{}.{} = {} ({})", owner, param.name, choice, param.place.text()));
    }
  }
  return missing;
}

TEST(Alternatives, EachPassStatesItsFailures) {
  int alternatives = 0;
  for (const plan::PassDesc& pass : script::evaluateAllPasses(home())) {
    alternatives += isAlternative(pass);
    if (isAlternative(pass)) EXPECT_FALSE(pass.fails.empty()) << pass.place.text() << " has no 'fails'";
  }
  EXPECT_GE(alternatives, 15);
}

TEST(Alternatives, EachChoiceIsDescribed) {
  std::vector<std::string> missing;
  auto look = [&](const std::string& owner, const std::vector<plan::ParamDesc>& params) {
    for (const std::string& one : undescribed(owner, params)) missing.push_back(one);
  };
  for (const plan::PassDesc& pass : script::evaluateAllPasses(home()))
    if (isAlternative(pass)) look(pass.name, pass.params);
  for (const std::string& name : script::pipelineNames(home()))
    look(name, script::evaluatePipeline(home(), {name, {}}).params);
  EXPECT_TRUE(missing.empty()) << fmt::format("{}", fmt::join(missing, "\n"));
}

}  // namespace reference_test
}  // namespace strobe::lab
