// SPDX-License-Identifier: MIT
#include "base/leftovers.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "base/process_name.h"
#include "common/temporary_folder.h"

namespace strobe {
namespace leftovers_test {

namespace fs = std::filesystem;

// Name of a process of this machine that has ended.
std::string goneProcess() {
  pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  const std::string here = processName();
  return here.substr(0, here.find('.') + 1) + std::to_string(child);
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

// Files of ended processes of this machine are removed. Files of running processes, other machines and other names
// stay.
TEST(Leftovers, OfEndedProcessesAreRemoved) {
  testing::TemporaryFolder folder;
  const std::string gone = goneProcess(), here = processName(), other = "elsewhere-0000.1";
  for (const std::string& name :
       {"room/a.png." + gone + ".part", "packs/a.zip." + gone + ".part.aB3d5f", ".recorded." + gone + "/0/passes/a.lua",
        ".inputs." + gone + "/0/passes/b.lua", ".inputs_12." + gone + "/x.lua"})
    write(folder.path() / name);
  const std::set<std::string> staying = {"room/a.png",
                                         "room/a.png." + here + ".part",
                                         ".recorded." + here + "/0/a.lua",
                                         "movie.mp4.part",
                                         "a." + gone + ".png",
                                         ".inputs_own/a.lua",
                                         ".recorded/a.lua",
                                         "room/b.png." + other + ".part",
                                         ".inputs." + other + "/a.lua"};
  for (const std::string& name : staying) write(folder.path() / name);
  removeLeftovers(folder.path());
  EXPECT_EQ(filesIn(folder.path()), staying);
  EXPECT_FALSE(fs::exists(folder.path() / (".inputs." + gone)));
  removeLeftovers(folder.path() / "no such folder");
}

TEST(Leftovers, OfOneFileAreRemovedAlone) {
  testing::TemporaryFolder folder;
  const std::string gone = goneProcess();
  for (const std::string& name : {"x.png." + gone + ".part", "x.record.json." + gone + ".part",
                                  "other.png." + gone + ".part", std::string("x.png")})
    write(folder.path() / name);
  removeLeftovers(folder.path(), "x.");
  EXPECT_EQ(filesIn(folder.path()), (std::set<std::string>{"x.png", "other.png." + gone + ".part"}));
}

}  // namespace leftovers_test
}  // namespace strobe
