// SPDX-License-Identifier: MIT
#include "base/limits.h"

#include <algorithm>

#include "base/error.h"

namespace strobe {

const std::vector<Limit>& limits() {
  static const std::vector<Limit> table = {
      {"before_clip", Limit::Kind::Warned, "the exposure begins before a clip of keys does",
       "what is keyed is held at its first keys there; take a later frame, a shorter exposure or another anchor"},
      {"clip_seam", Limit::Kind::Warned, "the exposure spans the end of a clip, which then begins again",
       "what is keyed jumps back within the exposure and is blurred over the whole jump; take a frame whose exposure "
       "lies within the clip"},
      {"coplanar", Limit::Kind::Known, "two surfaces lie in one place, to within the rounding of their depths",
       "one of them is seen, and raster and rays may differ as to which; where depths are equal to the last bit the "
       "first in the scene is. Move them apart by 1/100000 of their distance"},
      {"outside", Limit::Kind::Known, "what the exposure shows was outside of the picture at the capture",
       "filters of one picture know nothing of it, and what is at the border stands in; truth shows it. Render a "
       "larger picture and crop it"},
      {"large_mesh", Limit::Kind::Known, "a mesh is more than a million times as large as what the picture shows of it",
       "its vertices are single-precision numbers: they are rounded to 1/16 millionth of its size. Split it"},
      {"instances", Limit::Kind::Refused, "a scene has more instances than the device's acceleration structures",
       "nothing is drawn; merge meshes, or take another device"},
      {"triangles", Limit::Kind::Refused, "a mesh has more triangles than the device's acceleration structures",
       "nothing is drawn; split the mesh"},
      {"geometries", Limit::Kind::Refused, "a mesh has more parts than the device's acceleration structures",
       "nothing is drawn; merge its materials, or split it"},
      {"buffers", Limit::Kind::Refused, "a scene's buffer is larger than what a shader may see of one",
       "nothing is drawn; take fewer vertices or instances, fewer `slices` of truth, or another device"},
      {"images", Limit::Kind::Refused, "a picture or texture is larger than the device's images",
       "nothing is drawn; take a smaller one"},
      {"transforms", Limit::Kind::Refused, "a node's transform is not finite, or farther from the camera than 1e18",
       "nothing is drawn; look at the scales and translations of it and of the nodes it is in"},
  };
  return table;
}

std::string limitText(const std::string& name, const std::string& facts) {
  auto found = std::find_if(limits().begin(), limits().end(), [&](const Limit& limit) { return limit.name == name; });
  STROBE_ASSERT(found != limits().end(), "{}", name);
  return facts + "; " + found->result;
}

}  // namespace strobe
