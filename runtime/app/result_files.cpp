// SPDX-License-Identifier: MIT
#include "app/result_files.h"

#include <filesystem>

#include "image/png.h"
#include "study/report.h"

namespace strobe::app {

ResultNames namesIn(const Path& folder) {
  for (const ResultNames& names : {kDemoNames, ResultNames()})
    if (std::filesystem::exists(resultsFile(folder, names))) return names;
  throw Error(fmt::format("no results in '{}' ({})", folder.string(), ResultNames().results), {}, 2);
}

Path resultsFile(const Path& folder, const ResultNames& names) {
  const Path unfinished = folder / names.outline;
  return std::filesystem::exists(unfinished) ? unfinished : folder / names.results;
}

std::vector<Path> writeResults(const study::Results& results, const Path& folder, const ResultNames& names,
                               bool still) {
  study::Report report(results, folder);
  std::vector<Path> files;
  auto keep = [&](const std::string& name, const std::string& text) {
    files.push_back(folder / name);
    writeFileAtomically(files.back(), text);
  };
  if (report.hasSheet() && !names.sheet.empty()) {
    files.push_back(folder / names.sheet);
    image::writePng(files.back(), report.sheet());
  }
  keep(names.page, report.page(still ? page::Library() : page::findLibrary()));
  keep(names.results, study::textOf(results));
  keep(names.text, report.markdown(names.page));
  for (const auto& [name, svg] : report.figures()) keep(name, svg);
  keep(names.table, study::csvOf(results));
  if (std::string passes = study::passesCsvOf(results); !passes.empty()) keep(names.passes, passes);
  return files;
}

}  // namespace strobe::app
