// SPDX-License-Identifier: MIT
// The crate of a manifest: what was not copied, what is said of scenes, names as URIs, the version, the day.
#include "archive/crate.h"

#include <gtest/gtest.h>

#include "common/home.h"
#include "program/run.h"

namespace strobe::archive {
namespace crate_test {

using strobe::testing::TemporaryFolder;
using strobe::testing::writeText;

Json manifestJson() {
  return Json::parse(R"({
    "capture": { "file": "capture:a b.lua", "title": "Two", "size": [64, 36], "bundle": false, "note": "A note." },
    "program": { "version": "0.1.0", "program": "0", "revision": "abc", "modified": true },
    "device": { "name": "Device", "driver": "Driver" },
    "inputs": [ { "name": "capture:a b.lua", "sha256": "11", "bytes": 3 },
                { "name": "shared:room/wood 50%.jpg", "sha256": "22", "bytes": 4 } ],
    "pictures": [
      { "shot": "room", "images": { "png": "pictures/room.x.png" }, "record": { "scene": { "attribution": {
          "copyright": "2020 Author", "text": "More\nlines",
          "extras": { "title": "A room", "author": "Author", "license": "CC BY 4.0", "source": "https://example.org/" } } } } },
      { "shot": "bare", "images": { "png": "pictures/bare.x.png" }, "record": { "scene": {} } } ],
    "files": { "pictures/room.x.png": { "sha256": "33", "bytes": 5 }, "pictures/bare.x.png": { "sha256": "44", "bytes": 6 } }
  })");
}

class CrateOfManifest : public ::testing::Test {
 protected:
  CrateOfManifest() {
    writeText(folder_ / kManifestFile, "{}");
    crate_ = crateOf({folder_.path(), manifestJson()}, {"inputs/capture/a b.lua"}, "2020-07-19");
  }
  Json entity(const std::string& id) const {
    for (const Json& one : crate_["@graph"])
      if (one["@id"] == id) return one;
    ADD_FAILURE() << "no " << id << " in " << crate_.dump(1);
    return Json::object();
  }
  bool links(const std::string& from, const char* property, const std::string& to) const {
    const Json source = entity(from);
    for (const Json& one : source.at(property))
      if (one["@id"] == to) return true;
    return false;
  }

  TemporaryFolder folder_;
  Json crate_;
};

TEST_F(CrateOfManifest, WhatWasNotCopiedIsNoFileOfIt) {
  EXPECT_EQ(entity("inputs/capture/a%20b.lua")["@type"], "File");
  EXPECT_EQ(entity("inputs/capture/a%20b.lua")["description"], "The script of the capture");
  EXPECT_TRUE(links("./", "hasPart", "inputs/capture/a%20b.lua"));
  const std::string texture = "#inputs/shared/room/wood%2050%25.jpg";
  EXPECT_EQ(entity(texture)["@type"], "CreativeWork");
  EXPECT_EQ(entity(texture)["name"], "shared:room/wood 50%.jpg");
  EXPECT_EQ(entity(texture)["sha256"], "22");
  EXPECT_EQ(entity(texture)["encodingFormat"], "image/jpeg");
  EXPECT_FALSE(links("./", "hasPart", texture));
  EXPECT_TRUE(links("#capture", "object", texture));
}

TEST_F(CrateOfManifest, PicturesNameTheSceneWhoseAuthorIsKnown) {
  Json scene = entity(entity("pictures/room.x.png")["isBasedOn"]["@id"].get<std::string>());
  EXPECT_EQ(scene["name"], "A room");
  EXPECT_EQ(scene["author"], "Author");
  EXPECT_EQ(scene["license"], "CC BY 4.0");
  EXPECT_EQ(scene["url"], "https://example.org/");
  EXPECT_EQ(scene["description"], "2020 Author\nMore\nlines");
  EXPECT_FALSE(entity("pictures/bare.x.png").contains("isBasedOn"));
}

TEST_F(CrateOfManifest, SaysWhatRan) {
  EXPECT_EQ(entity("#strobe")["softwareVersion"], "0.1.0+abc.modified");
  EXPECT_EQ(entity("#capture")["description"], "strobe capture capture:a b.lua --size 64x36\nDrawn by Device, Driver");
  EXPECT_EQ(entity("./")["description"].get<std::string>().substr(0, 15), "A note. A captu");
  EXPECT_EQ(entity("./")["datePublished"], "2020-07-19");
}

// The variable stays as it was: other tests of this process may read it.
class Day : public ::testing::Test {
 protected:
  Day() {
    if (const char* value = std::getenv("SOURCE_DATE_EPOCH")) was_ = value;
  }
  ~Day() override {
    if (was_) ::setenv("SOURCE_DATE_EPOCH", was_->c_str(), 1);
    else ::unsetenv("SOURCE_DATE_EPOCH");
  }
  std::string dayAt(const char* seconds) const {
    ::setenv("SOURCE_DATE_EPOCH", seconds, 1);
    return crateDate(home());
  }
  std::optional<std::string> was_;
};

TEST_F(Day, IsThatOfTheEnvironmentInUtc) {
  EXPECT_EQ(dayAt("0"), "1970-01-01");
  EXPECT_EQ(dayAt("86399"), "1970-01-01");
  EXPECT_EQ(dayAt("951782400"), "2000-02-29");
  EXPECT_EQ(dayAt("253402300799"), "9999-12-31");
  for (const char* wrong : {"", "-1", "1.5", " 1", "1 ", "253402300800", "99999999999999999999"})
    EXPECT_THROW(dayAt(wrong), Error) << wrong;
}

TEST_F(Day, IsTheFirstOneWhereNothingIsKnown) {
  ::unsetenv("SOURCE_DATE_EPOCH");
  TemporaryFolder none;
  EXPECT_EQ(crateDate(Home(none.path())), "1970-01-01");
}

}  // namespace crate_test
}  // namespace strobe::archive
