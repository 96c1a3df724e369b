// SPDX-License-Identifier: MIT
// The operators on small texts, the draw, and the run from outside on a mutant that is known to be caught.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <set>

#include "base/error.h"
#include "common/home.h"
#include "mutate/glsl.h"
#include "mutate/mutants.h"
#include "mutate/run.h"
#include "mutate/shader_code.h"

namespace strobe::mutate {
namespace mutate_test {

std::vector<Mutant> mutantsIn(const std::string& text) {
  return mutantsOf("a.glsl", text, {{{"finite", "float"}}, {"unlike"}});
}

// What an operator makes of a text.
std::set<std::string> made(const std::string& text, MutationOperator op) {
  std::set<std::string> texts;
  for (const Mutant& mutant : mutantsIn(text))
    if (mutant.op == op) texts.insert(mutated(text, mutant));
  return texts;
}

using Texts = std::set<std::string>;
using enum MutationOperator;

std::string joinedTokens(const std::string& text) {
  std::string joined;
  for (const Token& token : tokensOf(text)) joined += (joined.empty() ? "" : " ") + token.text;
  return joined;
}

TEST(GlslTokens, AreNamesNumbersAndSigns) {
  EXPECT_EQ(joinedTokens("a<=b<<2u&&c.x-=-1.5e-4;"), "a <= b << 2u && c . x -= - 1.5e-4 ;");
  EXPECT_EQ(joinedTokens("f(.5, 0x7fu+1, 1e5)"), "f ( .5 , 0x7fu + 1 , 1e5 )");
}

TEST(GlslTokens, LeaveOutCommentsAndPreprocessor) {
  EXPECT_EQ(joinedTokens("a; // b + 1\n/* c\n - 2 */ d;\n  #if E > 1 \\\n && F\ng;\n#endif"), "a ; d ; g ;");
}

TEST(GlslTokens, KnowTheirPlaces) {
  std::string text = "a;\n  b = 1;\n";
  EXPECT_EQ(placeOf(text, text.find('1')).line, 2);
  EXPECT_EQ(placeOf(text, text.find('1')).column, 7);
  EXPECT_EQ(lineAt(text, text.find('1')), "b = 1;");
  EXPECT_EQ(lineAt(text, 0), "a;");
}

TEST(Mutants, Sign) {
  EXPECT_EQ(made("x = a + b;", Sign), (Texts{"x = a - b;"}));
  EXPECT_EQ(made("x -= -f(a) - b;", Sign), (Texts{"x += -f(a) - b;", "x -= f(a) - b;", "x -= -f(a) + b;"}));
  EXPECT_EQ(made("return -a;", Sign), (Texts{"return a;"}));
  EXPECT_EQ(made("for (int i = 0; i < n; ++i) ++k;", Sign), (Texts{"for (int i = 0; i < n; ++i) --k;"}));
}

TEST(Mutants, Constant) {
  EXPECT_EQ(made("x = 0;", Constant), (Texts{"x = 1;"}));
  EXPECT_EQ(made("x = 1.0;", Constant), (Texts{"x = 0.0;", "x = 2.0;"}));
  EXPECT_EQ(made("x = 1e-4;", Constant), (Texts{"x = 0.0;", "x = 0.0002;"}));
  EXPECT_EQ(made("x = 6.1e-5;", Constant), (Texts{"x = 0.0;", "x = 0.000122;"}));
  EXPECT_EQ(made("x = 8u;", Constant), (Texts{"x = 0u;", "x = 16u;"}));
  EXPECT_EQ(made("x = 0x7f800000u;", Constant), (Texts{"x = 0u;"}));
}

TEST(Mutants, Comparison) {
  EXPECT_EQ(made("b = x < y;", Comparison), (Texts{"b = x <= y;", "b = x > y;"}));
  EXPECT_EQ(made("b = x >= y;", Comparison), (Texts{"b = x > y;", "b = x <= y;"}));
  EXPECT_EQ(made("b = x == y;", Comparison), (Texts{"b = x != y;"}));
  EXPECT_EQ(made("b = x << y;", Comparison), (Texts{}));
}

TEST(Mutants, OffByOne) {
  EXPECT_EQ(made("x = a[i];", OffByOne), (Texts{"x = a[i + 1];"}));
  EXPECT_EQ(made("for (int i = 0; i < n; ++i) f();", OffByOne), (Texts{"for (int i = 0; i <= n; ++i) f();"}));
  EXPECT_EQ(made("for (int i = 0; i <= n; ++i) f();", OffByOne), (Texts{"for (int i = 0; i < n; ++i) f();"}));
  EXPECT_EQ(made("x = size - 1;", OffByOne), (Texts{"x = size ;"}));
  EXPECT_EQ(made("x = 2 * (n + 1u);", OffByOne), (Texts{"x = 2 * (n );"}));
  EXPECT_EQ(made("x = a - 1 * b;", OffByOne), (Texts{}));
}

TEST(Mutants, SwappedOperands) {
  EXPECT_EQ(made("x = a - b * c;", SwappedOperands), (Texts{"x = b * c - a;"}));
  EXPECT_EQ(made("x = f(a).y / (b + c);", SwappedOperands), (Texts{"x = (b + c) / f(a).y;"}));
  EXPECT_EQ(made("x = a[i] - b - c;", SwappedOperands), (Texts{"x = b - a[i] - c;"}));
  EXPECT_EQ(made("x = mix(a, b, t);", SwappedOperands), (Texts{"x = mix(b, a, t);"}));
  EXPECT_EQ(made("x = f(g(p, q), r) + h(s);", SwappedOperands),
            (Texts{"x = f(r, g(p, q)) + h(s);", "x = f(g(q, p), r) + h(s);"}));
  EXPECT_EQ(made("x = min(a, b) + dot(c, d) + unlike(e, f) + texelFetch(g, h, 0);", SwappedOperands), (Texts{}));
  EXPECT_EQ(made("float f(float a, float b) { return a; }", SwappedOperands), (Texts{}));
}

TEST(Mutants, ExtremaAndConnectives) {
  EXPECT_EQ(made("x = min(a, b);", Extremum), (Texts{"x = max(a, b);"}));
  EXPECT_EQ(made("if (a && b || c) f();", Connective), (Texts{"if (a || b || c) f();", "if (a && b && c) f();"}));
}

TEST(Mutants, DroppedClamps) {
  EXPECT_EQ(made("x = clamp(a + b, 0.0, 1.0);", DroppedClamp), (Texts{"x = (a + b);"}));
  EXPECT_EQ(made("x = max(a, 1e-3) + max(vec2(0), b);", DroppedClamp),
            (Texts{"x = (a) + max(vec2(0), b);", "x = max(a, 1e-3) + (b);"}));
  EXPECT_EQ(made("x = finite(a) + other(a);", DroppedSanitiser), (Texts{"x = float(a) + other(a);"}));
}

TEST(Mutants, LeaveDeclarationsAlone) {
  EXPECT_TRUE(mutantsIn("layout(location = 0, std430) in vec2 uv;\nstruct A { float x[2]; };\nfloat y[3];\n").empty());
  EXPECT_TRUE(mutantsIn("// a + 1 < 2 && max(b, 0)\n#define A (1 + 2)\n/* - 1 */\n").empty());
}

TEST(Mutants, UnlikeArgumentsAreFound) {
  std::string text =
      "struct A { vec3 c; float d; };\nstruct B { uint a, b; float c; };\nfloat f(in float a, float b);\n"
      "int g(int a, const float b) { return h(a, b); }\n";
  EXPECT_EQ(unlikeArgumentsIn(text), (std::set<std::string>{"A", "g"}));
}

// Every mutant of every shader that ships differs from it in its own place alone, outside of comments.
TEST(Mutants, OfTheShadersDifferInTheirPlaceAlone) {
  const Path shaders = home().shipped() / "shaders";
  size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shaders)) {
    if (entry.path().extension() != ".glsl") continue;
    std::string text = readText(entry.path());
    for (const Mutant& mutant : mutantsOf(entry.path().lexically_relative(shaders), text)) {
      std::string changed = mutated(text, mutant);
      ASSERT_NE(changed, text);
      ASSERT_EQ(changed.substr(0, mutant.offset), text.substr(0, mutant.offset));
      ASSERT_EQ(changed.substr(mutant.offset + mutant.after.size()), text.substr(mutant.offset + mutant.before.size()));
      size_t line_start = text.rfind('\n', mutant.offset) + 1;
      std::string before = text.substr(line_start, mutant.offset - line_start);
      ASSERT_EQ(before.find("//"), std::string::npos) << mutant.file << ":" << mutant.line;
      ASSERT_FALSE(before.starts_with("#")) << mutant.file << ":" << mutant.line;
      ++count;
    }
  }
  EXPECT_GT(count, 2000u);
}

