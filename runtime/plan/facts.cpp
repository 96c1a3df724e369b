// SPDX-License-Identifier: MIT
#include "plan/facts.h"

#include "plan/named.h"

namespace strobe::plan {

const std::vector<Fact>& facts() {
  static const std::vector<Fact> facts = {
      {"motion", "nothing moves in this frame"},
      {"curves", "every moving point crosses the picture in a straight line at constant speed"},
      {"alpha", "no material is cut out or blended by its alpha", true},
      {"blend", "no material is blended by its alpha", true},
      {"one_sided", "every material is visible from both sides", true},
      {"shadows", "no light casts shadows", true},
      {"deforms", "nothing is deformed by joints, morph targets or a flat transform", true},
      {"before", "the exposure has no part before the raster time"},
      {"after", "the exposure has no part after the raster time"},
      {"weighted", "all times of the exposure have equal weight", false, true},
  };
  return facts;
}

const Fact* findFact(const std::string& name) { return find(facts(), name); }

}  // namespace strobe::plan
