// SPDX-License-Identifier: MIT
// Files edited while a shot runs: every way of saving, every kind of mistake, and the state that must survive.
#include <fcntl.h>
#include <unistd.h>

#include <regex>
#include <thread>

#include "session/home.h"

namespace strobe::session {
namespace reload_test {

using lab::Reload;
using lab::Session;

const char* const kGather = "shaders/gather/mcguire2012.glsl";

class ReloadTest : public SessionTest {
 protected:
  // Expects the plan and the pictures of a new session.
  void expectColdStart(Session& session, const std::string& what) {
    Session cold(bench(), session.shot());
    EXPECT_EQ(session.running().planned().hash, cold.running().planned().hash) << what;
    EXPECT_EQ(hashes(session.draw()), hashes(cold.draw())) << what;
  }
};

// Waits for a reload in the background, as a window does.
Reload awaited(Session& session) {
  for (int i = 0; i < 2000; ++i) {
    if (auto told = session.reload(false)) return *told;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ADD_FAILURE() << "nothing was reloaded within 10 s";
  return {};
}

TEST_F(ReloadTest, EveryWayOfSavingIsReloaded) {
  Session session(bench(), smallShot("mcguire2012"));
  EXPECT_FALSE(session.reload(false));
  std::string before = colorHash(session);
  int n = 0;
  for (Save save : {Save::InPlace, Save::Rename, Save::Twice}) {
    ++n;
    std::string now = fmt::format("float all = {}.0 / here.radius;", n + 1);
    home_.edit(kGather, n == 1 ? "float all = 1.0 / here.radius;" : fmt::format("float all = {}.0 / here.radius;", n),
               now, save);
    Reload told = awaited(session);
    EXPECT_TRUE(told.swapped) << joined(told.problems);
    EXPECT_EQ(joined(told.rebuilt), "gather");
    EXPECT_EQ(told.compilations, 1);
    EXPECT_EQ(told.evaluate_ms, 0) << "no Lua changed";
    std::string after = colorHash(session);
    EXPECT_NE(after, before);
    before = after;
  }
  expectColdStart(session, "after three saves");
  EXPECT_FALSE(session.reload(false));
  home_.write(kGather, home_.read(kGather));
  EXPECT_FALSE(session.reload(true)) << "the same text is not a change";
}

// Scripts and shaders stored elsewhere, behind a chain of links.
TEST_F(ReloadTest, EditsBehindLinksAreReloaded) {
  namespace fs = std::filesystem;
  for (const std::string file : {"passes/gather/mcguire2012.lua", kGather}) {
    const Path name = Path(file).filename();
    fs::create_directories(home_.path("store/deep"));
    fs::rename(home_.path(file), home_.path("store/deep") / name);
    fs::create_symlink("deep" / name, home_.path("store") / name);
    fs::create_symlink("../../store" / name, home_.path(file));
  }
  Session session(bench(), smallShot("mcguire2012"));
  EXPECT_FALSE(session.reload(false));
  std::string before = colorHash(session);
  home_.edit("store/deep/mcguire2012.glsl", "float all = 1.0 / here.radius;", "float all = 2.0 / here.radius;",
             Save::Rename);
  EXPECT_TRUE(awaited(session).swapped);
  EXPECT_NE(colorHash(session), before);
  home_.edit("store/deep/mcguire2012.lua", "doc", "doc = nil, dok");
  EXPECT_FALSE(awaited(session).problems.empty());
  fs::remove_all(home_.path("store"));
}

// A pass in a folder of alternatives is a new choice, although the picture does not use it.
TEST_F(ReloadTest, NewChoicesAreNamed) {
  Session session(bench(), smallShot("hybrid"));
  EXPECT_FALSE(session.reload(false));
  home_.write("passes/edge/made.lua", home_.read("passes/edge/sobel.lua"));
  Reload told = awaited(session);
  EXPECT_FALSE(told.swapped);
  EXPECT_EQ(told.choices, std::vector<std::string>{"edge = made"});
  const std::string text = lab::textOf(told);
  EXPECT_TRUE(text.starts_with("reloaded passes/edge (same picture, ")) << text;
  EXPECT_NE(text.find("\n  new choice edge = made"), std::string::npos) << text;
  home_.remove("passes/edge/made.lua");
}

TEST_F(ReloadTest, EqualCodeKeepsThePipelineOfTheDriver) {
  Session session(bench(), smallShot("mcguire2012"));
  auto gather = [&] { return session.running().graph().pipelines().at("gather"); };
  const std::string picture = colorHash(session);
  auto before = gather();
  home_.edit(kGather, "\n", "\n// Edited.\n");
  EXPECT_TRUE(session.reload(true));
  EXPECT_NE(gather(), before);
  EXPECT_EQ(gather()->driver, before->driver);
  EXPECT_EQ(colorHash(session), picture);
  home_.edit(kGather, "float all = 1.0 /", "float all = 2.0 /");
  EXPECT_TRUE(session.reload(true));
  EXPECT_NE(gather()->driver, before->driver);
  EXPECT_NE(colorHash(session), picture);
  expectColdStart(session, "after an edit that changes the code");
}

TEST_F(ReloadTest, FilesBeingWrittenAreNotReloaded) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  std::string text = home_.read(kGather);
  int file = ::open(home_.path(kGather).c_str(), O_WRONLY | O_TRUNC);
  ASSERT_GE(file, 0);
  ASSERT_GT(::write(file, text.data(), text.size() / 2), 0);
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(session.reload(false));
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::string rest = text.substr(text.size() / 2) + "// more\n";
  ASSERT_GT(::write(file, rest.data(), rest.size()), 0);
  ::close(file);
  EXPECT_TRUE(awaited(session).swapped);
}

// Saves like an editor that keeps the old text as a backup.
TEST_F(ReloadTest, SavingWithABackupIsOneReload) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  const std::string text = home_.read(kGather);
  const Path away = home_.path(kGather + std::string("~"));
  std::filesystem::rename(home_.path(kGather), away);
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(session.reload(false));
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  home_.write(kGather, text + "// more\n");
  std::filesystem::remove(away);
  Reload told = awaited(session);
  EXPECT_TRUE(told.swapped);
  EXPECT_EQ(joined(told.problems), "");
  home_.remove(kGather);
  EXPECT_NE(joined(awaited(session).problems), "") << "the file stays missing";
}

// Checks the files for 40 ms, and expects no reload.
void expectNoReload(Session& session, const std::string& what) {
  for (int i = 0; i < 20; ++i) {
    std::optional<Reload> told = session.reload(false);
    EXPECT_FALSE(told) << what << ": " << joined(told->problems);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

// The file is closed between the steps, and its first half is a mistake.
TEST_F(ReloadTest, SavingInTwoStepsIsOneReload) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  for (const std::string file : {"passes/gather/mcguire2012.lua", kGather}) {
    const std::string before = colorHash(session), text = home_.read(file);
    for (const std::string& first : {std::string(), text.substr(0, text.size() / 2)}) {
      home_.write(file, first);
      expectNoReload(session, file);
      EXPECT_EQ(colorHash(session), before);
      home_.write(file, text);
      Reload told = awaited(session);
      EXPECT_EQ(joined(told.problems), "");
      EXPECT_EQ(joined(told.changed), file);
    }
    home_.remove(file);
    expectNoReload(session, file);
    home_.write(file, text + (file == kGather ? "// more\n" : "-- more\n"));
    EXPECT_EQ(joined(awaited(session).problems), "");
    EXPECT_FALSE(session.evaluates());
    EXPECT_FALSE(session.reload(true));
  }
  expectColdStart(session, "after both");
}

// Saves like a program that saves all its open files.
TEST_F(ReloadTest, SavingSeveralFilesIsOneReload) {
  Session session(bench(), smallShot("hybrid_layered"));
  session.reload(false);
  const std::string before = colorHash(session), good = home_.read("shaders/layered/disocclusion_mask.glsl");
  home_.write("shaders/layered/disocclusion_mask.glsl", "void run(ivec2 pixel) { nonsense }");
  home_.edit("shaders/layered/layered_composite.glsl", "fromSum(sum / float", "fromSum(0.5 * sum / float");
  expectNoReload(session, "a mistake in one of two files");
  EXPECT_EQ(colorHash(session), before);
  home_.write("shaders/layered/disocclusion_mask.glsl", good);
  Reload told = awaited(session);
  EXPECT_EQ(joined(told.problems), "");
  EXPECT_EQ(joined(told.rebuilt), "composite");
  EXPECT_EQ(told.changed.size(), 2u);
  expectColdStart(session, "after both");
}

TEST_F(ReloadTest, ValuesSetBeforeAFailureStay) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  home_.write("passes/gather/mcguire2012.lua", "return");
  expectNoReload(session, "a mistake");
  session.set("samples", "8", "window");
  const std::string of_eight = colorHash(session);
  EXPECT_NE(joined(awaited(session).problems).find("mcguire2012.lua"), std::string::npos);
  EXPECT_EQ(colorHash(session), of_eight);
}

TEST_F(ReloadTest, ABrokenShaderKeepsThePicture) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  std::string before = colorHash(session), good = home_.read(kGather);
  home_.edit(kGather, "tapWeight(here, tap", "tapWeigth(here, tap");
  Reload told = awaited(session);
  EXPECT_FALSE(told.swapped);
  std::string problem = joined(session.problems());
  EXPECT_TRUE(std::regex_search(problem, std::regex("shaders/gather/mcguire2012.glsl:[0-9]+: .*tapWeigth"))) << problem;
  EXPECT_EQ(colorHash(session), before);
  // Values can still be changed, and changed back.
  session.set("samples", "5", "window");
  EXPECT_NE(colorHash(session), before);
  session.set("samples", "16", "window");
  EXPECT_EQ(colorHash(session), before);
  home_.write(kGather, good + "// mended\n");
  told = awaited(session);
  EXPECT_TRUE(session.problems().empty()) << joined(session.problems());
  EXPECT_EQ(colorHash(session), before);
  expectColdStart(session, "after mending");
}

