// SPDX-License-Identifier: MIT
#include "mutate/mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "base/error.h"
#include "base/hash.h"
#include "mutate/glsl.h"

namespace strobe::mutate {

const std::vector<MutationOperator>& mutationOperators() {
  using enum MutationOperator;
  static const std::vector<MutationOperator> all = {
      Sign, Constant, Comparison, OffByOne, SwappedOperands, Extremum, Connective, DroppedClamp, DroppedSanitiser};
  return all;
}

const char* nameOf(MutationOperator op) {
  switch (op) {
    case MutationOperator::Sign:
      return "sign";
    case MutationOperator::Constant:
      return "constant";
    case MutationOperator::Comparison:
      return "comparison";
    case MutationOperator::OffByOne:
      return "off by one";
    case MutationOperator::SwappedOperands:
      return "swapped operands";
    case MutationOperator::Extremum:
      return "min and max";
    case MutationOperator::Connective:
      return "and and or";
    case MutationOperator::DroppedClamp:
      return "dropped clamp";
    case MutationOperator::DroppedSanitiser:
      return "dropped sanitiser";
  }
  return "";
}

namespace {

// Tokens [first, last].
struct Span {
  size_t first = 0, last = 0;
};

const std::set<std::string> kStatements = {"return", "else", "case", "if",    "for",  "while",
                                           "do",     "in",   "out",  "inout", "const"};

// True if the first two arguments of a call can be swapped without an effect, or cannot be swapped because of their
// types.
bool isSymmetricCall(const std::string& name) {
  static const std::set<std::string> symmetric = {"min", "max", "dot", "distance", "equal", "notEqual"};
  return symmetric.count(name) || name.starts_with("texture") || name.starts_with("texel") || name.starts_with("image");
}

class Finder {
 public:
  Finder(const std::string& file, const std::string& text, const Vocabulary& words)
      : file_(file), text_(text), words_(words), tokens_(tokensOf(text)) {}

