// SPDX-License-Identifier: MIT
// An axis of an experiment's results as curves: errors of each arm as a share of the picture's contrast, and where an
// arm is as good as its samples allow.
#pragma once

#include "study/results.h"

namespace strobe::study {

// Why an arm is not to be trusted at a value.
enum class Doubt { none, error, limit, broken };

// What an error is held against: `factor` times the floor; or that or `factor` times the arm's own at the benign value,
// whichever is larger. Three standard errors of truth are always allowed.
enum class Against { floor, own };

// The values about the benign one at which an arm is trusted; empty where it is not trusted there.
struct Trusted {
  size_t first = 0, count = 0;
  Doubt below = Doubt::none, above = Doubt::none;  // what ends it on either side

  bool holds(size_t value) const { return value >= first && value < first + count; }
};

// One axis; the results must outlive it. Values that were not measured are left out.
class Curve {
 public:
  Curve(const Results& results, const AxisSummary& axis, double factor);

  const AxisSummary& axis() const { return axis_; }
  size_t size() const { return groups_.size(); }
  size_t benign() const { return benign_; }
  double value(size_t i) const;  // of the axis
  const std::string& label(size_t i) const;
  const PointGroup& group(size_t i) const { return *groups_[i]; }
  std::vector<std::string> arms() const;  // methods, in order
  double contrast() const;                // of truth at the benign value

  // Shares of the contrast in the axis' own region (or another).
  double error(const std::string& arm, size_t i, const std::string& region = "") const;
  double floor(size_t i, const std::string& region = "") const;
  double sigma(size_t i, const std::string& region = "") const;

  Doubt doubt(const std::string& arm, size_t i, Against against) const;
  Trusted trusted(const std::string& arm, Against against) const;
  // "everywhere", "2 (error below) to 31 (limit above)", "nowhere".
  std::string range(const std::string& arm, Against against) const;

  // `text` with {ARM @ VALUE} replaced by the error of that arm, the floor or truth's standard error ("truth") there,
  // {from ARM} and {to ARM} by the ends of where it keeps its usual error. Throws `Error` for anything else in braces.
  std::string filled(const std::string& text) const;

 private:
  std::string replacement(const std::string& inside) const;

  const Results& results_;
  const AxisSummary& axis_;
  double factor_;
  std::vector<const PointGroup*> groups_;
  std::vector<size_t> values_;  // of the axis, by number
  size_t benign_ = 0;
};

// The axes that have curves and were measured at their benign value.
std::vector<Curve> curvesIn(const Results& results, double factor);

// `text` with what is in braces replaced.
template <class Replace>
std::string replaced(const std::string& text, const Replace& replace) {
  std::string result;
  for (size_t at = 0; at < text.size();) {
    size_t open = text.find('{', at), close = text.find('}', open);
    if (open == std::string::npos || close == std::string::npos) return result + text.substr(at);
    result += text.substr(at, open - at) + replace(text.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return result;
}

}  // namespace strobe::study
