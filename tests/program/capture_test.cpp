// SPDX-License-Identifier: MIT
// The commands `strobe capture`, `verify` and `diff`: the same bits under every disturbance, named differences,
// captures that are killed and continued, bundles and zips that verify elsewhere, the crate, and refusals.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <random>
#include <thread>

#include "base/hash.h"
#include "base/json.h"
#include "common/all_cases.h"
#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace capture_test {

const char* const kCapture = R"lua(
local capture = require "strobe.capture"
return capture {
  title = "Small", size = { 64, 36 },
  shots = {
    { name = "card", scene = "scene.lua", move = { card = { 0.6, 0, 0 } } },
    { name = "past", scene = "scene.lua", frames = { 0, 2, 1 },
      path = capture.dolly { from = { -0.2, 0, 2 }, to = { 0.2, 0, 2 }, target = { -0.2, 0, 0 }, to_target = { 0.2, 0, 0 },
                             first = 0, last = 2 } },
  },
  arms = { { name = "none", pipeline = "none" }, { name = "hybrid", pipeline = "hybrid_layered", shots = { "card" } } },
  figures = { { name = "both", shot = "card", columns = { { arm = "none" }, { arm = "hybrid" } } } },
}
)lua";

const char* const kQuiet = "STROBE_VALIDATION=0";

class Capture : public ::testing::Test {
 protected:
  Capture() {
    fs::create_directories(folder_.path() / "own");
    writeText(folder_ / "own/scene.lua", kCardScene);
    writeText(script_, kCapture);
  }
  std::string path(const std::string& name) const { return folder_ / name; }
  Outcome capture(const std::string& out, const std::string& more = "", const std::string& environment = kQuiet) const {
    return run("capture " + script_ + " -o " + path(out) + " " + more, environment);
  }
  Json manifest(const std::string& out) const { return Json::parse(contentOf(path(out + "/manifest.json"))); }
  // Hashes of all pictures and figures, by file name.
  std::map<std::string, std::string> images(const std::string& out) const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(path(out))) {
      std::string ending = entry.path().extension();
      if (ending == ".png" || ending == ".exr" || ending == ".pdf")
        found[entry.path().lexically_relative(path(out))] = sha256(contentOf(entry.path()));
    }
    return found;
  }
  // A copy of the home with editable shaders.
  std::string copiedHome() const {
    fs::create_directories(path("home"));
    for (const char* part : {"passes", "shaders", "scripts"})
      fs::copy(sourceFolder() / part, path("home/" + std::string(part)), fs::copy_options::recursive);
    return "STROBE_VALIDATION=0 STROBE_HOME=" + path("home");
  }
  void replaceIn(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = contentOf(path(file));
    size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << file << " has no " << from;
    writeText(path(file), text.replace(at, from.size(), to));
  }

  TemporaryFolder folder_;
  const std::string script_ = folder_ / "own/small.lua";
};

TEST_F(Capture, IsReproducibleUnderAllDisturbances) {
  Outcome first = capture("first", "", "STROBE_VALIDATION=1");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  ASSERT_EQ(images("first").size(), 2u * 5 + 2);
  EXPECT_EQ(runLine("cd " + path("first") + " && sha256sum -c SHA256SUMS").exit_code, 0);
  Json was = manifest("first");
  for (const Json& picture : was["pictures"]) EXPECT_EQ(picture["runs"], 1) << picture["name"];
  EXPECT_EQ(contentOf(path("first/manifest.json")).find(path("")), std::string::npos) << "a path of this machine";
  for (const char* threads : {"1", "8"}) {
    std::string out = std::string("threads_") + threads;
    Outcome again = runLine("cd / && umask 077 && exec env STROBE_VALIDATION=0 LP_NUM_THREADS=" + std::string(threads) +
                            " LC_ALL=C.UTF-8 LANG=de_DE.UTF-8 TZ=Asia/Kathmandu setarch -R '" + programPath() +
                            "' capture " + script_ + " -o " + path(out));
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(images(out), images("first"));
    Json is = manifest(out);
    EXPECT_EQ(is, was);
    EXPECT_EQ(contentOf(path(out + "/SHA256SUMS")), contentOf(path("first/SHA256SUMS")));
  }
  Outcome same = run("diff " + path("first") + " " + path("threads_1"));
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_EQ(same.out, "no differences\n");
}