  std::vector<Mutant> all() {
    for (size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].fixed) continue;
      if (tokens_[i].kind == Token::Kind::Number) constant(i);
      if (tokens_[i].kind == Token::Kind::Name) call(i);
      if (tokens_[i].kind != Token::Kind::Sign) continue;
      sign(i);
      comparison(i);
      offByOne(i);
      swappedAround(i);
      if (is(i, "&&")) add(MutationOperator::Connective, {i, i}, "||");
      if (is(i, "||")) add(MutationOperator::Connective, {i, i}, "&&");
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Mutant& a, const Mutant& b) { return a.offset < b.offset; });
    return std::move(found_);
  }

 private:
  bool is(size_t i, std::string_view text) const { return i < tokens_.size() && tokens_[i].is(text); }
  bool isAny(size_t i, std::initializer_list<const char*> texts) const {
    return std::any_of(texts.begin(), texts.end(), [&](const char* text) { return is(i, text); });
  }
  std::string textOf(Span span) const {
    return text_.substr(tokens_[span.first].at, tokens_[span.last].end() - tokens_[span.first].at);
  }
  std::string between(Span left, Span right) const {
    return text_.substr(tokens_[left.last].end(), tokens_[right.first].at - tokens_[left.last].end());
  }

  void add(MutationOperator op, Span span, const std::string& after) {
    Mutant mutant;
    mutant.file = file_;
    mutant.op = op;
    mutant.offset = tokens_[span.first].at;
    LinePlace place = placeOf(text_, mutant.offset);
    mutant.line = place.line;
    mutant.column = place.column;
    mutant.before = textOf(span);
    mutant.after = after;
    bool known = std::any_of(found_.begin(), found_.end(), [&](const Mutant& other) {
      return other.offset == mutant.offset && other.before == mutant.before && other.after == after;
    });
    if (!known && mutant.before != after) found_.push_back(mutant);
  }

  // True if a value ends at token i, so that a sign after the token has two operands.
  bool endsValue(size_t i) const {
    const Token& token = tokens_[i];
    if (token.kind == Token::Kind::Number || token.is(")") || token.is("]")) return true;
    return token.kind == Token::Kind::Name && !kStatements.count(token.text);
  }
  bool isBinary(size_t i) const { return i > 0 && i + 1 < tokens_.size() && endsValue(i - 1); }

  void sign(size_t i) {
    static const std::map<std::string, std::string> other = {{"+", "-"},   {"-", "+"},   {"+=", "-="},
                                                             {"-=", "+="}, {"++", "--"}, {"--", "++"}};
    auto found = other.find(tokens_[i].text);
    if (found == other.end()) return;
    bool step = tokens_[i].text.size() == 2;
    if (step && tokens_[i].for_part == 2) return;  // an endless loop proves nothing
    if (step || isBinary(i)) add(MutationOperator::Sign, {i, i}, found->second);
    else if (is(i, "-")) add(MutationOperator::Sign, {i, i}, "");
  }

  void constant(size_t i) {
    std::string digits = tokens_[i].text, suffix;
    bool hex = digits.starts_with("0x");
    while (!digits.empty() && std::string("uUfF").find(digits.back()) != std::string::npos &&
           !(hex && digits.back() != 'u'))
      suffix.insert(0, 1, digits.back()), digits.pop_back();
    bool real = !hex && digits.find_first_of(".eE") != std::string::npos;
    double value = hex ? double(std::stoull(digits, nullptr, 16)) : std::stod(digits);
    auto put = [&](double changed) {
      std::string text = real ? fmt::format("{:.9g}", changed) : fmt::format("{:.0f}", changed);
      if (real && text.find_first_of(".e") == std::string::npos) text += ".0";
      add(MutationOperator::Constant, {i, i}, text + suffix);
    };
    if (value == 0) return put(1);
    put(0);
    if (!hex && value < 1e9) put(2 * value);
  }

  void comparison(size_t i) {
    static const std::map<std::string, std::vector<std::string>> others = {{"<", {"<=", ">"}}, {"<=", {"<", ">="}},
                                                                           {">", {">=", "<"}}, {">=", {">", "<="}},
                                                                           {"==", {"!="}},     {"!=", {"=="}}};
    auto found = others.find(tokens_[i].text);
    if (found == others.end() || !isBinary(i)) return;
    for (const std::string& other : found->second) {
      bool bound = tokens_[i].for_part == 1 && other[0] == tokens_[i].text[0];
      add(bound ? MutationOperator::OffByOne : MutationOperator::Comparison, {i, i}, other);
    }
  }

  bool isInteger(size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == Token::Kind::Number && (is(i, "1") || is(i, "1u"));
  }

  void offByOne(size_t i) {
    if (is(i, "[") && tokens_[i].partner == int(i) + 2 && tokens_[i + 1].kind == Token::Kind::Name)
      add(MutationOperator::OffByOne, {i + 1, i + 1}, tokens_[i + 1].text + " + 1");
    bool one = isAny(i, {"+", "-"}) && isBinary(i) && isInteger(i + 1) && !isAny(i + 2, {"*", "/", "%", "<<"});
    if (one) add(MutationOperator::OffByOne, {i, i + 1}, "");
  }

  // Primary expression (name, number, call, index or parentheses, with members) that ends or starts at a token.
  Span primaryBefore(size_t last) const {
    size_t first = last;
    for (;;) {
      if (isAny(first, {")", "]"}) && tokens_[first].partner >= 0) first = size_t(tokens_[first].partner);
      bool called = isAny(first, {"(", "["}) && first > 0 && endsValue(first - 1);
      bool member = tokens_[first].kind == Token::Kind::Name && first > 1 && is(first - 1, ".");
      if (called) --first;
      else if (member) first -= 2;
      else return {first, last};
    }
  }
  Span primaryAfter(size_t first) const {
    size_t last = first;
    if (isAny(last, {"-", "!", "~", "+"}) && last + 1 < tokens_.size()) ++last;
    if (is(last, "(") && tokens_[last].partner >= 0) last = size_t(tokens_[last].partner);
    while (last + 1 < tokens_.size()) {
      if (isAny(last + 1, {"(", "["}) && tokens_[last + 1].partner >= 0) last = size_t(tokens_[last + 1].partner);
      else if (is(last + 1, ".") && last + 2 < tokens_.size()) last += 2;
      else break;
    }
    return {first, last};
  }

  // Term (factors joined by *, / and %) that ends or starts at a token.
  Span termBefore(size_t last) const {
    Span span = primaryBefore(last);
    while (span.first > 1 && isAny(span.first - 1, {"*", "/", "%"})) span.first = primaryBefore(span.first - 2).first;
    return span;
  }
  Span termAfter(size_t first) const {
    Span span = primaryAfter(first);
    while (span.last + 2 < tokens_.size() && isAny(span.last + 1, {"*", "/", "%"}))
      span.last = primaryAfter(span.last + 2).last;
    return span;
  }

  void swappedAround(size_t i) {
    if (!isAny(i, {"-", "/"}) || !isBinary(i)) return;
    bool minus = is(i, "-");
    Span left = minus ? termBefore(i - 1) : primaryBefore(i - 1);
    Span right = minus ? termAfter(i + 1) : primaryAfter(i + 1);
    // Skip the second sign of a - b - c and a / b / c: its left operand is a - b or a / b, not b.
    bool alone =
        left.first == 0 || !(minus ? isAny(left.first - 1, {"+", "-"}) : isAny(left.first - 1, {"*", "/", "%"}));
    if (alone) swap(left, right);
  }

  void swap(Span left, Span right) {
    add(MutationOperator::SwappedOperands, {left.first, right.last},
        textOf(right) + between(left, right) + textOf(left));
  }

  std::vector<Span> argumentsOf(size_t open) const {
    std::vector<Span> arguments;
    size_t close = size_t(tokens_[open].partner), first = open + 1;
    for (size_t i = open + 1; i <= close; ++i) {
      if (i == close || is(i, ",")) {
        if (i > first) arguments.push_back({first, i - 1});
        first = i + 1;
      } else if (isAny(i, {"(", "[", "{"}) && tokens_[i].partner > int(i)) {
        i = size_t(tokens_[i].partner);
      }
    }
    return arguments;
  }

  bool isLiteral(Span span) const {
    bool built = tokens_[span.first].text.find("vec") != std::string::npos && is(span.first + 1, "(");
    for (size_t i = span.first + (built ? 1 : 0); i <= span.last; ++i)
      if (tokens_[i].kind == Token::Kind::Name) return false;
    return true;
  }

  // True if two arguments may be swapped. A literal and a name seldom have one type, except in generic functions.
  bool mayTurn(const std::string& name, const std::vector<Span>& arguments) const {
    static const std::set<std::string> generic = {"mix", "pow", "step", "smoothstep", "atan", "mod", "clamp"};
    if (isSymmetricCall(name) || words_.unlike.count(name)) return false;
    return generic.count(name) || isLiteral(arguments[0]) == isLiteral(arguments[1]);
  }

  void call(size_t i) {
    if (!is(i + 1, "(") || tokens_[i + 1].partner < 0 || kStatements.count(tokens_[i].text)) return;
    bool declared = i > 0 && tokens_[i - 1].kind == Token::Kind::Name && !kStatements.count(tokens_[i - 1].text);
    if (declared) return;
    std::vector<Span> arguments = argumentsOf(i + 1);
    if (arguments.empty()) return;
    const std::string& name = tokens_[i].text;
    Span whole = {i, size_t(tokens_[i + 1].partner)};
    bool extremum = name == "min" || name == "max";
    if (extremum) add(MutationOperator::Extremum, {i, i}, name == "min" ? "max" : "min");
    if ((extremum && arguments.size() == 2) || (name == "clamp" && arguments.size() == 3)) {
      Span kept = extremum && isLiteral(arguments[0]) ? arguments[1] : arguments[0];
      add(MutationOperator::DroppedClamp, whole, "(" + textOf(kept) + ")");
    }
    auto sanitiser = words_.sanitisers.find(name);
    if (sanitiser != words_.sanitisers.end() && arguments.size() == 1)
      add(MutationOperator::DroppedSanitiser, whole, sanitiser->second + "(" + textOf(arguments[0]) + ")");
    if (arguments.size() >= 2 && arguments.size() <= 3 && mayTurn(name, arguments)) swap(arguments[0], arguments[1]);
  }

  const std::string& file_;
  const std::string& text_;
  const Vocabulary& words_;
  std::vector<Token> tokens_;
  std::vector<Mutant> found_;
};

