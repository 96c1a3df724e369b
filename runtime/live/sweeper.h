// SPDX-License-Identifier: MIT
// Control of the sweep below the picture: start, staleness, taking of values, saving. Panels, keys and drive files use
// this class. Does not need a window.
#pragma once

#include <memory>

#include "live/desk.h"
#include "live/sweep.h"

namespace strobe::live {

// Settings of a sweep for one control.
struct SweepForm {
  lab::Control control;             // control at the start of the sweep
  SweepRange range;                 // range of a number
  std::vector<std::string> listed;  // values in place of the range, if not empty
};

// Controller of the window's parameter sweep: starts, restarts, closes and saves it, and applies the values of a chosen
// point.
class Sweeper {
 public:
  // Opens a sweep of a control of A (or B), with the values that the control's declaration suggests or with `listed`.
  // Throws `Error` for an unknown name, with the nearest name, and for a control that cannot be swept.
  void open(Desk& desk, const std::string& control, bool of_b = false, const std::vector<std::string>& listed = {});
  // Restarts the sweep as a grid with a second control, or with one control if `control` is "".
  void cross(Desk& desk, const std::string& control, const std::vector<std::string>& listed = {});
  // Restarts the sweep with the current forms and shot. Throws `Error` if a form is wrong; the previous sweep stays.
  void begin(Desk& desk);
  void stop() { sweep_->stop(); }
  void close(Desk& desk);

  bool isOpen() const { return sweep_ != nullptr; }
  const Sweep& sweep() const { return *sweep_; }  // needs an open sweep, like the functions below
  std::vector<SweepForm>& forms() { return forms_; }
  bool ofB() const { return of_b_; }
  int serial() const { return serial_; }  // changes at each start
  // True if anything except the swept controls changed since the start.
  bool isStale(const Desk& desk) const;
  // Point with the current values of the controls; empty if no point has them.
  std::optional<size_t> current(const Desk& desk) const;

  // ---- turns
  // Works for about 15 ms, one frame at least, or lets the desk accumulate ground truth. True if the sweep worked.
  bool turn(Desk& desk);
  // True if the next turn has work without input.
  bool busy() const { return isOpen() && !sweep_->isWhole(); }
  // True if no work is left and every point has an error.
  bool isComplete() const { return isOpen() && sweep_->isWhole() && sweep_->samples() > 0; }

  // Sets the controls to the values of a point, as their widgets would. Throws `Error`.
  void take(Desk& desk, size_t point) const;
  void takeNext(Desk& desk, int by) const;  // `by`: offset from the current point

  // Experiment that repeats the sweep: as text, or in a new file of the window's folder.
  std::string experiment(const Desk& desk) const;
  Path save(const Desk& desk) const;

 private:
  SweepForm formOf(const Desk& desk, const std::string& control, const std::vector<std::string>& listed) const;
  void begin(Desk& desk, std::vector<SweepForm> forms);
  const lab::Session& session(const Desk& desk) const;

  std::vector<SweepForm> forms_;
  std::unique_ptr<Sweep> sweep_;
  bool of_b_ = false;
  bool truth_next_ = false;  // the desk accumulates ground truth in its next turn
  int serial_ = 0, swaps_ = 0;
};

}  // namespace strobe::live
