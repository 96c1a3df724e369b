// SPDX-License-Identifier: MIT
#include "repo/prose.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "base/error.h"
#include "repo/text_units.h"

namespace strobe::repo {
namespace {

struct Pattern {
  const char* reason;
  std::regex regex;
};

std::regex anyCase(const std::string& pattern) { return std::regex(pattern, std::regex::icase | std::regex::optimize); }
std::regex thisCase(const std::string& pattern) { return std::regex(pattern, std::regex::optimize); }

// Each regex is matched at the starts of words.
const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> table = {
      {"starts with a relative clause",
       thisCase("^((With|In|From|By|To) what|What|Who|Whoever|Whose|Which|Those|That of|Of|As|Whether|Where|How)\\b"
                "(?!.*\\?\\s*$)")},
      {"'what ...' in place of a noun",
       anyCase("what (is|are|was|were|has|have|had|moves?|lies|stands|comes|goes|does|do|can|may|must|it|they|a|an|the"
               "|no|nothing|nobody|its|shaders?|rays?|scripts?|raster|layers?|truth|one|each|every|follows|fed|runs"
               "|reads|shows|bends|turns|rests)\\b")},
      {"'is no X'", anyCase("(is|are|was|were|be) no "
                            "(?!(longer|more|less|worse|better|larger|smaller|farther|further)\\b)\\w")},
      {"relative clause after a preposition", anyCase("(of|in|by|from|to|at|over|for|on|with) (which|whose|whom)\\b")},
      {"perception for computation",
       anyCase("(is|are|was|were|be|been|being) (told|asked|foretold|let be|had|held against|had by)\\b"
               "|(tells?|told)\\b|asks?\\b(?! (first|before|for (a|the) (password|confirmation)))")},
      {"people as data", anyCase("(nobody|whoever|whosoever|somebody|someone|anybody|no one)\\b")},
      {"pronoun without a noun",
       anyCase("(that of|those of|those that|these of|that which|one that|ones that|such as are|the same of)\\b")},
      {"there is none", anyCase("(there (is|are|was|were) none|has none|have none|is none|of it|of them)\\b")},
      {"idiom", anyCase("no matter to|is no concern|in turn of|goes?\\b on as|by so much|so far off|at most so"
                        "|as far as (nearest|it)|what for|as it stands|of its own accord\\b|for want of"
                        "|else\\b (they|it|this|these)")},
      {"private word",
       thisCase("(foretold|doubt(ed|ful|s)?|unlike|harvest(ed)?|crowded|explain(s|ed)?|unexplained|own[-_ ]time"
                "|surveys?|shafts?|bent|bends?|unseen|behold|retell|dealt|birth|wish(es)?|sight)\\b")},
  };
  return table;
}

// Quotations and code are not the author's prose: each becomes "''".
std::string withoutQuotations(const std::string& text) {
  static const std::vector<std::pair<std::string, std::string>> marks = {{"`", "`"}, {"\"", "\""}, {"“", "”"}};
  std::string plain;
  for (size_t at = 0; at < text.size();) {
    auto opens = [&](const auto& pair) { return text.compare(at, pair.first.size(), pair.first) == 0; };
    auto mark = std::find_if(marks.begin(), marks.end(), opens);
    size_t close = mark == marks.end() ? std::string::npos : text.find(mark->second, at + mark->first.size());
    if (close != std::string::npos) plain += "''";
    else plain += text[at];
    at = close == std::string::npos ? at + 1 : close + mark->second.size();
  }
  return plain;
}

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Patterns are matched at these offsets: std::regex at every character takes several times as long.
std::vector<size_t> wordStarts(const std::string& text) {
  std::vector<size_t> starts;
  for (size_t i = 0; i < text.size(); ++i)
    if (isWordCharacter(text[i]) && (i == 0 || !isWordCharacter(text[i - 1]))) starts.push_back(i);
  return starts;
}

bool matchesAt(const std::string& text, size_t start, const std::regex& regex) {
  auto flags = std::regex_constants::match_continuous;
  if (start > 0) flags |= std::regex_constants::match_prev_avail;  // '^' is the start of the text alone
  return std::regex_search(text.begin() + start, text.end(), regex, flags);
}

bool isGenerated(const std::string& path) {
  bool is_result = path.starts_with("experiments/") && path.find("/result") != std::string::npos;
  return is_result || path.starts_with("docs/reference/") || path == "docs/stability.md" ||
         path == "tools/mutate/mutations.md" || path == "CHANGELOG.md";
}

// Removes accepted sentences from texts, and records which were found.
class Acceptance {
 public:
  explicit Acceptance(const std::vector<AcceptedSentence>& sentences) : sentences_(sentences) {}

  std::string without(const std::string& path, std::string text) {
    for (size_t i = 0; i < sentences_.size(); ++i) {
      const std::string& sentence = sentences_[i].text;
      size_t at = sentences_[i].path == path ? text.find(sentence) : std::string::npos;
      if (at == std::string::npos) continue;
      text.replace(at, sentence.size(), "``");
      met_.insert(i);
    }
    return text;
  }

  Findings unused() const {
    Findings findings;
    for (size_t i = 0; i < sentences_.size(); ++i) {
      const AcceptedSentence& sentence = sentences_[i];
      bool is_flagged = !proseReasons(sentence.text).empty();
      if (met_.count(i) && is_flagged) continue;
      findings.push_back(fmt::format("accepted_sentences.txt:{}: {}: {}", sentence.line,
                                     is_flagged ? "is no longer in its file" : "is not flagged", sentence.text));
    }
    return findings;
  }

 private:
  const std::vector<AcceptedSentence>& sentences_;
  std::set<size_t> met_;
};

}  // namespace

std::vector<std::string> proseReasons(const std::string& text) {
  std::string plain = withoutQuotations(text);
  std::vector<size_t> starts = wordStarts(plain);
  std::vector<std::string> reasons;
  for (const Pattern& pattern : patterns()) {
    auto matches = [&](size_t start) { return matchesAt(plain, start, pattern.regex); };
    if (std::any_of(starts.begin(), starts.end(), matches)) reasons.push_back(pattern.reason);
  }
  return reasons;
}

std::vector<AcceptedSentence> parseAcceptedSentences(const std::string& text) {
  std::istringstream lines(text);
  std::vector<AcceptedSentence> sentences;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    size_t colon = line.find(": ");
    if (colon == std::string::npos || line.find(' ') < colon)
      throw Error("expected PATH: SENTENCE", {"tests/repo/accepted_sentences.txt", number});
    sentences.push_back({line.substr(0, colon), line.substr(colon + 2), number});
  }
  return sentences;
}

ProseReport checkProse(const std::vector<Source>& sources, const std::vector<AcceptedSentence>& accepted) {
  ProseReport report;
  Acceptance acceptance(accepted);
  for (const Source& source : sources) {
    if (isGenerated(source.path)) continue;
    FolderProse& folder = report.folders[source.path.substr(0, source.path.find('/'))];
    for (const TextUnit& unit : textUnits(source)) {
      std::vector<std::string> reasons = proseReasons(acceptance.without(source.path, unit.text));
      ++folder.units;
      if (reasons.empty()) continue;
      folder.flagged.push_back(fmt::format("{}:{}: {}: {}", unit.path, unit.line, fmt::join(reasons, ", "), unit.text));
    }
  }
  report.unused = acceptance.unused();
  return report;
}

}  // namespace strobe::repo