TEST_F(Capture, EditedCommentChangesOnlyHashesOfFiles) {
  const std::string home = copiedHome();
  ASSERT_EQ(capture("first", "", home).exit_code, 0);
  replaceIn("home/shaders/hybrid/ray_reveal.glsl", "// SPDX", "// edited\n// SPDX");
  replaceIn("home/passes/hybrid/ray_reveal.lua", "-- SPDX", "-- edited\n-- SPDX");
  ASSERT_EQ(capture("second", "", home).exit_code, 0);
  EXPECT_EQ(images("second"), images("first"));
  Json was = manifest("first"), is = manifest("second");
  EXPECT_NE(is["inputs"], was["inputs"]);
  is["inputs"] = was["inputs"];
  EXPECT_EQ(is, was);
  Outcome diff = run("diff " + path("first") + " " + path("second"));
  EXPECT_EQ(diff.exit_code, 0) << "the pictures are equal";
  EXPECT_NE(diff.out.find("input altered: strobe:passes/hybrid/ray_reveal.lua\n  line 1: -- SPDX"), std::string::npos)
      << diff.out;
  Outcome verified = run("verify " + path("first"), home);
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_NE(verified.out.find("input altered: strobe:shaders/hybrid/ray_reveal.glsl"), std::string::npos)
      << verified.out;
}

// Changes all outputs of one pass at a time; the short form changes every third pass.
TEST_F(Capture, VerifyNamesTheFirstDifferingPass) {
  const std::string home = copiedHome();
  ASSERT_EQ(capture("out", "--only card.hybrid", home).exit_code, 0);
  Json passes = manifest("out")["pictures"][0]["passes"];
  ASSERT_GE(passes.size(), 10u);
  std::map<std::string, std::string> first_with;  // first node of each shader
  for (const Json& pass : passes) first_with.try_emplace(pass["shader"], pass["node"]);
  int number = 0;
  for (const Json& pass : passes) {
    const std::string node = pass["node"], name = pass["shader"];
    if (first_with.at(name) != node || (number++ % 3 && !allCases())) continue;
    std::string file = "home/shaders/" + name + ".glsl";
    if (!fs::exists(path(file))) file = "home/shaders/" + name + ".frag.glsl";
    SCOPED_TRACE(node);
    const std::string whole = contentOf(path(file));
    // Add 0.0625 to floats and 1 to ids; in raster shaders, add 1 to the last output.
    std::string edited = whole;
    size_t at = edited.find("imageStore(", edited.find("void run("));
    if (at != std::string::npos) {
      for (size_t store = at; store != std::string::npos; store = edited.find("imageStore(", store + 1)) {
        const size_t end = edited.find(");\n", store);
        edited.insert(end, edited.find("uvec4", store) < end ? " + 1u" : " + 0.0625");
      }
    } else {
      at = edited.rfind(" = ", edited.rfind(";\n"));
      edited.insert(edited.find(";\n", at), " + 1u");
    }
    writeText(path(file), edited);
    Outcome verified = run("verify " + path("out") + " --json", home);
    EXPECT_EQ(verified.exit_code, 1) << verified.err << edited.substr(at, 120);
    if (verified.exit_code == 1 && !verified.out.empty()) {
      Json json = Json::parse(verified.out);
      ASSERT_EQ(json["pictures"].size(), 1u);
      EXPECT_EQ(json["pictures"][0]["first"]["node"], node) << json["pictures"][0]["first"];
      EXPECT_EQ(json["inputs"].size(), 1u) << json["inputs"];
    }
    writeText(path(file), whole);
  }
}

TEST_F(Capture, FindsOneUnitInTheLastPlaceOfOnePixel) {
  const std::string home = copiedHome();
  ASSERT_EQ(capture("out", "--only card.none", home).exit_code, 0);
  replaceIn("home/shaders/gbuffer/shade.glsl", "imageStore(color_img, pixel, ",
            "if (pixel == ivec2(5, 7)) { vec4 one = quantisedColor(vec4(color, 1)); one.y = "
            "uintBitsToFloat(floatBitsToUint(one.y) + 1u); imageStore(color_img, pixel, one); return; }\n  "
            "imageStore(color_img, pixel, ");
  Outcome verified = run("verify " + path("out") + " --json -o " + path("maps"), home);
  EXPECT_EQ(verified.exit_code, 1) << verified.err;
  Json first = Json::parse(verified.out)["pictures"][0]["first"];
  EXPECT_EQ(first["image"], "shade.color");
  EXPECT_EQ(first["pixels"], 1);
  EXPECT_EQ(first["largest_ulp"], 1);
  EXPECT_EQ(first["first"], Json::array({5, 7, 1}));
  EXPECT_TRUE(fs::exists(path("maps/card.none.shade.color.png")));
}

