// SPDX-License-Identifier: MIT
#include "base/limits.h"

#include <algorithm>

#include "base/error.h"

namespace strobe {

const std::vector<Limit>& limits() {
  static const std::vector<Limit> table = {
      {"before_clip", false, "the exposure begins before a clip of keys does",
       "what is keyed is held at its first keys there; take a later frame, a shorter exposure or another anchor"},
      {"clip_seam", false, "the exposure spans the end of a clip, which then begins again",
       "what is keyed jumps back within the exposure and is blurred over the whole jump; take a frame whose exposure "
       "lies within the clip"},
  };
  return table;
}

std::string limitText(const std::string& name, const std::string& facts) {
  auto found = std::find_if(limits().begin(), limits().end(), [&](const Limit& limit) { return limit.name == name; });
  STROBE_ASSERT(found != limits().end(), "{}", name);
  return facts + "; " + found->result;
}

}  // namespace strobe
