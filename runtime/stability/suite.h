// SPDX-License-Identifier: MIT
// All invariants for all variants of pipelines, counted; failures shrunk to a small case with the commands that repeat
// it.
#pragma once

#include <set>

#include "stability/invariants.h"

namespace strobe::stability {

struct Options {
  int cases = 1;  // of each variant and invariant
  uint64_t seed = 1;
  std::vector<std::string> invariants;  // empty: all
  std::string only;                     // variants whose name contains this
  int shard = 0, shards = 1;            // every so many-th variant alone
  int thinned = 1;                      // of what is no base, one in so many pairs of variant and invariant, drawn
};

// Cases of one variant and invariant.
struct Count {
  int held = 0, broken = 0, failed = 0, refused = 0;  // broken: as declared
};

struct Failure {
  std::string variant, invariant, text;
  std::vector<std::string> commands;  // the pictures that contradict each other
};

struct Declaration {
  std::string where, invariant, reason;
  int used = 0, seen = 0;  // cases in which it counts, and in which the invariant was broken
};

struct Report {
  std::string pipeline;
  std::vector<std::pair<std::string, std::map<std::string, Count>>> variants;  // by invariant
  std::vector<Refused> refused;
  int same = 0;
  std::vector<Failure> failures;
  std::set<std::string> rounded;  // images in 16-bit floats of variants that failed: "smear.color, rgba16f"
  std::map<std::string, Declaration> declarations;
  int blurred = 0, drawn = 0;  // cases whose picture is not the sharp one, and all cases
  int pictures = 0;

  Count total(const std::string& invariant = "") const;
};

// Throws `Error` where the pipeline cannot be evaluated; what a single variant refuses is counted.
Report check(lab::Batch& batch, const std::string& pipeline, const Options& options);

// Declarations that none of at least twelve cases needed, of reports that share them. Without `all_pipelines`, only
// declarations of the pipelines themselves: those of passes and values may be needed by other pipelines.
std::vector<Declaration> stale(const std::vector<Report>& reports, bool all_pipelines = true);

// For the terminal, a line of counts, the failures, and how many of each invariant; the page docs/stability.md; data.
std::string textOf(const Report& report);
std::string pageOf(const std::vector<Report>& reports, const Options& options);
Json toJson(const Report& report);

}  // namespace strobe::stability