TEST_F(Capture, BundleVerifiesWithoutTheOriginals) {
  ASSERT_EQ(capture("bundle", "--bundle").exit_code, 0);
  fs::create_directories(path("elsewhere"));
  fs::rename(path("bundle"), path("elsewhere/moved"));
  fs::remove_all(path("own"));
  fs::create_directories(path("empty/scripts"));
  const std::string alone = "STROBE_VALIDATION=0 STROBE_HOME=" + path("empty") + " STROBE_DATA=" + path("empty");
  Outcome verified = run("verify " + path("elsewhere/moved"), alone);
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  // The bundle contains exactly the files listed in the manifest.
  std::set<std::string> held, listed;
  Json stated = manifest("elsewhere/moved");
  for (const auto& entry : fs::recursive_directory_iterator(path("elsewhere/moved/inputs")))
    if (entry.is_regular_file()) held.insert(sha256(contentOf(entry.path())));
  for (const Json& input : stated["inputs"]) listed.insert(input["sha256"].get<std::string>());
  EXPECT_EQ(held, listed);
  replaceIn("elsewhere/moved/inputs/capture/scene.lua", "0.8", "0.7");
  verified = run("verify " + path("elsewhere/moved"), alone);
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_NE(verified.err.find("inputs/capture/scene.lua: was altered"), std::string::npos) << verified.err;
  fs::remove(path("elsewhere/moved/inputs/capture/scene.lua"));
  EXPECT_NE(run("verify " + path("elsewhere/moved"), alone).err.find("is missing"), std::string::npos);
}

// The crate has the structure required by RO-Crate 1.1 and its profile, and true statements about files.
TEST_F(Capture, CrateDescribesEveryFile) {
  ASSERT_EQ(capture("out", "--only card").exit_code, 0);
  const std::string tool = "python3 '" + (sourceFolder() / "tools/crate.py").string() + "' " + path("out");
  ASSERT_EQ(runLine("SOURCE_DATE_EPOCH=1595116801 exec " + tool).exit_code, 0);
  Json crate = Json::parse(contentOf(path("out/ro-crate-metadata.json")));
  EXPECT_EQ(crate["@context"][0], "https://w3id.org/ro/crate/1.1/context");
  std::map<std::string, Json> entities;
  for (const Json& entity : crate["@graph"])
    EXPECT_TRUE(entities.emplace(entity.at("@id").get<std::string>(), entity).second) << entity["@id"] << " twice";
  auto idsOf = [](const Json& links) {
    std::set<std::string> ids;
    for (const Json& one : links) ids.insert(one.at("@id").get<std::string>());
    return ids;
  };
  const Json& descriptor = entities.at("ro-crate-metadata.json");
  EXPECT_EQ(descriptor["@type"], "CreativeWork");
  EXPECT_EQ(descriptor["conformsTo"]["@id"], "https://w3id.org/ro/crate/1.1");
  EXPECT_EQ(descriptor["about"]["@id"], "./");
  const Json& root = entities.at("./");
  EXPECT_EQ(root["@type"], "Dataset");
  EXPECT_EQ(root["name"], "Small");
  EXPECT_EQ(root["datePublished"], "2020-07-19") << "two seconds after midnight, UTC";
  EXPECT_EQ(root["conformsTo"]["@id"], "https://w3id.org/ro/wfrun/process/0.5");
  const Json& action = entities.at(root["mentions"]["@id"].get<std::string>());
  EXPECT_EQ(action["@type"], "CreateAction");
  EXPECT_EQ(entities.at(action["instrument"]["@id"].get<std::string>())["@type"], "SoftwareApplication");

  // Every link except the link to the specification leads to an entity; files are parts and match their description.
  std::set<std::string> parts = idsOf(root["hasPart"]), files;
  for (const auto& [id, entity] : entities) {
    for (const Json& value : id == "ro-crate-metadata.json" ? Json::object() : entity)
      for (const Json& one : value.is_array() ? value : Json::array({value}))
        if (one.is_object()) EXPECT_TRUE(entities.count(one.at("@id").get<std::string>())) << one;
    if (entity["@type"] != "File") continue;
    files.insert(id);
    ASSERT_TRUE(fs::is_regular_file(path("out/" + id))) << id;
    EXPECT_FALSE(entity["encodingFormat"].get<std::string>().empty());
    if (id == "SHA256SUMS") continue;
    EXPECT_EQ(entity["sha256"], sha256(contentOf(path("out/" + id)))) << id;
    EXPECT_EQ(entity["contentSize"], std::to_string(fs::file_size(path("out/" + id)))) << id;
  }
  EXPECT_EQ(parts, files);
  std::set<std::string> used = idsOf(action["object"]), made = idsOf(action["result"]);
  EXPECT_TRUE(used.count("inputs/capture/small.lua") && used.count("inputs/capture/scene.lua"));
  EXPECT_EQ(used.size(), manifest("out")["inputs"].size());
  EXPECT_EQ(made.size(), manifest("out")["files"].size() + 1) << "all files and the manifest";
  EXPECT_TRUE(made.count("pictures/card.hybrid.png") && made.count("manifest.json"));
  used.insert(made.begin(), made.end()), used.insert("SHA256SUMS");
  EXPECT_EQ(used, files);
  EXPECT_EQ(runLine("cd " + path("out") + " && grep -c ro-crate SHA256SUMS").out, "0\n")
      << "the crate is derived and not in the list";
  Outcome refused = runLine("SOURCE_DATE_EPOCH=today exec " + tool);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("SOURCE_DATE_EPOCH is not a number of seconds"), std::string::npos) << refused.err;
}