std::vector<std::vector<Mutant>> twoFiles() {
  return {mutantsOf("big", "x = a + b - c * 2 / d + max(e, f) - g[h] + (i < j ? 3 : 4);"),
          mutantsOf("small", "y = 5;"),
          {}};
}

std::string textOf(const std::vector<Mutant>& mutants) {
  std::string text;
  for (const Mutant& mutant : mutants) text += fmt::format("{}:{}:{}\n", mutant.file, mutant.offset, mutant.after);
  return text;
}

TEST(Draw, IsTheSameForASeedAndAnotherForAnother) {
  EXPECT_EQ(textOf(drawMutants(twoFiles(), 1, 6)), textOf(drawMutants(twoFiles(), 1, 6)));
  EXPECT_NE(textOf(drawMutants(twoFiles(), 1, 6)), textOf(drawMutants(twoFiles(), 2, 6)));
}

TEST(Draw, TakesFromEveryFileAndOperator) {
  std::vector<Mutant> drawn = drawMutants(twoFiles(), 1, 8);
  ASSERT_EQ(drawn.size(), 8u);
  EXPECT_EQ(std::count_if(drawn.begin(), drawn.end(), [](const Mutant& mutant) { return mutant.file == "small"; }), 1);
  std::set<MutationOperator> operators;
  for (const Mutant& mutant : drawn) operators.insert(mutant.op);
  EXPECT_GE(operators.size(), 5u);  // max( offers two in one place
  EXPECT_EQ(drawMutants(twoFiles(), 1, 1000).size(), twoFiles()[0].size() + 2);
}