TEST_F(ReloadTest, ABrokenScriptKeepsThePicture) {
  Session session(bench(), smallShot("hybrid"));
  bench().limits.cpu_s = 0.3;
  session.reload(false);
  std::string before = colorHash(session);
  const char* file = "scripts/pipelines/hybrid.lua";
  std::string good = home_.read(file);
  struct Mistake {
    std::string from, to, says;
  };
  for (const Mistake& mistake : {Mistake{"return pipeline {", "return pipeline {{", "hybrid.lua"},
                                 Mistake{"return pipeline", "while true do end return pipeline", "endless loop"},
                                 Mistake{"return pipeline {", "return 3 --{", "hybrid"},
                                 Mistake{"found.velocity,", "found.velocty,", "did you mean 'velocity'"}}) {
    home_.edit(file, mistake.from, mistake.to);
    Reload told = awaited(session);
    EXPECT_FALSE(told.swapped) << mistake.to;
    EXPECT_NE(joined(told.problems).find(mistake.says), std::string::npos) << joined(told.problems);
    EXPECT_EQ(colorHash(session), before);
    // A graph of another shape is built from the last good scripts.
    session.set("weights", "guertin2014", "window");
    EXPECT_NE(colorHash(session), before);
    session.unset("weights");
    EXPECT_EQ(colorHash(session), before);
    home_.write(file, good);
    awaited(session);
    EXPECT_TRUE(session.problems().empty()) << joined(session.problems());
  }
  bench().limits = {};
  expectColdStart(session, "after the last good edit");
}

