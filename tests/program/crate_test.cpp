// SPDX-License-Identifier: MIT
// tools/crate.py: the crate of a manifest. Files that were not copied, scenes, names as URIs, version and date.
#include <gtest/gtest.h>

#include "base/json.h"
#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace crate_test {

Json manifestJson() {
  return Json::parse(R"({
    "format": "strobe.manifest", "format_version": 1,
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
    writeText(folder_ / "manifest.json", manifestJson().dump());
    writeText(folder_ / "SHA256SUMS", std::string(64, '0') + "  inputs/capture/a b.lua\n");
  }
  Outcome write(const std::string& environment) const {
    return runLine("exec env " + environment + " python3 '" + (sourceFolder() / "tools/crate.py").string() + "' '" +
                   folder_.path().string() + "'");
  }
  Json crate(const std::string& environment = "SOURCE_DATE_EPOCH=1595116801") const {
    Outcome written = write(environment);
    EXPECT_EQ(written.exit_code, 0) << written.err;
    return Json::parse(contentOf(folder_ / "ro-crate-metadata.json"), nullptr, false);
  }
  Json entity(const std::string& id, const std::string& environment = "SOURCE_DATE_EPOCH=1595116801") const {
    const Json all = crate(environment);
    for (const Json& one : all["@graph"])
      if (one["@id"] == id) return one;
    ADD_FAILURE() << "no " << id << " in " << all.dump(1);
    return Json::object();
  }
  std::string dayAt(const std::string& seconds) const {
    return entity("./", "SOURCE_DATE_EPOCH=" + seconds)["datePublished"];
  }
  bool links(const std::string& from, const char* property, const std::string& to) const {
    const Json source = entity(from);
    for (const Json& one : source.at(property))
      if (one["@id"] == to) return true;
    return false;
  }

  TemporaryFolder folder_;
};

TEST_F(CrateOfManifest, UncopiedFilesAreNotParts) {
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

TEST_F(CrateOfManifest, PicturesNameScenesWithAKnownAuthor) {
  Json scene = entity(entity("pictures/room.x.png")["isBasedOn"]["@id"].get<std::string>());
  EXPECT_EQ(scene["name"], "A room");
  EXPECT_EQ(scene["author"], "Author");
  EXPECT_EQ(scene["license"], "CC BY 4.0");
  EXPECT_EQ(scene["url"], "https://example.org/");
  EXPECT_EQ(scene["description"], "2020 Author\nMore\nlines");
  EXPECT_FALSE(entity("pictures/bare.x.png").contains("isBasedOn"));
}

TEST_F(CrateOfManifest, DescribesTheRun) {
  EXPECT_EQ(entity("#strobe")["softwareVersion"], "0.1.0+abc.modified");
  EXPECT_EQ(entity("#capture")["description"], "strobe capture capture:a b.lua --size 64x36\nDrawn by Device, Driver");
  EXPECT_EQ(entity("./")["description"].get<std::string>().substr(0, 15), "A note. A captu");
  EXPECT_EQ(entity("./")["datePublished"], "2020-07-19");
}

TEST_F(CrateOfManifest, DateIsOfTheEnvironmentInUtc) {
  EXPECT_EQ(dayAt("0"), "1970-01-01");
  EXPECT_EQ(dayAt("86399"), "1970-01-01");
  EXPECT_EQ(dayAt("951782400"), "2000-02-29");
  EXPECT_EQ(dayAt("253402300799"), "9999-12-31");
  for (const char* wrong : {"", "-1", "1.5", " 1", "1 ", "253402300800", "99999999999999999999"})
    EXPECT_EQ(write(fmt::format("'SOURCE_DATE_EPOCH={}'", wrong)).exit_code, 1) << wrong;
}

TEST_F(CrateOfManifest, DateIsTheEpochIfTheRevisionIsUnknown) {
  EXPECT_EQ(entity("./", "-u SOURCE_DATE_EPOCH")["datePublished"], "1970-01-01");
}

TEST_F(CrateOfManifest, OtherFilesAreRefused) {
  writeText(folder_ / "manifest.json", "{}");
  Outcome refused = write("");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("manifest.json: is not a manifest of a capture"), std::string::npos) << refused.err;
}

}  // namespace crate_test
}  // namespace strobe::testing