// Random number below `bound`, equal on every machine. The distributions of <random> differ between machines.
size_t below(std::mt19937_64& random, size_t bound) { return size_t(random() % bound); }

template <class T>
void shuffle(std::vector<T>& values, std::mt19937_64& random) {
  for (size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(random, i)]);
}

// Shares in proportion to the sizes, at least one per file with mutants; the largest remainders are rounded up first.
std::vector<size_t> sharesOf(const std::vector<std::vector<Mutant>>& by_file, size_t count) {
  size_t total = 0;
  for (const auto& mutants : by_file) total += mutants.size();
  std::vector<size_t> shares(by_file.size(), 0);
  std::vector<std::pair<double, size_t>> remainders;
  size_t given = 0;
  for (size_t i = 0; i < by_file.size() && total > 0; ++i) {
    double exact = double(count) * double(by_file[i].size()) / double(total);
    shares[i] = std::min(by_file[i].size(), std::max<size_t>(size_t(exact), by_file[i].empty() ? 0 : 1));
    given += shares[i];
    remainders.push_back({exact - double(shares[i]), i});
  }
  std::stable_sort(remainders.begin(), remainders.end(), [](auto& a, auto& b) { return a.first > b.first; });
  // The least share of one can make the sum too large; then the largest shares are reduced.
  while (given > count) {
    auto largest = std::max_element(shares.begin(), shares.end());
    --*largest, --given;
  }
  for (bool more = true; given < count && more;) {
    more = false;
    for (auto& [rest, i] : remainders)
      if (given < count && shares[i] < by_file[i].size()) ++shares[i], ++given, more = true;
  }
  return shares;
}