// A change that means nothing is told from one that does and from one that is no GLSL.
TEST(ShaderCodeOfPasses, TellsWhichMutantsMatter) {
  ShaderCode code(home());
  auto change = [&](const std::string& file, const std::string& before, const std::string& after) {
    size_t at = readText(home().shipped() / "shaders" / file).find(before);
    EXPECT_NE(at, std::string::npos);
    return code.changeBy({file, Sign, at, 1, 1, before, after});
  };
  EXPECT_EQ(change("mask/moving.glsl", "vec4(", "vec4 ("), CodeChange::Same);
  EXPECT_EQ(change("mask/moving.glsl", "1 : 0", "0 : 1"), CodeChange::Different);
  EXPECT_EQ(change("mask/moving.glsl", "vec4(", "vec9("), CodeChange::Refused);
  EXPECT_EQ(change("backend/miss.glsl", "NO_INSTANCE", "0u"), CodeChange::Different);  // reached by one backend alone
}

TEST(Reasons, BelongToALineAndItsMutant) {
  std::vector<MutationResult> results(2);
  for (auto& result : results)
    result = {{"a.glsl", Sign, 4, 1, 5, "+", "-"}, "x = a + b;", "x = a - b;", Fate::Survived, true};
  results[1].mutated_line = "x = a * b;";
  Path file = std::filesystem::temp_directory_path() / fmt::format("strobe_reasons_{}.json", ::getpid());
  writeFileAtomically(file,
                      R"([{"shader": "a.glsl", "line": "x = a + b;", "mutated": "x = a - b;", "reason": "b is 0"}])");
  giveReasons(results, file);
  std::filesystem::remove(file);
  EXPECT_EQ(results[0].reason, "b is 0");
  EXPECT_EQ(unexplained(results), 1);
  std::string page = pageOf(results, {});
  EXPECT_NE(page.find("b is 0"), std::string::npos);
  EXPECT_NE(page.find("no reason yet"), std::string::npos);
}

// From outside: a tap on the wrong side is noticed by a test of a filter, and what is known is not tried again.
TEST(MutationRun, CatchesAWrongSign) {
  const char* program = std::getenv("STROBE_PROGRAM");
  ASSERT_TRUE(program) << "STROBE_PROGRAM names the program";
  const std::string file = "lib/blur.glsl", test = "RenderFilters.OneSidedMcGuireReproducesItsRow";
  std::vector<Mutant> wanted;
  const std::string text = readText(home().shipped() / "shaders" / file);
  for (const Mutant& mutant : mutantsOf(file, text))
    if (mutant.op == Sign && lineAt(text, mutant.offset).starts_with("vec2 tapOffset")) wanted.push_back(mutant);
  ASSERT_EQ(wanted.size(), 1u);

  MutationPlan plan{{{"test_oracle", test}}, 60, {}};
  MutationOptions options;
  options.tests = {Path(program).parent_path() / "tests", program, home().data()};
  options.results = std::filesystem::temp_directory_path() / fmt::format("strobe_mutations_{}.json", ::getpid());
  ::testing::internal::CaptureStderr();
  std::vector<MutationResult> results = runMutants(home(), wanted, options, plan);
  ::testing::internal::GetCapturedStderr();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].fate, Fate::Caught);
  EXPECT_EQ(results[0].by, test);

  options.tests.folder = "nowhere";
  EXPECT_EQ(runMutants(home(), wanted, options, plan)[0].by, test);
  std::filesystem::remove(options.results);
}

}  // namespace mutate_test
}  // namespace strobe::mutate
