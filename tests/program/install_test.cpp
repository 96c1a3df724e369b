// SPDX-License-Identifier: MIT
// `cmake --install`: the installed program reads its installed files, and the shell completes its commands.
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "base/json.h"
#include "common/all_cases.h"
#include "program/run.h"

namespace strobe::testing {
namespace install_test {

class Installed : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    std::string build = fs::path(programPath()).parent_path();
    Outcome installed = runLine("cmake --install '" + build + "' --prefix '" + prefix().string() + "'");
    ASSERT_EQ(installed.exit_code, 0) << installed.err;
    Outcome made = strobeIn(folder_->path(), "new mine");
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static fs::path prefix() { return folder_->path() / "prefix"; }
  static fs::path project() { return folder_->path() / "mine"; }
  static fs::path shipped() { return prefix() / "share/strobe"; }

  // Runs a shell line with the installed program as `strobe` and without environment variables for Strobe's folders.
  static Outcome lineIn(const fs::path& folder, const std::string& line) {
    return runLine("unset STROBE_HOME STROBE_PROGRAM STROBE_DATA; export STROBE_VALIDATION=1 PATH='" +
                   (prefix() / "bin").string() + "':\"$PATH\"; cd '" + folder.string() + "' && " + line);
  }
  static Outcome strobeIn(const fs::path& folder, const std::string& arguments) {
    return lineIn(folder, "strobe " + arguments);
  }

  static std::unique_ptr<TemporaryFolder> folder_;
};

std::unique_ptr<TemporaryFolder> Installed::folder_;

TEST_F(Installed, ReadsItsOwnFiles) {
  Json found = Json::parse(strobeIn(project(), "doctor --json").out);
  EXPECT_EQ(found["files"], Json({fs::canonical(project()), fs::canonical(shipped())}));
  for (const auto& entry : fs::recursive_directory_iterator(prefix()))
    EXPECT_TRUE(fs::exists(entry.path())) << entry.path() << " has no target";
  EXPECT_NE(contentOf(project() / ".luarc.json").find(shipped().string()), std::string::npos);

  // The program finds a file that only the installation has, and does not find a file that only the sources have.
  fs::rename(shipped() / "scripts/pipelines/ue4.lua", shipped() / "scripts/pipelines/renamed.lua");
  EXPECT_EQ(strobeIn(folder_->path(), "plan renamed").exit_code, 0);
  EXPECT_NE(strobeIn(folder_->path(), "plan ue4").err.find("unknown pipeline 'ue4'"), std::string::npos);
  fs::rename(shipped() / "scripts/pipelines/renamed.lua", shipped() / "scripts/pipelines/ue4.lua");
}

TEST_F(Installed, RendersAndChecks) {
  auto written = [] { return std::distance(fs::recursive_directory_iterator(prefix()), {}); };
  auto before = written();
  Outcome drawn = strobeIn(project(), "render smear --scene oracles/bar --size 32x18");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  Json record = Json::parse(contentOf(project() / "out/smear.record.json"));
  std::string files = record.dump();
  for (const char* file :
       {"project:pipelines/smear.lua", "strobe:passes/gbuffer/gbuffer.lua", "strobe:scripts/scenes/oracles/bar.lua"})
    EXPECT_NE(files.find("\"" + std::string(file) + "\""), std::string::npos) << file;
  Outcome sound = strobeIn(project(), "check smear none");
  EXPECT_EQ(sound.exit_code, 0) << sound.err;
  EXPECT_EQ(strobeIn(folder_->path(), "help none").exit_code, 0);
  Outcome listed = strobeIn(folder_->path(), "sweep scripts/captures/demo.lua --dry-run");
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  EXPECT_EQ(written(), before) << "the program wrote to its installation folder";
}

// Pipelines of experiments are found from any current folder.
TEST_F(Installed, ChecksItsExperimentsFromAnyFolder) {
  std::string files;
  for (const auto& entry : fs::directory_iterator(shipped() / "experiments")) {
    const fs::path file = entry.path() / entry.path().filename().replace_extension(".lua");
    const bool is_project = fs::exists(entry.path() / "strobe.project.lua");
    if (fs::exists(file) && !is_project) files += " '" + file.string() + "'";
  }
  Outcome checked = strobeIn(folder_->path(), "check" + files);
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
}

// Some experiments are projects of their own inside experiments/.
TEST_F(Installed, ChecksProjectsAmongItsExperiments) {
  size_t projects = 0;
  for (const auto& entry : fs::directory_iterator(shipped() / "experiments")) {
    if (!fs::exists(entry.path() / "strobe.project.lua")) continue;
    ++projects;
    Outcome checked = strobeIn(entry.path(), "check");
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
  }
  EXPECT_GT(projects, 0u);
}

TEST_F(Installed, PackageHasTheSameFiles) {
  if (!allCases()) GTEST_SKIP() << "runs with --all";
  if (runLine("command -v cpack dpkg-deb").exit_code != 0) GTEST_SKIP() << "cpack or dpkg-deb is not installed";
  std::string build = fs::path(programPath()).parent_path(), out = folder_->path() / "package";
  Outcome made =
      runLine("cd '" + build + "' && cpack -G DEB -B '" + out + "' -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip && " +
              "dpkg-deb -x '" + out + "'/strobe_*.deb '" + out + "/files'");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  auto filesBelow = [](const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder));
    return names;
  };
  EXPECT_EQ(filesBelow(out + "/files/usr"), filesBelow(prefix()));
}

