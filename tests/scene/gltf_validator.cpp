// SPDX-License-Identifier: MIT
#include "scene/gltf_validator.h"

#include <cstdlib>
#include <map>

#include "base/process.h"
#include "common/refusal.h"
#include "common/source.h"

namespace strobe::scene {

static std::string modules() {
  const char* given = std::getenv("STROBE_NODE_MODULES");
  return given ? given : "";
}

bool hasValidator() {
  ProgramEnd end = run({.arguments = {"sh", "-c", "command -v node"}});
  return end.succeeded() && std::filesystem::is_directory(Path(modules()) / "gltf-validator");
}

// The validator's errors for each file, found by one process.
static std::map<std::string, std::vector<std::string>> errorsIn(const std::vector<Path>& files) {
  const std::string script = sourceFolder() / "tests/scene/gltf_validator.js";
  std::string names = fmt::format("{}", fmt::join(std::vector<std::string>(files.begin(), files.end()), "\n"));
  const ProgramEnd end = run({.arguments = {"node", script}, .environment = {"NODE_PATH=" + modules()}, .input = [&] {
                                return std::exchange(names, {});
                              }});
  EXPECT_TRUE(end.succeeded()) << end.errors;
  return end.succeeded() ? Json::parse(end.output).get<std::map<std::string, std::vector<std::string>>>()
                         : std::map<std::string, std::vector<std::string>>();
}

std::string refusalOf(const Path& file) {
  return testing::refusalOf([&] { loadGltf(file); });
}

const Exceptions& accepted() {
  auto of = [](const std::string& text) { return std::regex(text, std::regex::optimize); };
  static const Exceptions all = {
      {of("EMPTY_ENTITY .*"), "empty lists"},
      {of("DUPLICATE_ELEMENTS /extensions(Used|Required)/.*"), "an extension that is listed twice"},
      {of("(NON_REQUIRED_EXTENSION|UNUSED_EXTENSION_REQUIRED) .*"),
       "only one of `extensionsUsed` and `extensionsRequired`"},
      {of("MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS .*"), "`min` and `max`"},
      {of("ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS .*"), "`min` and `max`"},
      {of("ACCESSOR_(MIN_MISMATCH|MAX_MISMATCH|ELEMENT_OUT_OF_MIN_BOUND|ELEMENT_OUT_OF_MAX_BOUND) .*"),
       "`min` and `max`"},
      {of("ACCESSOR_VECTOR3_NON_UNIT .*"), "normals, tangents and animated quaternions that are not of length 1"},
      {of("ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION .*"),
       "animated quaternions that are not of length 1"},
      {of("ROTATION_NON_UNIT .*"), "quaternions of nodes whose length differs from 1 by less than a hundredth"},
      {of("ACCESSOR_(WEIGHTS_NON_NORMALIZED|JOINTS_INDEX_DUPLICATE) .*"),
       "weights of vertices that do not add up to 1"},
      {of("ACCESSOR_NON_CLAMPED .*"), "colours above 1"},
      {of("ACCESSOR_INVALID_FLOAT .*"), "numbers that are not finite"},
      {of("NODE_MATRIX_NON_TRS .*"), "a matrix with shear or without volume"},
      {of("ANIMATION_CHANNEL_TARGET_NODE_MATRIX .*"), "an animated node with a matrix"},
      {of("(SKIN_NO_COMMON_ROOT|NODE_SKIN_NO_SCENE|SKIN_SKELETON_INVALID) .*"),
       "joints of a skin without a common root"},
      {of("ACCESSOR_(OFFSET_ALIGNMENT|TOTAL_OFFSET_ALIGNMENT|MATRIX_ALIGNMENT) .*"), "alignment"},
      {of("MESH_PRIMITIVE_ACCESSOR_(UNALIGNED|WITHOUT_BYTESTRIDE) .*"), "alignment"},
      {of("BUFFER_VIEW_(INVALID|TOO_BIG)_BYTE_STRIDE .*"), "alignment"},
      {of("[A-Z_]*_WITH_BYTESTRIDE .*"), "alignment"},
      {of("Invalid argument\\(s\\): start offset of .* should be a multiple of .*"), "alignment"},
      {of("(BUFFER_VIEW_TARGET_OVERRIDE|ACCESSOR_USAGE_OVERRIDE) .*"), "`target` of buffer views"},
      {of("(IMAGE_[A-Z_]*|INVALID_URI|IO_ERROR|VALUE_NOT_IN_LIST|UNSATISFIED_DEPENDENCY) /images/.*"),
       "images whose content does not match"},
      {of("TEXTURE_INVALID_IMAGE_MIME_TYPE .*"), "images whose content does not match"},
      {of("BUFFER_DATA_URI_MIME_TYPE_INVALID .*"), "media type of a data URI"},
      {of("MESH_PRIMITIVE_TOO_FEW_TEXCOORDS .*"), "textures on a primitive without texture coordinates"},
      {of("VALUE_NOT_IN_LIST /animations/.*/path"), "an unknown animation path"},
      {of(".*/extensions/(?!(KHR_lights_punctual|KHR_materials_unlit|KHR_texture_transform|KHR_materials_variants|"
          "KHR_materials_emissive_strength|KHR_animation_pointer)(/|$)).*"),
       "contents of extensions that Strobe does not read"},
  };
  return all;
}

const Exceptions& refusedAllTheSame() {
  static const Exceptions all = {
      {std::regex(".*requires .*, which is not supported"), "requires another extension"},
      {std::regex(".*'(yfov|xmag|ymag|aspectRatio|znear|zfar)' is .*, not .*"), "cameras without a picture"},
      {std::regex(".*needs .* of memory.*"), "memory"},
      {std::regex(".*extras.*'cuts'.*"), "`cuts`"},
      {std::regex(".*cannot be decoded.*|.*bytes are damaged.*"), "compressed streams"},
      {std::regex(".*cannot be read: No such file.*"), "backslash"},
  };
  return all;
}

static bool isListed(const std::string& text, const Exceptions& list) {
  return std::any_of(list.begin(), list.end(), [&](const auto& one) { return std::regex_match(text, one.first); });
}

Tally expectAgreement(const std::vector<Path>& files, const std::function<std::string(size_t)>& describe) {
  std::map<std::string, std::vector<std::string>> errors = errorsIn(files);
  Tally tally;
  for (size_t i = 0; i < files.size(); ++i) {
    const std::vector<std::string>& found = errors[files[i].string()];
    const std::string refusal = refusalOf(files[i]);
    const bool listed =
        std::all_of(found.begin(), found.end(), [](const auto& one) { return isListed(one, accepted()); });
    (!refusal.empty() ? tally.refused : found.empty() ? tally.loaded : tally.listed) += 1;
    const std::string what = describe(i) + "\n  validator: " + fmt::format("{}", fmt::join(found, ", "));
    EXPECT_TRUE(listed || !refusal.empty()) << what;
    const bool expected = refusal.empty() || !found.empty() || isListed(refusal, refusedAllTheSame());
    EXPECT_TRUE(expected) << what << "\n  here: " << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << what;
  }
  return tally;
}

}  // namespace strobe::scene
