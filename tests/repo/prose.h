// SPDX-License-Identifier: MIT
// Sentences that readers have to read twice, found by patterns. A match is a place to edit, not a proof.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "repo/lint.h"

namespace strobe::repo {

// Reasons why a reader may stop, in the order of the pattern table; empty for plain text. Quotations and code in
// backticks are not tested.
std::vector<std::string> proseReasons(const std::string& text);

// A flagged sentence that stays.
struct AcceptedSentence {
  std::string path, text;
  int line = 0;  // in the list
};

// Reads tests/repo/accepted_sentences.txt: "PATH: SENTENCE" per line, '#' comments. Throws `Error` on anything else.
std::vector<AcceptedSentence> parseAcceptedSentences(const std::string& text);

struct FolderProse {
  int units = 0;
  Findings flagged;

  double share() const { return units ? double(flagged.size()) / units : 0; }
};

struct ProseReport {
  std::map<std::string, FolderProse> folders;  // by top folder; a file of the top is a folder of its own
  Findings unused;                             // accepted sentences that are absent or not flagged
};

// Generated pages are left out: docs/reference, docs/stability.md, results of experiments, tools/mutate/mutations.md,
// CHANGELOG.md. Accepted sentences are removed from their unit before it is tested.
ProseReport checkProse(const std::vector<Source>& sources, const std::vector<AcceptedSentence>& accepted);

}  // namespace strobe::repo
