// SPDX-License-Identifier: MIT
// Fields of tables returned by the pipeline library: a misspelt field is an error, never nil.
#include <gtest/gtest.h>

#include "common/temporary_folder.h"
#include "home.h"
#include "script/evaluate.h"

namespace strobe::script {
namespace fields_test {

// Error of evaluating a pipeline whose build function has `local wrong = value` in line 12.
static std::string errorWith(const std::string& value) {
  static const strobe::testing::TemporaryFolder folder;
  const std::string file = folder / "x.lua";
  writeFileAtomically(file, R"(local pipeline = require "strobe.pipeline"
local blur     = require "passes.lib.blur"
local shade    = require "passes.gbuffer.shade"
local gathers  = require "scripts.pipelines.lib.gathers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"
return pipeline { doc = "x", params = options.blur(40), build = function(p)
  local seen = scene.raster()
  local around = tiles.dominant(p, seen)
  local images = gathers.images(seen, around)
  local wrong = )" + value + R"(
  return scene.outputs(seen, { color = gathers.blurred("uniform", images, "gather") })
end })");
  try {
    evaluatePipeline(Home(sourceFolder()), {file, {}});
  } catch (const Error& error) {
    const std::string what = error.what();
    const std::string place = file + ":12: ";
    return what.starts_with(place) ? what.substr(place.size()) : what;
  }
  return "";
}

TEST(Fields, MisspeltFieldsAreErrors) {
  for (const auto& [value, error] : {
           std::pair<std::string, std::string>{"seen.detph", "a layer has no 'detph'; did you mean 'depth'?"},
           {"images.colr", "the inputs of a gather has no 'colr'; did you mean 'color'?"},
           {"around.dominnat", "the result of tiles.dominant has no 'dominnat'; did you mean 'dominant'?"},
           {"shade.params.shding", "'params' of pass 'gbuffer/shade' has no 'shding'; did you mean 'shading'?"},
           {"shade.counters.clampd", "'counters' of pass 'gbuffer/shade' has no 'clampd'"},
           {"shade.parms", "a pass has no 'parms'; did you mean 'params'?"},
           {"blur.sampels", "the module passes.lib.blur has no 'sampels'; did you mean 'samples'?"},
           {"scene.rastre", "the module scripts.pipelines.lib.scene has no 'rastre'; did you mean 'raster'?"},
           {"p.tile.value", "parameter 'tile' has no field 'value'; its value is p.tile()"},
       })
    EXPECT_TRUE(errorWith(value).starts_with(error)) << value << ": " << errorWith(value);
}

TEST(Fields, OptionalFieldsReadAsNil) {
  for (const char* value :
       {"assert(seen.depth)", "assert(seen.curve == nil)", "assert(images.background_depth == nil)",
        "assert(seen:get('mask') == nil)", "assert(seen:get('depth') == seen.depth)",
        "assert(shade { hit = seen.hit, as = 'again' }:get('color'))", "assert(rawget(seen, 'mask') == nil)",
        "assert(pipeline.record('x', { 'a' }) { b = 1 }.a == nil)"})
    EXPECT_EQ(errorWith(value), "") << value;
  EXPECT_EQ(errorWith("pipeline.record('a thing', { 'one' }) { two = 1 }.seventeen"),
            "a thing has no 'seventeen'; it has one, two");
}

// A module's table: unknown names are errors, missing list entries are nil.
TEST(Fields, OfModulesMayBeLists) {
  TestHome home;
  home.write("passes/lib/names.lua", "return { 'a', 'b', size = 2 }");
  home.write("x.lua", R"(local names = require "passes.lib.names"
local count = 0
for _ in ipairs(names) do count = count + 1 end
return { count = count, behind = names[3] == nil, size = names[...] })");
  const std::string file = (home.folder() / "x.lua").string();
  EXPECT_EQ(evaluateData(home.home(), file, "size").dump(), R"({"behind":true,"count":2,"size":2})");
  try {
    evaluateData(home.home(), file, "sise");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), (file.substr(home.folder().string().size() + 1) +
                                ":4: the module passes.lib.names has no 'sise'; did you mean 'size'?")
                                   .c_str());
  }
}

}  // namespace fields_test
}  // namespace strobe::script
