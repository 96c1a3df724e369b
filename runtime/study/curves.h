// SPDX-License-Identifier: MIT
// Curves along one axis of an experiment: error of each arm as a share of the picture's contrast, and the range where
// the arm is trusted.
#pragma once

#include "study/results.h"

namespace strobe::study {

// Reason for not trusting an arm at a value: error too large, limit met, or colours that are not finite.
enum class Doubt { none, error, limit, broken };

// Reference of the largest allowed error. `floor`: `factor` times the floor. `own`: `factor` times the floor or the
// arm's own error at the benign value, whichever is larger. Both add three standard errors of truth.
enum class Against { floor, own };

// Range of values around the benign value where an arm is trusted; empty if the benign value is not trusted.
struct Trusted {
  size_t first = 0, count = 0;
  Doubt below = Doubt::none, above = Doubt::none;  // reason for the end on either side

  bool holds(size_t value) const { return value >= first && value < first + count; }
};

// One axis; values that were not measured are left out. The results must outlive the curve.
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

  // Error of an arm, error of the floor and standard error of truth, as shares of the contrast. `region` "": the region
  // of the axis.
  double error(const std::string& arm, size_t i, const std::string& region = "") const;
  double floor(size_t i, const std::string& region = "") const;
  double sigma(size_t i, const std::string& region = "") const;

  Doubt doubt(const std::string& arm, size_t i, Against against) const;
  Trusted trusted(const std::string& arm, Against against) const;
  // Trusted range as text: "everywhere", "2 (error below) to 31 (limit above)", "nowhere".
  std::string range(const std::string& arm, Against against) const;

  // Replaces {ARM @ VALUE} in `text` by the error of the arm at the value. ARM "floor" gives the floor, "truth" the
  // standard error of truth. {from ARM} and {to ARM} give the ends of the range trusted by `Against::own`. Throws
  // `Error` for other text in braces.
  std::string filled(const std::string& text) const;

 private:
  std::string replacement(const std::string& inside) const;

  const Results& results_;
  const AxisSummary& axis_;
  double factor_;
  std::vector<const PointGroup*> groups_;
  std::vector<size_t> values_;  // indices of values of the axis
  size_t benign_ = 0;
};

// Curves of all axes that have curves and were measured at their benign value.
std::vector<Curve> curvesIn(const Results& results, double factor);

// Replaces each {...} in `text` by the result of `replace` for the text in braces.
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