// Completions that bash offers for the end of a line, separated by spaces.
class Completion : public Installed {
 protected:
  static std::string of(const std::string& line) {
    std::string script = (prefix() / "share/bash-completion/completions/strobe").string();
    std::string shell = "source " + script +
                        "; COMP_WORDBREAKS=\" =\"; COMP_LINE=\"$1\"; COMP_POINT=${#1}; _strobe 2>/dev/null; "
                        "printf \"%s \" \"${COMPREPLY[@]}\"";
    return lineIn(project(), "bash --norc -c '" + shell + "' - '" + line + "'").out;
  }
};

TEST_F(Completion, CompletesCommandsOptionsAndChoices) {
  EXPECT_EQ(of("strobe re"), "render report ");
  EXPECT_EQ(of("strobe bench "), "reload frames slopes ");
  EXPECT_EQ(of("strobe render --an"), "--anchor --animation ");
  EXPECT_EQ(of("strobe render none --anchor c"), "centre ");
  EXPECT_EQ(of("strobe tune --cost f"), "frame ");
  EXPECT_EQ(of("strobe render none --anchor end -o "), " ") << "a file";
  EXPECT_EQ(of("strobe stability --invariant stil"), "still ");
}

TEST_F(Completion, CompletesNamesOfTheProject) {
  EXPECT_EQ(of("strobe render sm"), "smear ");
  EXPECT_EQ(of("strobe plan --json non"), "none ");
  EXPECT_EQ(of("strobe check none sm"), "smear ");
  EXPECT_EQ(of("strobe live --vs sm"), "smear ");
  EXPECT_EQ(of("strobe render none --scene oracles/b"), "oracles/bar ");
  EXPECT_EQ(of("strobe help smea"), "smear smear ") << "the pipeline and the pass";
}

TEST_F(Completion, CompletesParametersOfThePipeline) {
  EXPECT_EQ(of("strobe render smear --set t"), "taps= ");
  EXPECT_EQ(of("strobe render hybrid --set preset=geo"), "geometry_index ") << "after the = that ends a word in bash";
  EXPECT_EQ(of("strobe render hybrid --set edge=sil"), "silhouette ");
  EXPECT_EQ(of("strobe render nothing --set edge="), " ");
}

}  // namespace install_test
}  // namespace strobe::testing
