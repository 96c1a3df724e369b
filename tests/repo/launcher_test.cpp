// SPDX-License-Identifier: MIT
// Decisions of the launcher, with its functions loaded into a shell: nothing is installed or built.
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/process.h"
#include "common/home.h"

namespace strobe::repo {
namespace launcher_test {

struct Outcome {
  int code = -1;
  std::string text;  // output and errors
};

// Runs `script` after loading the launcher.
Outcome launcher(const std::string& script) {
  std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();  // tests may run side by side
  std::string file = ::testing::TempDir() + "launcher_" + test + ".sh";
  writeFileAtomically(file, "source '" + (home().shipped() / "strobe").string() + "'; " + script);
  ProgramEnd end = run({.arguments = {"bash", file}, .errors = Program::Errors::with_output});
  std::filesystem::remove(file);
  return {end.code(), end.output};
}

std::string written(const std::string& name, const std::string& text) {
  std::string file = ::testing::TempDir() + name;
  writeFileAtomically(file, text);
  return file;
}

TEST(Launcher, AddsASuiteAsAOneLineEntry) {
  std::string file = written("machine.list",
                             "# comment\n"
                             "deb http://mirror/debian trixie main contrib\n"
                             "deb [arch=amd64 signed-by=/keys/a.gpg] http://mirror/debian/ trixie main # ours\n");
  EXPECT_EQ(launcher("entry_for '" + file + ":2' new").text, "deb http://mirror/debian new main\n");
  EXPECT_EQ(launcher("entry_for '" + file + ":3' new").text,
            "deb [arch=amd64 signed-by=/keys/a.gpg] http://mirror/debian/ new main\n");
}

TEST(Launcher, AddsASuiteAsAStanza) {
  std::string file = written("machine.sources",
                             "# the first\n"
                             "Types: deb\nURIs: http://other/\nSuites: x\nComponents: main\n"
                             "\n"
                             "Types: deb deb-src\n# comment\nURIs: http://mirror/debian\n"
                             "Suites: trixie\n trixie-updates\nComponents: main contrib\n"
                             "Signed-By:\n -----BEGIN\n .\n key\n");
  EXPECT_EQ(
      launcher("entry_for '" + file + ":2' new").text,
      "Types: deb\nURIs: http://mirror/debian\nSuites: new\nComponents: main\nSigned-By:\n -----BEGIN\n .\n key\n");
  EXPECT_EQ(launcher("entry_for '" + file + ":1' new").text,
            "Types: deb\nURIs: http://other/\nSuites: new\nComponents: main\n");
}

// A device suffices if it has acceleration structures and a way to trace; two devices with one half each do not.
TEST(Launcher, RecognisesASufficientDevice) {
  auto code = [](const std::string& lines) {
    return launcher("vulkaninfo() { printf '" + lines + "'; }; device_suffices").code;
  };
  std::string structure = "\\tVK_KHR_acceleration_structure : extension revision 13\\n";
  std::string query = "\\tVK_KHR_ray_query : extension revision 1\\n";
  std::string pipeline = "\\tVK_KHR_ray_tracing_pipeline : extension revision 1\\n";
  EXPECT_EQ(code("GPU0:\\n" + structure + query), 0);
  EXPECT_EQ(code("GPU0:\\nGPU1:\\n" + structure + pipeline), 0);
  EXPECT_EQ(code("GPU0:\\n" + structure), 1);
  EXPECT_EQ(code("GPU0:\\n" + structure + "GPU1:\\n" + query), 1);
  EXPECT_EQ(code(""), 1);
  EXPECT_EQ(launcher("vulkaninfo() { return 1; }; device_suffices").code, 1);
}

TEST(Launcher, ListsNeededPackagesWithoutApt) {
  Outcome outcome = launcher(
      "command() { [[ $2 != apt-get ]] && builtin command \"$@\"; }; build=/nowhere; packages build; echo went on");
  EXPECT_EQ(outcome.code, 1);
  for (const char* part : {"g++", "libvulkan-dev", "mesa-vulkan-drivers", "--no-install"}) {
    EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
  }
  EXPECT_EQ(outcome.text.find("went on"), std::string::npos) << outcome.text;
}

// A test that did not finish does not count as passed.
TEST(Launcher, CountsTests) {
  std::string first = written("first.txt", "tests 2\npassed A.B 0.100\nskipped A.C 0.000 no display\n");
  std::string second = written("second.txt", "tests 3\npassed D.E 0.100\nfailed D.F/0 0.100\n");
  EXPECT_EQ(launcher("summary '" + first + "' '" + second + "'").text,
            "  skipped: A.C: no display\n  failed: D.F/0\n  second ended after 2 of 3 tests\n"
            "4 tests in 2 processes: 2 passed, 1 skipped, 1 failed\n"
            "long suites ran a part of their cases; ./strobe test --all runs all\n");
}

TEST(Launcher, LooksForPackagesOncePerList) {
  std::string stubs =
      "install_missing() { echo looked; }; install_driver() { :; }; build=\"$(mktemp -d)\"; "
      "packages build; packages build; build_packages+=(another); packages build; rm -r \"$build\"";
  EXPECT_EQ(launcher(stubs).text, "looked\nlooked\n");
}

TEST(Launcher, InstallsOnlyWhatIsMissingAndOffered) {
  std::string stubs =
      "installed() { [[ $1 == here ]]; }; offered() { [[ $1 != unknown ]]; }; "
      "apt_get() { echo \"apt: $*\"; }; dpkg-query() { :; }; say() { :; }; ";
  EXPECT_EQ(launcher(stubs + "install_missing all here").text, "");
  EXPECT_EQ(launcher(stubs + "install_missing some here there unknown").text,
            "apt: update\napt: install --no-install-recommends there\n");
  EXPECT_EQ(launcher(stubs + "install_missing all unknown").text,
            "apt: update\napt: install --no-install-recommends unknown\n");
}

// If Mesa is from backports, its other packages must be from backports too.
TEST(Launcher, PinsPackagesFromBackports) {
  std::string stubs =
      "dpkg-query() { printf 'mesa 25.0.7-2~bpo12+1 installed\\nbash 5.2 installed\\nold 1~bpo12 config-files\\n'; }; "
      "apt_get() { echo \"${@:3}\"; cat \"${2#*=}\"; }; ";
  EXPECT_EQ(launcher(stubs + "install_packages thing").text,
            "install --no-install-recommends thing\n"
            "\nPackage: src:mesa \nPin: release n=*-backports\nPin-Priority: 990\n");
}

TEST(Launcher, AddsBackportsOnlyIfNeededAndMissing) {
  std::string stubs =
      "apt_get() { echo \"apt: $*\"; }; as_root() { echo \"root: $*\" >&2; cat >&2; }; say() { :; }; "
      "apt-get() { printf \"$known\"; }; entry_for() { echo \"entry: $*\"; }; ";
  std::string release = "Packages|http://mirror/debian/|r|r|/etc/apt/sources.list:1\\n";
  std::string there = "Packages|http://mirror/debian/|r-backports|r-backports|/etc/apt/sources.list:2\\n";
  EXPECT_EQ(launcher(stubs + "known='" + release + there + "'; add_backports r").text, "apt: update\n");
  EXPECT_EQ(launcher(stubs + "known='" + release + "'; add_backports r").text,
            "apt: update\n"
            "root: tee /etc/apt/sources.list.d/strobe-backports.list\n"
            "entry: /etc/apt/sources.list:1 r-backports\n"
            "apt: update\n");
  EXPECT_EQ(launcher("device_suffices() { true; }; apt_get() { echo called; }; install_driver").text, "");
  Outcome none = launcher(stubs + "known=''; add_backports r; echo went on");
  EXPECT_EQ(none.code, 1);
  EXPECT_EQ(none.text, "apt: update\n");
}

}  // namespace launcher_test
}  // namespace strobe::repo