TEST_F(ReloadTest, OneBrokenPassDoesNotStopOthers) {
  Session session(bench(), smallShot("hybrid_layered"));
  session.reload(false);
  // GLSL: one shader broken, another changed.
  std::string good = home_.read("shaders/layered/disocclusion_mask.glsl"), before = colorHash(session);
  home_.write("shaders/layered/disocclusion_mask.glsl", "void run(ivec2 pixel) { nonsense }");
  home_.edit("shaders/layered/layered_composite.glsl", "fromSum(sum / float", "fromSum(0.5 * sum / float");
  auto told = session.reload(true);
  ASSERT_TRUE(told);
  EXPECT_EQ(joined(told->rebuilt), "composite");
  EXPECT_NE(joined(told->problems).find("shaders/layered/disocclusion_mask.glsl:1"), std::string::npos)
      << joined(told->problems);
  EXPECT_NE(colorHash(session), before);
  home_.write("shaders/layered/disocclusion_mask.glsl", good);
  told = session.reload(true);
  EXPECT_TRUE(session.problems().empty()) << joined(session.problems());
  expectColdStart(session, "GLSL");

  // Lua: one pass broken, another with a new parameter.
  good = home_.read("passes/layered/disocclusion_mask.lua");
  home_.write("passes/layered/disocclusion_mask.lua", "return nothing at all");
  home_.edit("passes/layered/layered_composite.lua", "search_taps  ",
             "dimmed = pass.float { 1, min = 0, max = 1, doc = \"of the result\" },\n    search_taps  ");
  home_.edit("shaders/layered/layered_composite.glsl", "fromSum(0.5 * sum", "fromSum(params.dimmed * sum");
  told = session.reload(true);
  ASSERT_TRUE(told);
  EXPECT_NE(joined(told->problems).find("passes/layered/disocclusion_mask.lua:1"), std::string::npos)
      << joined(told->problems);
  EXPECT_TRUE(told->swapped);
  session.set("composite.dimmed", "0.25", "window");
  home_.write("passes/layered/disocclusion_mask.lua", good);
  told = session.reload(true);
  EXPECT_TRUE(session.problems().empty()) << joined(session.problems());
  EXPECT_NE(joined(told->kept).find("composite.dimmed = 0.25"), std::string::npos);
  expectColdStart(session, "Lua");
}

