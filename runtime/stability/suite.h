// SPDX-License-Identifier: MIT
// Checks all invariants for all variants of a pipeline. Each failure is shrunk to a small case with the commands that
// repeat it.
#pragma once

#include <set>

#include "stability/invariants.h"

namespace strobe::stability {

// Options of an invariant test: cases per variant, random seed, selected invariants and variants, and shard.
struct Options {
  int cases = 1;  // per variant and invariant
  uint64_t seed = 1;
  std::vector<std::string> invariants;  // empty: all
  std::string only;                     // only variants with this text in the name
  int shard = 0, shards = 1;            // checks every `shards`-th variant, from number `shard`
  int thinned = 1;  // except for defaults and presets: check one random pair of variant and invariant in so many
};

// Numbers of cases of one variant and invariant.
struct Count {
  int held = 0, broken = 0, failed = 0, refused = 0;  // broken: as declared
};

// A case that breaks an invariant without a declared exception, or cannot be drawn, with the commands that repeat it.
struct Failure {
  std::string variant, invariant, text;
  std::vector<std::string> commands;  // draw the contradictory pictures
};

// A declared exception from an invariant, with its reason, and counts of cases it covers and of cases that need it.
struct Declaration {
  std::string where, invariant, reason;
  int used = 0, seen = 0;  // cases it applies to; cases among them that break the invariant
};

// Results of the invariant tests of one pipeline: counts by variant and invariant, failures, refused settings and
// declared exceptions.
struct StabilityReport {
  std::string pipeline;
  std::vector<std::pair<std::string, std::map<std::string, Count>>> variants;  // by variant, then invariant
  std::vector<Refused> refused;
  int same = 0;
  std::vector<Failure> failures;
  std::set<std::string> rounded;  // 16-bit float images of variants that failed: "smear.color, rgba16f"
  std::map<std::string, Declaration> declarations;
  int blurred = 0, drawn = 0;  // cases where the picture differs from the sharp one; all cases
  int pictures = 0;

  Count total(const std::string& invariant = "") const;
};

// Throws `Error` if the pipeline cannot be evaluated; a refused variant is counted.
StabilityReport check(lab::Batch& batch, const std::string& pipeline, const Options& options);

// Declarations that no case of at least twelve needed, summed over `reports`. Without `all_pipelines`, only
// declarations of pipelines, because other pipelines may need the declarations of passes and values.
std::vector<Declaration> stale(const std::vector<StabilityReport>& reports, bool all_pipelines = true);

// Text for the terminal: counts, failures, failed cases by invariant; the page docs/stability.md; data.
std::string textOf(const StabilityReport& report);
std::string pageOf(const std::vector<StabilityReport>& reports, const Options& options);
Json toJson(const StabilityReport& report);

}  // namespace strobe::stability
