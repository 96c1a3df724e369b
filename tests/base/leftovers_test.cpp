// SPDX-License-Identifier: MIT
#include "base/leftovers.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "base/frozen_home.h"
#include "common/temporary_folder.h"

namespace strobe {
namespace leftovers_test {

namespace fs = std::filesystem;

pid_t goneProcess() {
  pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

void write(const Path& file) {
  fs::create_directories(file.parent_path());
  writeFileAtomically(file, std::string_view("x"), Flush::no);
}

std::set<std::string> filesIn(const Path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder).string());
  return names;
}

// Files of the dead go; those of the living, and what only looks like one, stay.
TEST(Leftovers, AreThoseOfProcessesThatAreGone) {
  testing::TemporaryFolder folder;
  const std::string gone = std::to_string(goneProcess()), here = std::to_string(::getpid());
  for (const std::string& name : {"room/a.png." + gone + ".part", ".recorded." + gone + "/0/passes/a.lua",
                                  std::string(".inputs_0/0/passes/b.lua"), std::string(".inputs_12/x.lua")})
    write(folder.path() / name);
  const std::set<std::string> staying = {
      "room/a.png",     "room/a.png." + here + ".part", ".recorded." + here + "/0/a.lua",
      "movie.mp4.part", "a." + gone + ".png",           ".inputs_own/a.lua",
      ".recorded/a.lua"};
  for (const std::string& name : staying) write(folder.path() / name);
  removeLeftovers(folder.path());
  EXPECT_EQ(filesIn(folder.path()), staying);
  EXPECT_FALSE(fs::exists(folder.path() / ".inputs_0"));
  removeLeftovers(folder.path() / "no such folder");
}

TEST(Leftovers, OfOneFileLeaveOthersAlone) {
  testing::TemporaryFolder folder;
  const std::string gone = std::to_string(goneProcess());
  for (const std::string& name : {"x.png." + gone + ".part", "x.record.json." + gone + ".part",
                                  "other.png." + gone + ".part", std::string("x.png")})
    write(folder.path() / name);
  removeLeftovers(folder.path(), "x.");
  EXPECT_EQ(filesIn(folder.path()), (std::set<std::string>{"x.png", "other.png." + gone + ".part"}));
}

// A copy of the home that another process draws from is not taken from it; that of a dead one is.
TEST(Leftovers, AFolderInUseIsRefused) {
  testing::TemporaryFolder folder;
  write(folder.path() / "home/passes/a.lua");
  const Home home(std::vector<Path>{folder.path() / "home"});
  {
    FrozenHome used(home, folder.path() / "out/.inputs");
    try {
      FrozenHome(home, folder.path() / "out/.inputs");
      ADD_FAILURE() << "the copy was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.exitCode(), 2);
      EXPECT_EQ(error.message(), "another process is using this folder");
    }
    EXPECT_TRUE(used.home().find("passes/a.lua"));
  }
  write(folder.path() / "out/.inputs/0/passes/old.lua");
  FrozenHome after(home, folder.path() / "out/.inputs");
  EXPECT_FALSE(after.home().find("passes/old.lua"));
}

}  // namespace leftovers_test
}  // namespace strobe