TEST_F(ReloadTest, WrongBindingsAreRefusedByTheNameOfTheirPass) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  std::string before = colorHash(session);
  struct Case {
    std::string file, from, to, says;
  };
  for (const Case& one :
       {Case{"passes/gather/mcguire2012.lua", "of_layer { \"second\" }",
             "of_layer({ \"second\" }, { prevailing = { doc = \"x\" } })", "pass 'gather/mcguire2012' is not given"},
        Case{"passes/gather/mcguire2012.lua", "of_layer { \"second\" }",
             "of_layer({ \"second\" }, { velocity = { uint = true, doc = \"x\" } })",
             "read 'velocity' of pass 'gather/mcguire2012' takes unsigned integers"},
        Case{"passes/gather/mcguire2012.lua", "depth_extent = blur", "depth_range = blur", "gather/mcguire2012"},
        Case{"shaders/gather/mcguire2012.glsl", "dominant_tex", "prevailing_tex", "gather/mcguire2012"}}) {
    std::string good = home_.read(one.file);
    home_.edit(one.file, one.from, one.to);
    auto told = session.reload(true);
    ASSERT_TRUE(told) << one.to;
    EXPECT_FALSE(told->swapped) << one.to;
    EXPECT_NE(joined(told->problems).find(one.says), std::string::npos) << joined(told->problems);
    EXPECT_EQ(colorHash(session), before) << one.to;
    home_.write(one.file, good);
    session.reload(true);
    EXPECT_TRUE(session.problems().empty()) << joined(session.problems());
  }
}