TEST_F(Capture, ZipVerifiesAfterUnpacking) {
  ASSERT_EQ(capture("first", "--only card.none --zip").exit_code, 0);
  ASSERT_EQ(runLine("umask 077 && exec env STROBE_VALIDATION=0 TZ=Asia/Kathmandu '" + programPath() + "' capture " +
                    script_ + " --only card.none --zip -o " + path("second/"))
                .exit_code,
            0);
  EXPECT_TRUE(contentOf(path("first.zip")) == contentOf(path("second.zip"))) << "equal bytes";
  Outcome listed = runLine("python3 -c 'import zipfile\nfor f in zipfile.ZipFile(\"" + path("first.zip") +
                           "\").infolist(): print(f.date_time, oct(f.external_attr >> 16), f.filename)'");
  ASSERT_EQ(listed.exit_code, 0) << listed.err;
  std::set<std::string> names = {"SHA256SUMS", "ro-crate-metadata.json"};
  std::istringstream sums(contentOf(path("first/SHA256SUMS")));
  for (std::string hash, name; sums >> hash >> name;) names.insert(name);
  std::string expected;
  for (const std::string& name : names) expected += "(1980, 1, 1, 0, 0, 0) 0o100644 " + name + "\n";
  EXPECT_EQ(listed.out, expected);
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();

  for (const char* original : {"own", "first", "second"}) fs::remove_all(path(original));
  fs::create_directories(path("empty/scripts"));
  const std::string alone = "STROBE_VALIDATION=0 STROBE_HOME=" + path("empty") + " STROBE_DATA=" + path("empty");
  ASSERT_EQ(runLine("python3 -m zipfile -e " + path("first.zip") + " " + path("elsewhere")).exit_code, 0);
  EXPECT_EQ(runLine("cd " + path("elsewhere") + " && sha256sum -c SHA256SUMS").exit_code, 0);
  Outcome verified = run("verify " + path("elsewhere"), alone);
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
}

TEST_F(Capture, SignalStopsItAndASecondCaptureIsRefused) {
  pid_t child = ::fork();
  if (child == 0) {
    std::string line = "exec '" + programPath() + "' capture " + script_ + " -o " + path("out") + " >/dev/null 2>&1";
    ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    ::_exit(127);
  }
  for (int waited = 0; !fs::exists(path("out/pictures")) && waited < 3000; ++waited) ::usleep(10000);
  ::kill(child, SIGSTOP);
  Outcome second = capture("out");
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_NE(second.err.find("out: another program works in this folder: process "), std::string::npos) << second.err;
  for (int signal : {SIGTERM, SIGCONT}) ::kill(child, signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 75);
  EXPECT_FALSE(fs::exists(path("out/.lock")));
  EXPECT_TRUE(copyIn(path("out")).empty());
  EXPECT_EQ(capture("out").exit_code, 0);
}

