// SPDX-License-Identifier: MIT
#include "study/curves.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "page/number.h"

namespace strobe::study {

using page::shownShare;

namespace {

const char* wordOf(Doubt doubt) {
  switch (doubt) {
    case Doubt::error:
      return "error";
    case Doubt::limit:
      return "limit";
    case Doubt::broken:
      return "not finite";
    case Doubt::none:
      break;
  }
  return "";
}

// Groups on this axis and no other, from the first shot with such groups.
std::vector<const PointGroup*> groupsAlong(const Results& results, const std::string& axis) {
  std::vector<const PointGroup*> groups;
  for (const PointGroup& group : results.groups) {
    bool along = group.at.size() == 1 && group.at[0].first == axis;
    if (along && (groups.empty() || groups.front()->shot == group.shot)) groups.push_back(&group);
  }
  return groups;
}

}  // namespace

Curve::Curve(const Results& results, const AxisSummary& axis, double factor)
    : results_(results), axis_(axis), factor_(factor) {
  std::vector<const PointGroup*> along = groupsAlong(results, axis.name);
  for (size_t value = 0; value < axis.values.size(); ++value)
    for (const PointGroup* group : along) {
      if (group->at[0].second != axis.values[value]) continue;
      if (value == axis.benign) benign_ = groups_.size();
      groups_.push_back(group);
      values_.push_back(value);
    }
}

double Curve::value(size_t i) const { return axis_.values[values_[i]].get<double>(); }
const std::string& Curve::label(size_t i) const { return axis_.labels[values_[i]]; }
double Curve::contrast() const { return groups_[benign_]->truth().value("contrast"); }

std::vector<std::string> Curve::arms() const {
  std::vector<std::string> names;
  for (const ArmSummary& arm : results_.arms)
    if (arm.role == ArmRole::method && groups_[benign_]->find(arm.name)) names.push_back(arm.name);
  return names;
}

static double shareOf(const Point* point, const std::string& region, double contrast) {
  return point ? point->value("rmse", region) / contrast : std::numeric_limits<double>::quiet_NaN();
}

double Curve::error(const std::string& arm, size_t i, const std::string& region) const {
  return shareOf(groups_[i]->find(arm), region.empty() ? axis_.region : region, contrast());
}

double Curve::floor(size_t i, const std::string& region) const {
  return shareOf(groups_[i]->floor(), region.empty() ? axis_.region : region, contrast());
}

double Curve::sigma(size_t i, const std::string& region) const {
  return shareOf(&groups_[i]->truth(), region.empty() ? axis_.region : region, contrast());
}

// A region without pixels gives `Doubt::none`: its errors are NaN, fmax ignores NaN, and comparisons with NaN are
// false.
Doubt Curve::doubt(const std::string& arm, size_t i, Against against) const {
  const Point* point = groups_[i]->find(arm);
  if (!point) return Doubt::none;
  if (point->value("broken") > 0) return Doubt::broken;
  if (!point->limits.empty()) return Doubt::limit;
  double own = against == Against::own ? error(arm, benign_) : 0;
  double allowed = factor_ * std::fmax(own, floor(i)) + 3 * sigma(i);
  return error(arm, i) > allowed ? Doubt::error : Doubt::none;
}

Trusted Curve::trusted(const std::string& arm, Against against) const {
  Trusted trusted{benign_, 0, Doubt::none, Doubt::none};
  trusted.below = trusted.above = doubt(arm, trusted.first, against);
  if (trusted.below != Doubt::none) return trusted;
  while (trusted.first > 0 && (trusted.below = doubt(arm, trusted.first - 1, against)) == Doubt::none) --trusted.first;
  size_t end = benign_ + 1;
  while (end < size() && (trusted.above = doubt(arm, end, against)) == Doubt::none) ++end;
  trusted.count = end - trusted.first;
  return trusted;
}

std::string Curve::range(const std::string& arm, Against against) const {
  Trusted kept = trusted(arm, against);
  if (kept.count == 0) {
    bool anywhere = false;
    for (size_t i = 0; i < size(); ++i) anywhere |= doubt(arm, i, against) == Doubt::none;
    return anywhere ? "not at " + page::shownNumber(value(benign_)) : "nowhere";
  }
  auto end = [&](size_t i, Doubt why, const char* side) {
    return fmt::format("{} ({} {})", page::shownNumber(value(i)), wordOf(why), side);
  };
  bool from = kept.below != Doubt::none, to = kept.above != Doubt::none;
  std::string low = from ? end(kept.first, kept.below, "below") : "";
  std::string high = to ? end(kept.first + kept.count - 1, kept.above, "above") : "";
  if (from && to) return low + " to " + high;
  return from ? "from " + low : to ? "up to " + high : "everywhere";
}

std::string Curve::replacement(const std::string& inside) const {
  const std::vector<std::string> measured = arms(), known = namesOf(results_.arms);
  auto require = [&](const std::string& arm) {
    if (!contains(known, arm))
      throw Error(
          fmt::format("the reading of axis '{}' has an unknown arm '{}'{}", axis_.name, arm, didYouMean(arm, known)));
    return contains(measured, arm);
  };
  for (const char* end : {"from ", "to "})
    if (inside.starts_with(end)) {
      std::string arm = inside.substr(std::string(end).size());
      if (!require(arm)) return page::kNotMeasured;
      Trusted usual = trusted(arm, Against::own);
      if (usual.count == 0) return "nowhere";
      return page::shownNumber(value(*end == 't' ? usual.first + usual.count - 1 : usual.first));
    }
  size_t at = inside.rfind(" @ ");
  if (at == std::string::npos)
    throw Error(fmt::format("the reading of axis '{}' has {{{}}}; expected {{ARM @ VALUE}}, {{from ARM}} or {{to ARM}}",
                            axis_.name, inside));
  std::string arm = inside.substr(0, at), wanted = inside.substr(at + 3);
  for (size_t i = 0; i < size(); ++i) {
    if (label(i) != wanted) continue;
    if (arm == "floor") return shownShare(floor(i));
    if (arm == "truth") return shownShare(sigma(i));
    return require(arm) ? shownShare(error(arm, i)) : page::kNotMeasured;
  }
  bool is_value = contains(axis_.labels, wanted);
  if (is_value) return page::kNotMeasured;  // value of the axis without a point in these results
  throw Error(fmt::format("the reading of axis '{}' has an unknown value '{}'", axis_.name, wanted));
}

std::string Curve::filled(const std::string& text) const {
  return replaced(text, [this](const std::string& inside) { return replacement(inside); });
}

std::vector<Curve> curvesIn(const Results& results, double factor) {
  std::vector<Curve> curves;
  for (const AxisSummary& axis : results.axes) {
    if (!axis.hasCurves()) continue;
    Curve curve(results, axis, factor);
    if (curve.size() > 0 && curve.group(curve.benign()).at[0].second == axis.values[*axis.benign])
      curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace strobe::study
