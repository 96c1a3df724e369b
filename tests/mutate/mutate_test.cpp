// SPDX-License-Identifier: MIT
// The operators on short texts, the random draw, and a run of the program on a mutant that a test catches.
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

// Texts that an operator makes from a text.
std::set<std::string> made(const std::string& text, MutationOperator op) {
  std::set<std::string> texts;
  for (const Mutant& mutant : mutantsIn(text))
    if (mutant.op == op) texts.insert(mutated(text, mutant));
  return texts;
}

using Texts = std::set<std::string>;
using enum MutationOperator;

// An example for each operator.
TEST(Mutants, FollowTheirOperators) {
  EXPECT_EQ(made("x -= -f(a) - b;", Sign), (Texts{"x += -f(a) - b;", "x -= f(a) - b;", "x -= -f(a) + b;"}));
  EXPECT_EQ(made("x = 1e-4;", Constant), (Texts{"x = 0.0;", "x = 0.0002;"}));
  EXPECT_EQ(made("b = x < y << z;", Comparison), (Texts{"b = x <= y << z;", "b = x > y << z;"}));
  EXPECT_EQ(made("for (int i = 0; i < n; ++i) f();", OffByOne), (Texts{"for (int i = 0; i <= n; ++i) f();"}));
  EXPECT_EQ(made("x = f(g(p, q), r) + unlike(e, f);", SwappedOperands),
            (Texts{"x = f(r, g(p, q)) + unlike(e, f);", "x = f(g(q, p), r) + unlike(e, f);"}));
  EXPECT_EQ(made("x = min(a, b);", Extremum), (Texts{"x = max(a, b);"}));
  EXPECT_EQ(made("if (a && b || c) f();", Connective), (Texts{"if (a || b || c) f();", "if (a && b && c) f();"}));
  EXPECT_EQ(made("x = clamp(a + b, 0.0, 1.0);", DroppedClamp), (Texts{"x = (a + b);"}));
  EXPECT_EQ(made("x = finite(a) + other(a);", DroppedSanitiser), (Texts{"x = float(a) + other(a);"}));
  EXPECT_TRUE(
      mutantsIn("layout(location = 0) in vec2 uv;\nstruct A { float x[2]; };\n// a + 1\n#define A (1 + 2)\n").empty());
}

// Every mutant of every shipped shader differs from it only at its place, outside comments.
TEST(Mutants, OfShadersDifferOnlyAtTheirPlace) {
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

TEST(Draw, TakesFromEveryFileAndOperator) {
  std::vector<Mutant> drawn = drawMutants(twoFiles(), 1, 8);
  ASSERT_EQ(drawn.size(), 8u);
  EXPECT_EQ(std::count_if(drawn.begin(), drawn.end(), [](const Mutant& mutant) { return mutant.file == "small"; }), 1);
  std::set<MutationOperator> operators;
  for (const Mutant& mutant : drawn) operators.insert(mutant.op);
  EXPECT_GE(operators.size(), 5u);  // max( has two mutants at one place
  EXPECT_EQ(drawMutants(twoFiles(), 1, 1000).size(), twoFiles()[0].size() + 2);
}

// Distinguishes mutants with equal code, different code and invalid GLSL.
TEST(ShaderCodeOfPasses, ClassifiesMutants) {
  ShaderCode code(home());
  auto change = [&](const std::string& file, const std::string& before, const std::string& after) {
    size_t at = readText(home().shipped() / "shaders" / file).find(before);
    EXPECT_NE(at, std::string::npos);
    return code.changeBy({file, Sign, at, 1, 1, before, after});
  };
  EXPECT_EQ(change("mask/moving.glsl", "vec4(", "vec4 ("), CodeChange::Same);
  EXPECT_EQ(change("mask/moving.glsl", "1 : 0", "0 : 1"), CodeChange::Different);
  EXPECT_EQ(change("mask/moving.glsl", "vec4(", "vec9("), CodeChange::Refused);
  EXPECT_EQ(change("backend/miss.glsl", "NO_INSTANCE", "0u"), CodeChange::Different);  // used by one backend only
}

// Runs the program: a filter's test catches a tap on the wrong side, and a known result is not computed again.
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
