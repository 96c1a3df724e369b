// SPDX-License-Identifier: MIT
#include "live/sweeper.h"

#include <algorithm>

#include "lab/shot_options.h"
#include "live/shot_text.h"
#include "live/sweep_file.h"

namespace strobe::live {

static const double kBudget_s = 0.015;         // time of a turn
static const int64_t kLeastTruthSamples = 64;  // of the ground truth in a saved experiment

// ---- swept controls

const lab::Session& Sweeper::session(const Desk& desk) const {
  if (of_b_ && !desk.b()) throw Error("B is closed");
  return of_b_ ? *desk.b()->session : *desk.sides().a().session;
}

SweepForm Sweeper::formOf(const Desk& desk, const std::string& name, const std::vector<std::string>& listed) const {
  std::vector<std::string> names;
  for (lab::Control& control : session(desk).controls()) {
    names.push_back(control.declaration.name);
    if (names.back() != name) continue;
    if (of_b_ && control.group == "shot") throw Error(fmt::format("B shares '{}' with A: sweep it in A", name));
    if (!canBeSwept(control)) throw Error(fmt::format("'{}' has no values to sweep", name));
    SweepRange range = hasRange(control.declaration) ? suggestedRange(control) : SweepRange();
    return {std::move(control), range, listed};
  }
  throw Error(fmt::format("unknown control '{}'{}", name, didYouMean(name, names)));
}

void Sweeper::open(Desk& desk, const std::string& control, bool of_b, const std::vector<std::string>& listed) {
  bool before = std::exchange(of_b_, of_b);
  try {
    begin(desk, {formOf(desk, control, listed)});
  } catch (const Error&) {
    of_b_ = before;
    throw;
  }
}

void Sweeper::cross(Desk& desk, const std::string& control, const std::vector<std::string>& listed) {
  std::vector<SweepForm> forms = {forms_.front()};
  if (!control.empty()) forms.push_back(formOf(desk, control, listed));
  begin(desk, std::move(forms));
}

// Pipelines and their declarations may have changed since the last start.
void Sweeper::begin(Desk& desk) {
  std::vector<SweepForm> forms = forms_;
  for (SweepForm& form : forms) form.control = formOf(desk, form.control.declaration.name, {}).control;
  begin(desk, std::move(forms));
}

void Sweeper::begin(Desk& desk, std::vector<SweepForm> forms) {
  int most = forms.size() > 1 ? kMostOfTwo : kMostOfOne;
  std::vector<SweepAxis> axes;
  for (SweepForm& form : forms) {
    form.range.steps = std::clamp(form.range.steps, 2, most);
    const plan::ParamDesc& declaration = form.control.declaration;
    if (!form.listed.empty()) axes.push_back(axisOf(declaration, form.listed));
    else if (hasRange(declaration)) axes.push_back(axisOf(declaration, form.range, most));
    else axes.push_back(axisOf(form.control, most));
  }
  sweep_ = std::make_unique<Sweep>(session(desk).bench(), session(desk).shot(), std::move(axes), desk.shot(),
                                   desk.options().truth);
  forms_ = std::move(forms);
  swaps_ = desk.sides().swaps();
  ++serial_;
}

void Sweeper::close(Desk& desk) {
  sweep_.reset();
  forms_.clear();
  desk.wantTruth(0, true);
}

bool Sweeper::isStale(const Desk& desk) const {
  if (of_b_ && !desk.b()) return true;
  return swaps_ != desk.sides().swaps() || !sweep_->isOf(session(desk).shot());
}

// ---- turns

bool Sweeper::turn(Desk& desk) {
  if (!isOpen()) return false;
  bool gathers = sweep_->sharesTruth() && sweep_->drawn() == sweep_->points().size() && !sweep_->stopped();
  // A turn either advances the sweep or lets ground truth accumulate, so that the window stays responsive.
  truth_next_ = gathers && (!busy() || !truth_next_);
  desk.wantTruth(truth_next_ ? Sweep::kEnough : 0, true);
  if (truth_next_ && busy()) return false;
  return sweep_->advance(desk.truth(), kBudget_s);
}

// ---- values

std::optional<size_t> Sweeper::current(const Desk& desk) const {
  if (of_b_ && !desk.b()) return {};
  std::vector<size_t> at;
  std::vector<lab::Control> controls = session(desk).controls();
  for (const SweepAxis& axis : sweep_->axes()) {
    auto control = std::find_if(controls.begin(), controls.end(),
                                [&](const lab::Control& one) { return one.declaration.name == axis.declaration.name; });
    if (control == controls.end()) return {};
    auto value = std::find(axis.values.begin(), axis.values.end(), control->value);
    if (value == axis.values.end()) return {};
    at.push_back(size_t(value - axis.values.begin()));
  }
  const auto& points = sweep_->points();
  auto found = std::find_if(points.begin(), points.end(), [&](const SweepPoint& point) { return point.at == at; });
  return size_t(found - points.begin());
}

void Sweeper::take(Desk& desk, size_t point) const {
  const std::vector<size_t>& at = sweep_->points().at(point).at;
  for (size_t i = 0; i < at.size(); ++i) {
    const SweepAxis& axis = sweep_->axes()[i];
    desk.sides().set(axis.declaration.name, lab::plainText(axis.values[at[i]]), "window", of_b_);
  }
}

void Sweeper::takeNext(Desk& desk, int by) const {
  if (!isOpen()) return;
  int count = int(sweep_->points().size());
  std::optional<size_t> now = current(desk);
  int next = now ? int(*now) + by : by > 0 ? 0 : count - 1;
  take(desk, size_t(std::clamp(next, 0, count - 1)));
}

// ---- an experiment

std::string Sweeper::experiment(const Desk& desk) const {
  if (!isOpen()) throw Error("no sweep to save");
  SavedSweep saved{sweep_->shot(), {}, sweep_->axes()};
  lab::Workbench& bench = session(desk).bench();
  saved.suggested = suggestedShot(bench.home(), saved.shot, bench.limits);
  saved.truth = desk.options().truth;
  if (saved.truth.empty())
    saved.truth = script::pipelineOfKind(bench.home(), plan::PipelineDesc::Kind::Truth, bench.limits);
  plan::PipelineDesc truth = script::evaluatePipeline(bench.home(), {saved.truth, {}}, nullptr, bench.limits);
  int64_t samples = kLeastTruthSamples;
  while (samples < sweep_->samples()) samples *= 2;
  lab::putRole(saved.truth_sets, truth, plan::Role::SampleCount, samples);
  lab::putRole(saved.truth_sets, truth, plan::Role::SampleTimes, "stratified");
  saved.regions = plan::paramOf(truth, plan::Role::Regions) != nullptr;
  return experimentText(saved);
}

Path Sweeper::save(const Desk& desk) const {
  std::string names;
  if (isOpen())
    for (const SweepAxis& axis : sweep_->axes()) names += "." + axis.declaration.name;
  std::string text = experiment(desk);
  Path file = desk.freeName(names + ".lua");
  writeFileAtomically(file, text);
  return file;
}

}  // namespace strobe::live
