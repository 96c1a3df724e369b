// SPDX-License-Identifier: MIT
// Every variant of a pipeline, found by walking what it declares: its defaults and presets, and from each of these
// every value of every parameter that decides which shader or which graph runs. A new parameter or file is walked
// without a word here.
#pragma once

#include "lab/batch.h"

namespace strobe::stability {

struct Variant {
  std::string pipeline;   // name or file
  script::Settings sets;  // the preset first, if any
  std::shared_ptr<const plan::PipelineDesc> description;

  bool isBase() const;       // the defaults or a preset, no other value
  std::string name() const;  // "preset=best jitter=hash"; "defaults"
};

struct Refused {
  std::string name, reason;
};

struct Walk {
  std::vector<Variant> variants;
  std::vector<Refused> refused;  // values that a context does not take
  int same = 0;                  // values that change nothing there
};

// Bases, their values, and the parameters of nodes that only a value brings into the graph. Two variants that run the
// same plan are one. Throws `Error` where the pipeline alone cannot be evaluated.
Walk walk(lab::Batch& batch, const std::string& pipeline);

// A declaration that an invariant does not hold.
struct Declared {
  std::string where;  // "jitter = hash", "pass gather_x", "pipeline"
  std::string reason;
  std::string key;  // one per declaration, in all pipelines that have it
};

// Those that count for `invariant` in what runs: of the pipeline, of the passes in use and of the values in use.
std::vector<Declared> declaredBreaks(const plan::PipelineDesc& pipeline, const std::string& invariant);

// The value of a parameter of the pipeline as a number; `otherwise` where there is no such parameter.
double numberOf(const plan::PipelineDesc& pipeline, const std::string& param, double otherwise);
double numberOf(const plan::PipelineDesc& pipeline, plan::Role role, double otherwise);

// The pixels into whose multiples the picture is divided: the least common multiple of what sizes are divided by.
int gridOf(const plan::PipelineDesc& pipeline);

}  // namespace strobe::stability