std::vector<Mutant> drawFrom(const std::vector<Mutant>& mutants, size_t share, std::mt19937_64& random) {
  std::map<MutationOperator, std::vector<Mutant>> by_operator;
  for (const Mutant& mutant : mutants) by_operator[mutant.op].push_back(mutant);
  std::vector<std::vector<Mutant>> turns;
  for (auto& [op, list] : by_operator) {
    shuffle(list, random);
    turns.push_back(list);
  }
  shuffle(turns, random);
  std::vector<Mutant> drawn, spare;
  std::set<size_t> places;
  for (bool more = true; more && drawn.size() < share;) {
    more = false;
    for (auto& list : turns) {
      if (list.empty() || drawn.size() == share) continue;
      more = true;
      Mutant mutant = list.back();
      list.pop_back();
      (places.insert(mutant.offset).second ? drawn : spare).push_back(mutant);
    }
  }
  for (size_t i = 0; i < spare.size() && drawn.size() < share; ++i) drawn.push_back(spare[i]);
  std::sort(drawn.begin(), drawn.end(), [](const Mutant& a, const Mutant& b) {
    return std::tie(a.offset, a.before, a.after) < std::tie(b.offset, b.before, b.after);
  });
  return drawn;
}

}  // namespace

std::set<std::string> unlikeArgumentsIn(const std::string& text) {
  static const std::set<std::string> qualifiers = {"in", "out", "inout", "const"};
  std::vector<Token> tokens = tokensOf(text);
  std::set<std::string> names;
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    bool structure = tokens[i].is("struct") && tokens[i + 2].is("{");
    bool function = tokens[i].kind == Token::Kind::Name && !kStatements.count(tokens[i].text) && tokens[i + 2].is("(");
    if (tokens[i + 1].kind != Token::Kind::Name || (!structure && !function)) continue;
    std::vector<std::string> types;  // "T a, U b" or "T a; U b;", and "T a, b;" of a structure
    bool fresh = true;
    for (int k = int(i) + 3; k < tokens[i + 2].partner && types.size() < 2; ++k) {
      const Token& token = tokens[size_t(k)];
      if (fresh && token.kind == Token::Kind::Name && !qualifiers.count(token.text))
        types.push_back(token.text), fresh = false;
      if (token.is(";") || (token.is(",") && function)) fresh = true;
      if (token.is(",") && structure) types.push_back(types.back());
    }
    if (types.size() == 2 && types[0] != types[1]) names.insert(tokens[i + 1].text);
  }
  return names;
}

std::vector<Mutant> mutantsOf(const std::string& file, const std::string& text, const Vocabulary& words) {
  return Finder(file, text, words).all();
}

std::string mutated(const std::string& text, const Mutant& mutant) {
  STROBE_ASSERT(text.compare(mutant.offset, mutant.before.size(), mutant.before) == 0, "{} is another text",
                mutant.file);
  return std::string(text).replace(mutant.offset, mutant.before.size(), mutant.after);
}

std::vector<Mutant> drawMutants(const std::vector<std::vector<Mutant>>& by_file, uint64_t seed, size_t count) {
  std::vector<size_t> shares = sharesOf(by_file, count);
  std::vector<Mutant> drawn;
  for (size_t i = 0; i < by_file.size(); ++i) {
    if (by_file[i].empty()) continue;
    // One generator per file: a change in one file does not change the draws of other files.
    std::mt19937_64 random(seed * 0x9e3779b97f4a7c15u +
                           std::stoull(hashText(by_file[i].front().file).substr(0, 16), nullptr, 16));
    for (Mutant& mutant : drawFrom(by_file[i], shares[i], random)) drawn.push_back(std::move(mutant));
  }
  return drawn;
}

}  // namespace strobe::mutate
