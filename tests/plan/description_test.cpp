// SPDX-License-Identifier: MIT
// Descriptions come from another process: malformed descriptions, and only these, are refused.
#include "plan/description.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/json.h"

namespace strobe::plan {
namespace description_test {

static const char* kCanonical =
    R"({"name":"p","file":"p.lua","doc":"d","kind":"truth","breaks":{"linear":"r"},"compare_with":"q",
 "equals":[{"when":{"mode":"a"},"pipeline":"q","set":{"tile":8}}],
 "params":[{"name":"mode","type":"choice","default":"a","choices":["a","b"],"values":{"b":"t"},"breaks":{"a":{"still":"r"}},"unit":"","doc":"m","variant":true,
            "place":{"file":"p.lua","line":3}},
           {"name":"n","type":"int","default":4,"min":1,"max":9,"role":"tile","unit":"px","doc":"n","variant":false,
            "place":{"file":"p.lua","line":4}}],
 "graph_params":["mode"],
 "presets":[{"name":"few","doc":"f","default":true,"values":{"n":2}},{"name":"many","doc":"m","default":false,"values":{"mode":"b","n":9}}],
 "preset":"few","values":{"mode":"b","n":5},
 "passes":[{"name":"source","kind":"raster","shader":"s/source","doc":"s","fails":"f","breaks":{"scaled":"r"},"size":{"kind":"frame"},"scene":true,
            "without":[{"name":"motion","writes":{"color":0,"id":0},"place":{"file":"s.lua","line":4}}],
            "reads":[],"writes":[{"name":"color","doc":"c","format":"rgba16f","place":{"file":"s.lua","line":2}},
                                 {"name":"id","doc":"i","format":"r32ui","place":{"file":"s.lua","line":3}}],
            "updates":[],"params":[],"counters":[],"place":{"file":"s.lua","line":1}},
           {"name":"blur","kind":"compute","shader":"blur","doc":"b","fails":"",
            "size":{"kind":"port","port":"image","divide":"by","place":{"file":"b.lua","line":9}},"scene":false,
            "reads":[{"name":"id","doc":"i","uint":true,"optional":true,"linear":false,
                      "needs":["image"],"absent":[1,2,3,4],"place":{"file":"b.lua","line":2}},
                     {"name":"image","doc":"i","uint":false,"optional":false,"linear":true,
                      "place":{"file":"b.lua","line":3}}],
            "writes":[{"name":"out","doc":"o","format":"r32f","cleared":true,"place":{"file":"b.lua","line":4}},
                      {"name":"v","doc":"v","format":"rg32f","place":{"file":"b.lua","line":8},"format_by":"p",
                       "formats":{"f":"rg32f","h":"rg16f"}}],
            "updates":[{"name":"sum","doc":"o","format":"rgba32f","place":{"file":"b.lua","line":5},"history":true}],
            "params":[{"name":"by","type":"int","default":2,"min":1,"max":8,"unit":"px","doc":"b","variant":false,
                       "place":{"file":"b.lua","line":6}},
                      {"name":"k","type":"float","default":0.1,"min":0.0,"max":1.0,"unit":"","doc":"k","variant":false,
                       "place":{"file":"b.lua","line":7}},
                      {"name":"p","type":"choice","default":"f","choices":["f","h"],"unit":"","doc":"p","variant":true,
                       "place":{"file":"b.lua","line":8}}],
            "counters":[{"name":"hits","doc":"h","limit":"l"}],"place":{"file":"b.lua","line":1}}],
 "nodes":[{"name":"source","pass":"source","inputs":{},"params":{},"time":"raster","loop":"","runs":"moving_instances",
           "place":{"file":"p.lua","line":8}},
          {"name":"far","pass":"blur","inputs":{"image":"source.color","id":"source.id"},
           "params":{"by":{"follows":"n","place":{"file":"p.lua","line":9}},
                     "k":{"value":0.25,"place":{"file":"p.lua","line":9}},
                     "p":{"value":"h","place":{"file":"p.lua","line":9}}},
           "time":"sample","loop":"l","place":{"file":"p.lua","line":9}}],
 "loops":[{"name":"l","count":{"follows":"n","place":{"file":"p.lua","line":7}},
           "times":{"value":"stratified","place":{"file":"p.lua","line":7}},
           "slices":{"value":4,"place":{"file":"p.lua","line":7}},"until":"far.out","first":1,"parts":8,
           "place":{"file":"p.lua","line":7}}],
 "outputs":{"color":"far.sum","raw":"source.color"},"regions":[{"name":"raw","doc":"r"}]})";