TEST_F(ReloadTest, ValuesSurviveByNameAndType) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  session.set("samples", "8", "window");
  session.set("depth_extent", "0.05", "window");
  session.set("tile", "20", "window");
  const char* file = "passes/lib/blur.lua";
  home_.edit(file, "samples = param.int { 16", "samples = param.int { 12");
  home_.edit(file, "min = 1e-6, max = 1,", "min = 0.1, max = 1,");
  home_.edit(file, "{ 0.01, min = 0.1", "{ 0.2, min = 0.1");
  auto told = session.reload(true);
  ASSERT_TRUE(told && told->swapped) << joined(told->problems);
  EXPECT_NE(joined(told->kept).find("samples = 8"), std::string::npos);
  EXPECT_NE(joined(told->kept).find("tile = 20"), std::string::npos);
  EXPECT_NE(joined(told->reset).find("depth_extent = 0.05: "), std::string::npos) << joined(told->reset);
  std::string text = lab::textOf(*told);
  EXPECT_NE(text.find("reloaded passes/lib/blur.lua ("), std::string::npos) << text;
  EXPECT_NE(text.find("\n  kept samples = 8"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  reset depth_extent = 0.05: "), std::string::npos) << text;
  expectColdStart(session, "values");
}

TEST_F(ReloadTest, ValuesSetDuringAnEvaluationStay) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  const char* file = "passes/lib/blur.lua";
  home_.edit(file, "samples = param.int { 16", "samples = param.int { 12");
  EXPECT_FALSE(session.reload(false)) << "it is evaluated in the background";
  session.set("samples", "8", "window");
  std::string of_eight = colorHash(session);
  awaited(session);
  EXPECT_EQ(colorHash(session), of_eight);
  expectColdStart(session, "a value");
  // A change of the pipeline is kept, too.
  home_.edit(file, "samples = param.int { 12", "samples = param.int { 10");
  EXPECT_FALSE(session.reload(false));
  session.usePipeline("ue4");
  awaited(session);
  EXPECT_EQ(session.plan().pipeline.name, "ue4");
  expectColdStart(session, "a pipeline");
}

TEST_F(ReloadTest, FilesOutsideTheHomeAreWatched) {
  Session session(bench(), smallShot("mcguire2012"));
  session.reload(false);
  home_.write("own/mine.lua", home_.read("scripts/pipelines/mcguire2012.lua"));
  session.usePipeline(home_.path("own/mine.lua").string());
  std::string before = session.plan().pipeline.doc;
  EXPECT_FALSE(session.reload(false));
  home_.edit("own/mine.lua", before, "Another text.");
  awaited(session);
  EXPECT_EQ(session.plan().pipeline.doc, "Another text.");
}

TEST_F(ReloadTest, NewFilesOfAFamilyAreNewChoices) {
  Session session(bench(), smallShot("hybrid"));
  session.reload(false);
  std::string text = home_.read("passes/edge/id.lua");
  home_.write("passes/edge/twin.lua", text);
  auto told = session.reload(true);
  ASSERT_TRUE(told && told->problems.empty()) << joined(told->problems);
  session.set("edge", "id", "window");
  std::string by_id = colorHash(session);
  session.set("edge", "twin", "window");
  EXPECT_EQ(colorHash(session), by_id);
  // The choice disappears with its file, and so does the value.
  home_.remove("passes/edge/twin.lua");
  told = session.reload(true);
  ASSERT_TRUE(told);
  EXPECT_NE(joined(told->reset).find("edge = twin: "), std::string::npos)
      << joined(told->reset) << joined(told->problems);
  expectColdStart(session, "family");
}

TEST_F(ReloadTest, UnfinishedFilesOfAFamilyAreIgnored) {
  Session session(bench(), smallShot("hybrid"));
  session.reload(false);
  std::string before = colorHash(session);
  home_.write("passes/edge/half.lua", "local pass = require \"strobe.pass\"\nreturn pass.compute {");
  session.reload(true);
  EXPECT_EQ(colorHash(session), before);
  EXPECT_TRUE(session.problems().empty()) << joined(session.problems());
  home_.edit("passes/lib/blur.lua", "samples = param.int { 16", "samples = param.int { 4");
  session.reload(true);
  EXPECT_NE(colorHash(session), before);
}