TEST_F(Capture, ContinuesAfterAKillAtAnyTime) {
  ASSERT_EQ(capture("whole").exit_code, 0);
  std::mt19937 random(1);
  for (int i = 0; i < (allCases() ? 30 : 8); ++i) {
    pid_t child = ::fork();
    if (child == 0) {
      ::setpgid(0, 0);
      std::string line =
          "exec '" + programPath() + "' capture " + script_ + " -o " + path("killed") + " >/dev/null 2>&1";
      ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      ::_exit(127);
    }
    ::usleep(useconds_t(random() % 900000));
    ::kill(-child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    if (!fs::exists(path("killed"))) continue;
    for (const auto& [name, hash] : images("killed"))
      EXPECT_EQ(hash, images("whole")[name]) << name << " is incomplete";
  }
  ASSERT_EQ(capture("killed").exit_code, 0);
  EXPECT_EQ(images("killed"), images("whole"));
  EXPECT_EQ(contentOf(path("killed/manifest.json")), contentOf(path("whole/manifest.json")));
}

// Tone and labels do not change the drawn pictures, but change the files.
TEST_F(Capture, EditedToneOrLabelsDrawAgain) {
  replaceIn("own/small.lua", "frames = { 0, 2, 1 }", "vary = { exposure = { 0.2, 0.4 } }, stops = 0");
  ASSERT_EQ(capture("edited", "--only past").exit_code, 0);
  auto before = images("edited");
  replaceIn("own/small.lua", "stops = 0", "stops = 2");
  ASSERT_EQ(capture("edited", "--only past").exit_code, 0);
  ASSERT_EQ(capture("fresh", "--only past").exit_code, 0);
  EXPECT_NE(images("edited"), before);
  EXPECT_EQ(images("edited"), images("fresh"));
  EXPECT_EQ(manifest("edited"), manifest("fresh"));
}

TEST_F(Capture, ExampleOfThePageRuns) {
  std::string page = contentOf(sourceFolder() / "docs/captures.md");
  size_t from = page.find("```lua\n") + 7, to = page.find("```", from);
  ASSERT_NE(to, std::string::npos);
  writeText(script_, page.substr(from, to - from));
  Outcome outcome = capture("out", "--size 64x36");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(path("out/vase.png")));
  EXPECT_EQ(manifest("out")["pictures"].size(), 3u);
}

// A link in the script's folder is refused like its target's path.
TEST_F(Capture, RefusesALinkToAnotherFolder) {
  fs::create_directories(path("elsewhere"));
  fs::rename(path("own/scene.lua"), path("elsewhere/scene.lua"));
  fs::create_symlink(path("elsewhere/scene.lua"), path("own/scene.lua"));
  Outcome outcome = capture("out");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("lies outside"), std::string::npos) << outcome.err;
}

TEST_F(Capture, RefusesMistakes) {
  auto refused = [&](const std::string& from, const std::string& to, const std::string& wanted) {
    std::string text = kCapture;
    size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    writeText(script_, text.replace(at, from.size(), to));
    Outcome outcome = capture("refused");
    EXPECT_NE(outcome.exit_code, 0) << to;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(path("refused/manifest.json")));
    writeText(script_, kCapture);
  };
  refused("size =", "siez =", "small.lua:4: the capture has no field 'siez'");
  refused("\"hybrid_layered\", shots", "\"hybird\", shots", "unknown pipeline 'hybird'");
  refused("shots = { \"card\" }", "shots = { \"crad\" }", "did you mean 'card'?");
  refused("pipeline = \"none\"", "pipeline = \"none\", layers = { \"dephth\" }", "no layer 'dephth'");
  refused("frames = { 0, 2, 1 }", "frames = { 2, 0, 1 }", "frames must be");
  refused("name = \"past\"", "name = \"CARD\"", "shots 'card' and 'CARD' would write the same files, 'card'");
  refused("shot = \"card\", columns", "shot = \"crad\", columns", "did you mean 'card'?");
  EXPECT_EQ(capture("refused", "--only nothing").exit_code, 2);
  EXPECT_EQ(run("verify " + path("own")).exit_code, 1);
  ASSERT_EQ(capture("out", "--only card.none").exit_code, 0);
  Json newer = manifest("out");
  newer["format_version"] = 2;
  writeText(path("out/manifest.json"), newer.dump());
  EXPECT_NE(run("verify " + path("out")).err.find("is a manifest of format 2"), std::string::npos);
  writeText(path("out/manifest.json"), newer.dump().substr(0, 500));
  EXPECT_NE(run("diff " + path("out") + " " + path("out")).err.find("cut short"), std::string::npos);
  fs::remove(script_);
  newer["format_version"] = 1;
  writeText(path("out/manifest.json"), newer.dump());
  EXPECT_NE(run("verify " + path("out")).err.find("differs from its checksum in SHA256SUMS"), std::string::npos);
  fs::remove(path("out/SHA256SUMS"));
  EXPECT_NE(run("verify " + path("out")).err.find("script 'capture:small.lua' is missing"), std::string::npos);
}

}  // namespace capture_test
}  // namespace strobe::testing
