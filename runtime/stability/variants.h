// SPDX-License-Identifier: MIT
// Variants of a pipeline, found by walking its declarations: its defaults or presets, and for each of these bases every
// value of every parameter that selects a shader or a graph. New parameters and files need no change here.
#pragma once

#include "lab/batch.h"

namespace strobe::stability {

// A pipeline with one combination of settings to test.
struct Variant {
  std::string pipeline;   // name or file
  script::Settings sets;  // the preset first, if any
  std::shared_ptr<const plan::PipelineDesc> description;

  bool isBase() const;         // the defaults or a preset, without other values
  std::string name() const;    // "preset=best jitter=hash"; "defaults"
  std::string method() const;  // "pipeline preset=best jitter=hash"; "pipeline"
};

// A setting, or a test case, that a pipeline does not accept, with the reason.
struct Refused {
  std::string name, reason;
};

// Distinct variants of a pipeline, with the refused settings and the number of settings that give the plan of another
// variant.
struct VariantList {
  std::vector<Variant> variants;
  std::vector<Refused> refused;  // values that the pipeline refuses
  int same = 0;                  // values that give a known plan
};

// Walks the bases, their values, and the parameters of nodes that only a value adds to the graph. Settings with equal
// plans are one variant. Throws `Error` if the pipeline without settings cannot be evaluated.
VariantList walk(lab::Batch& batch, const std::string& pipeline);

// A declared break of an invariant.
struct Declared {
  std::string where;  // "jitter = hash", "pass gather_x", "pipeline"
  std::string reason;
  std::string key;  // unique; equal in all pipelines with the declaration
};

// Declared breaks of `invariant` by the pipeline, its passes and its current values.
std::vector<Declared> declaredBreaks(const plan::PipelineDesc& pipeline, const std::string& invariant);

// Value of a pipeline parameter as a number; `otherwise` if the parameter does not exist.
double numberOf(const plan::PipelineDesc& pipeline, const std::string& param, double otherwise);
double numberOf(const plan::PipelineDesc& pipeline, plan::Role role, double otherwise);

// Least common multiple of the divisors of all image sizes, px. The sides of a picture must be multiples.
int gridOf(const plan::PipelineDesc& pipeline);

}  // namespace strobe::stability