TEST_F(ReloadTest, EditedScenesAreReloaded) {
  home_.write("scripts/scenes/mine.lua", "return require \"scripts.scenes.oracles.textured_bar\"");
  home_.write("scripts/scenes/mine.lua", home_.read("scripts/scenes/oracles/textured_bar.lua"));
  lab::Shot shot = smallShot("hybrid");
  shot.scene = "mine";
  Session session(bench(), shot);
  session.reload(false);
  std::string before = colorHash(session), good = home_.read("scripts/scenes/mine.lua");
  home_.write("scripts/scenes/mine.lua", "return {");
  auto told = session.reload(true);
  ASSERT_TRUE(told);
  EXPECT_NE(joined(told->problems).find("scripts/scenes/mine.lua"), std::string::npos) << joined(told->problems);
  EXPECT_EQ(colorHash(session), before);
  home_.write("scripts/scenes/mine.lua", good);
  home_.edit("scripts/scenes/mine.lua", "\"f_light\", 0.9", "\"f_light\", 0.7");
  told = session.reload(true);
  ASSERT_TRUE(told && told->swapped) << joined(told->problems);
  EXPECT_EQ(told->compilations, 0) << "a scene needs no compilation";
  EXPECT_NE(colorHash(session), before);
  expectColdStart(session, "scene");
}

// Files that a shader includes, found without the compiler.
void reachedFrom(const EditableHome& home, const std::string& file, std::set<std::string>& files) {
  if (!std::filesystem::exists(home.path(file)) || !files.insert(file).second) return;
  std::string text = home.read(file);
  static const std::regex include("#include \"([^\"]+)\"");
  for (std::sregex_iterator it(text.begin(), text.end(), include), none; it != none; ++it)
    reachedFrom(home, "shaders/" + (*it)[1].str(), files);
}

TEST_F(ReloadTest, CompilesOnlyPassesThatDependOnTheEdit) {
  Session session(bench(), smallShot("hybrid_layered"));
  session.reload(false);
  for (const char* file :
       {"shaders/lib/blur.glsl", "shaders/lib/sanitise.glsl", "shaders/mixin/camera.glsl",
        "shaders/layered/disocclusion_mask.glsl", "shaders/shared/bindings.glsl", "shaders/mixin/jitter.glsl"}) {
    std::set<std::string> closure;
    const plan::Plan& plan = session.plan();
    for (const auto& node : plan.nodes) {
      const auto& pass = plan.pipeline.passes[size_t(node.pass)];
      std::set<std::string> files;
      bool raster = pass.kind == plan::PassDesc::Kind::Raster;
      for (const char* end : {".glsl", ".vert.glsl", ".frag.glsl"})
        if (raster != (std::string(end) == ".glsl")) reachedFrom(home_, "shaders/" + pass.shader + end, files);
      bool sees_scene = pass.scene || pass.kind != plan::PassDesc::Kind::Compute;
      if (sees_scene) reachedFrom(home_, "shaders/shared/bindings.glsl", files);
      if (files.count(file)) closure.insert(plan.pipeline.nodes[size_t(node.node)].name);
    }
    home_.write(file, home_.read(file) + "// touched\n");
    auto told = session.reload(true);
    ASSERT_TRUE(told) << file;
    EXPECT_EQ(std::set<std::string>(told->rebuilt.begin(), told->rebuilt.end()), closure) << file;
    EXPECT_LE(told->compilations, int(closure.size())) << file;
    EXPECT_GE(told->compilations, closure.empty() ? 0 : 1) << file;
  }
}

}  // namespace reload_test
}  // namespace strobe::session
