// SPDX-License-Identifier: MIT
#include "study/point_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "common/temporary_folder.h"

namespace strobe::study {
namespace point_files_test {

namespace fs = std::filesystem;

std::string numbers(const std::string& key) { return "points/" + key + ".json"; }

class PointFilesTest : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    writeFileAtomically(folder_ / name, std::string_view(text), Flush::no);
  }
  std::vector<Path> packs() const {
    std::vector<Path> packs;
    for (const std::string& name : namesIn(folder_ / kPacks, ".zip"))
      packs.push_back(folder_.path() / kPacks / (name + ".zip"));
    return packs;
  }
  // Packs two points; one point has a picture.
  void writePack() {
    write("points/a.json", "a"), write("points/a.png", std::string("\0picture", 8)), write("points/b.json", "");
    write("points/b.exr", "linear"), write("points/b.record.json", "{}");
    PointFiles(folder_.path()).pack({"a", "b", "absent"});
  }

  testing::TemporaryFolder folder_;
};

TEST_F(PointFilesTest, ReadsPacksLikeSingleFiles) {
  const PointFiles before(folder_.path());
  EXPECT_FALSE(before.has(numbers("a")));
  writePack();
  ASSERT_EQ(packs().size(), 1u);
  EXPECT_FALSE(fs::exists(folder_ / numbers("a")));
  EXPECT_TRUE(fs::exists(folder_ / "points/b.exr")) << "is not packed";
  write("points/c.json", "single");
  const PointFiles after(folder_.path());
  for (const PointFiles* files : {&before, &after}) {
    EXPECT_EQ(files->read(numbers("a")), "a");
    EXPECT_EQ(files->read("points/a.png"), std::string("\0picture", 8));
    EXPECT_EQ(files->read(numbers("b")), "");
    EXPECT_EQ(files->read(numbers("c")), "single");
    EXPECT_EQ(files->read(numbers("absent")), std::nullopt);
    EXPECT_TRUE(files->has("points/a.png"));
    EXPECT_EQ(files->keys(), (std::vector<std::string>{"a", "b", "c"}));
  }
}

// A point that is measured again is a separate file and overrides the packed point.
TEST_F(PointFilesTest, PrefersSingleFiles) {
  writePack();
  write(numbers("a"), "again");
  PointFiles files(folder_.path());
  files.pack({"a", "b"});
  EXPECT_EQ(packs().size(), 1u);
  EXPECT_EQ(files.read(numbers("a")), "again");
  EXPECT_EQ(files.keys().size(), 2u);
}

// Packs of other shares stay closed, unless the shares have another number.
TEST_F(PointFilesTest, OpensPacksOfItsShare) {
  for (const char* share : {"1of2", "2of2", "1of3", ""}) {
    write(numbers("a" + std::string(share)), share);
    PointFiles files(folder_.path());
    files.share = share;
    files.pack({"a" + std::string(share)});
    EXPECT_EQ(files.read(numbers("a" + std::string(share))), share) << "finds its own pack";
  }
  EXPECT_EQ(packs().size(), 4u);
  EXPECT_EQ(PointFiles(folder_.path()).keys().size(), 4u);
  PointFiles files(folder_.path());
  files.share = "2of2";
  EXPECT_EQ(files.keys(), (std::vector<std::string>{"a", "a1of3", "a2of2"}));
}

TEST_F(PointFilesTest, CountsDamagedPacksAsMissing) {
  writePack();
  const std::string whole = readText(packs()[0]);
  for (size_t length : {size_t(0), size_t(10), whole.size() - 5}) {
    writeFileAtomically(packs()[0], std::string_view(whole).substr(0, length), Flush::no);
    PointFiles files(folder_.path());
    EXPECT_EQ(files.read(numbers("a")), std::nullopt);
    EXPECT_EQ(files.takeDamaged(), packs()) << length;
    EXPECT_TRUE(files.takeDamaged().empty());
  }
  std::string altered = whole;
  altered[whole.find("picture")] = 'P';
  writeFileAtomically(packs()[0], std::string_view(altered), Flush::no);
  const PointFiles files(folder_.path());
  EXPECT_EQ(files.read("points/a.png"), std::nullopt) << "the data differ from their checksum";
  EXPECT_FALSE(files.has("points/a.png"));
  EXPECT_EQ(files.read(numbers("a")), "a");
}

TEST_F(PointFilesTest, KeepsSingleFilesIfThePackCannotBeWritten) {
  write(kPacks, "a file in place of the folder");
  write(numbers("a"), "a");
  PointFiles files(folder_.path());
  files.pack({"a"});
  EXPECT_EQ(files.read(numbers("a")), "a");
}

}  // namespace point_files_test
}  // namespace strobe::study