static Json canonical() { return Json::parse(kCanonical); }

static std::string refusal(const Json& json) {
  try {
    pipelineFromJson(json);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

// Each value replaced by another value of its type is refused or changes the description.
static void changeEach(const Json& whole, const PipelineDesc& description, Json& part, int& kept) {
  for (auto& [key, value] : part.items()) {
    if (value.is_structured()) changeEach(whole, description, value, kept);
    if (value.is_structured() || key == "variant") continue;  // the variant of a choice follows from its type
    const Json before = value;
    if (value.is_string()) value = value.get<std::string>() + "x";
    else if (value.is_boolean()) value = !value.get<bool>();
    else if (value.is_number_float()) value = value.get<double>() + 0.125;
    else value = value.get<int>() + 1;
    try {
      EXPECT_FALSE(pipelineFromJson(whole) == description) << key << " = " << before;
      ++kept;
    } catch (const Error&) {
    }
    value = before;
  }
}

TEST(Description, KeepsEveryValue) {
  Json json = canonical();
  int kept = 0;
  changeEach(json, pipelineFromJson(json), json, kept);
  EXPECT_GT(kept, 80);
}

// Each value replaced by a value of another type is refused or harmless; the only exception is Error.
static void damageAll(const Json& whole, Json& part, int& refused, int& tried) {
  static const Json odd[] = {nullptr,      true, -1, 1e300, 18446744073709551615u, "\x01", Json::array({Json::array()}),
                             {{"name", 3}}};
  if (!part.is_structured()) return;
  for (auto it = part.begin(); it != part.end(); ++it) {
    Json kept = *it;
    for (const Json& other : odd) {
      *it = other;
      ++tried;
      EXPECT_NO_FATAL_FAILURE(refused += refusal(whole) != "none");
    }
    *it = kept;
    damageAll(whole, *it, refused, tried);
  }
}

TEST(Description, DamageThrowsOnlyErrors) {
  Json json = canonical();
  int refused = 0, tried = 0;
  damageAll(json, json, refused, tried);
  EXPECT_GT(tried, 1000);
  EXPECT_GT(refused, tried * 8 / 10);  // the rest are texts, flags and places without further limits
}

TEST(Description, MissingKeysAreRefused) {
  for (const char* key : {"name", "file"}) {
    Json json = canonical();
    json.erase(key);
    EXPECT_NE(refusal(json).find(key), std::string::npos);
  }
  Json json = canonical();
  json["outputs"].erase("color");
  EXPECT_EQ(refusal(json), "p.lua: pipeline 'p' has no output 'color'");
  EXPECT_EQ(refusal(Json::array()), "pipeline: needs 'name'");
  EXPECT_EQ(refusal(nullptr), "pipeline: expected a table, got null");
}

struct Change {
  const char* pointer;
  Json value;
  const char* error;
};

TEST(Description, ReferencesAndRangesAreChecked) {
  const Change changes[] = {
      {"/nodes/1/inputs/image", "source.colour",
       "p.lua:9: node 'far' reads 'source.colour', but pass 'source' does not write 'colour'; did you mean 'color'?"},
      {"/nodes/1/inputs/image", "far.sum", "p.lua:9: cycle: far -> far"},
      {"/nodes/1/inputs/image", "source", "p.lua:9: node 'far' reads 'source', which is a node and not an image"},
      {"/nodes/1/inputs/image", 3, "p.lua:9: node: 'image' of 'inputs' is not a text"},
      {"/nodes/1/inputs/image", "source.id", "p.lua:9: node 'far' reads 'image' as numbers, but 'source.id' is r32ui"},
      {"/nodes/1/inputs/id", "source.color",
       "p.lua:9: node 'far' reads 'id' as unsigned integers, but 'source.color' is rgba16f"},
      {"/nodes/1/inputs", Json::object(), "p.lua:9: node 'far' lacks the input 'image' of pass 'blur'"},
      {"/nodes/1/pass", "blurr", "p.lua:9: node 'far' uses unknown pass 'blurr'; did you mean 'blur'?"},
      {"/nodes/1/name", "source", "p.lua: two nodes named 'source'"},
      {"/nodes/1/name", "Far", "p.lua:9: node: 'Far' is not a name (a-z, then a-z, 0-9 and _)"},
      {"/nodes/1/loop", "m", "p.lua:9: node 'far' is in unknown loop 'm'"},
      {"/nodes/1/loop", "", "p.lua:9: node 'far' has time 'sample' but is not in a loop"},
      {"/nodes/1/time", "now",
       "p.lua:9: node: 'time' = 'now' is not one of raster, shutter_open, shutter_close, sample"},
      {"/nodes/1/params/k/value", 2, "p.lua:9: 'k' = 2 is above max 1 (range 0 to 1)"},
      {"/nodes/1/params/by/follows", "mode", "p.lua:9: 'by' = 'b' is not an integer"},
      {"/nodes/1/params/by/follows", "m", "p.lua:9: pipeline 'p' has no parameter 'm'; did you mean 'n'?"},
      {"/nodes/1/params/by", {{"value", 1}, {"follows", "n"}}, "parameter 'by': needs either 'value' or 'follows'"},
      {"/nodes/1/colour", 1, "p.lua:9: node: unknown key 'colour'"},
      {"/values/n", 10, "p.lua:4: 'n' = 10 is above max 9 (range 1 to 9 px)"},
      {"/values/m", 1, "p.lua: 'values' has unknown parameters"},
      {"/params/0/default", "c", "p.lua:3: 'mode' = 'c' is not one of a, b"},
      {"/params/1/min", 20, "p.lua:4: parameter: min of 'n' is above max"},
      {"/params/1/role", "quality", "p.lua:4: parameter: 'n' has the role 'quality', which needs a float with a range"},
      {"/passes/1/name", "source", "p.lua: two passes named 'source'"},
      {"/passes/1/shader", "../../etc/passwd", "b.lua:1: pass 'blur': '../../etc/passwd' is not a path below shaders/"},
      {"/passes/1/shader", "/etc/passwd", "b.lua:1: pass 'blur': '/etc/passwd' is not a path below shaders/"},
      {"/passes/1/writes/0/format", "rgb9", "b.lua:4: write: 'format' = 'rgb9' is not one of"},
      {"/passes/1/writes/1/format_by", "q",
       "b.lua:8: pass 'blur': the format of 'v' is chosen by 'q', which is not a parameter of the pass"},
      {"/passes/1/writes/1/format_by", "by",
       "b.lua:8: pass 'blur': the format of 'v' is chosen by 'by', which is not a choice parameter of the pass"},
      {"/passes/1/writes/1/formats/h", "rg16",
       "b.lua:8: pass 'blur': the format of 'v' is chosen by 'p', but format 'rg16' is unknown; did you mean 'rg16f'?"},
      {"/passes/1/writes/1/formats/h", "rg32ui",
       "b.lua:8: pass 'blur': the format of 'v' is chosen by 'p', but the formats mix unsigned integers and numbers"},
      {"/passes/1/writes/1/formats/f", "rg16f",
       "b.lua:8: pass 'blur': the format of 'v' is chosen by 'p', but the format of the default is not rg32f"},
      {"/passes/1/writes/1/formats",
       {{"f", "rg32f"}},
       "b.lua:8: pass 'blur': the format of 'v' is chosen by 'p', but 'formats' does not have one format for each "
       "choice"},
      {"/passes/1/writes/1/formats",
       {{"f", "rg32f"}, {"g", "rg16f"}},
       "b.lua:8: pass 'blur': the format of 'v' is chosen by 'p', which has no choice 'g'"},
      {"/passes/1/size/port", "id",
       "b.lua:9: pass 'blur': its size is of 'id', which is not a read that is always wired"},
      {"/passes/1/size/divide", "k",
       "b.lua:9: pass 'blur': its size is divided by 'k', which is not an integer parameter of at least 1"},
      {"/passes/1/size",
       {{"kind", "fixed"}, {"width", 0}, {"height", 1}},
       "b.lua:1: size of pass 'blur': 'width' = 0 is below min 1"},
      {"/passes/0/writes", Json::array(), "s.lua:4: pass 'source' if_no: 'writes' has unknown writes"},
      {"/loops/0/count", {{"value", 0}}, "count of loop 'l' must be an integer from 1 to 1048576"},
      {"/loops/0/until", "source.color", "p.lua:7: loop 'l' stops on 'source.color', which is not in the loop"},
      {"/outputs/raw", "source.raw", "p.lua: output 'raw' reads 'source.raw', but pass 'source' does not write 'raw'"},
      {"/outputs/raw", 3, "p.lua: pipeline: 'raw' of 'outputs' is not a text"},
  };
  for (const Change& change : changes) {
    Json json = canonical();
    json[Json::json_pointer(change.pointer)] = change.value;
    EXPECT_EQ(refusal(json).substr(0, std::string(change.error).size()), change.error) << change.pointer;
  }
}

static ParamDesc param(ParamDesc::Type type) {
  ParamDesc p;
  p.name = "x";
  p.type = type;
  p.min = -1;
  p.max = 10;
  p.choices = {"red", "green"};
  return p;
}

TEST(CheckValue, ConvertsCommandLineText) {
  EXPECT_EQ(checkValue(param(ParamDesc::Type::Int), std::string("7"), {}), Value(int64_t{7}));
  EXPECT_EQ(checkValue(param(ParamDesc::Type::Int), std::string("7.0"), {}), Value(int64_t{7}));
  EXPECT_EQ(checkValue(param(ParamDesc::Type::Int), 7.0, {}), Value(int64_t{7}));
  EXPECT_EQ(checkValue(param(ParamDesc::Type::Float), int64_t{7}, {}), Value(7.0));
  EXPECT_EQ(checkValue(param(ParamDesc::Type::Float), std::string("1e-3"), {}), Value(0.001));
  EXPECT_EQ(checkValue(param(ParamDesc::Type::Bool), std::string("true"), {}), Value(true));
  EXPECT_EQ(checkValue(param(ParamDesc::Type::Choice), std::string("red"), {}), Value(std::string("red")));
  EXPECT_FALSE(std::signbit(std::get<double>(checkValue(param(ParamDesc::Type::Float), -0.0, {}))));
}

TEST(CheckValue, RefusesOtherTypesAndValuesOutOfRange) {
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  const Value wrong_ints[] = {2.5,
                              true,
                              std::string("2.5"),
                              std::string(" 2"),
                              std::string("2x"),
                              std::string(""),
                              int64_t{11},
                              int64_t{-2},
                              INT64_MAX,
                              kNan,
                              1e300};
  for (const Value& value : wrong_ints) EXPECT_THROW(checkValue(param(ParamDesc::Type::Int), value, {}), Error);
  const Value wrong_numbers[] = {true, std::string("nan"), std::string("inf"), std::string("1,5"), 10.001, -1.001,
                                 kNan};
  for (const Value& value : wrong_numbers) EXPECT_THROW(checkValue(param(ParamDesc::Type::Float), value, {}), Error);
  const Value wrong_flags[] = {int64_t{1}, 1.0, std::string("yes"), std::string("1")};
  for (const Value& value : wrong_flags) EXPECT_THROW(checkValue(param(ParamDesc::Type::Bool), value, {}), Error);
  try {
    checkValue(param(ParamDesc::Type::Choice), std::string("gren"), {"f.lua", 3});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "f.lua:3: 'x' = 'gren' is not one of red, green; did you mean 'green'?");
  }
}

}  // namespace description_test
}  // namespace strobe::plan
