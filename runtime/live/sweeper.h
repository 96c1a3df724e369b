// SPDX-License-Identifier: MIT
// The sweep beside the picture: which controls it goes through, whether it is still that of the picture, what is taken
// from it and saved. Panels, keys and drive files work on it; without a window.
#pragma once

#include <memory>

#include "live/desk.h"
#include "live/sweep.h"

namespace strobe::live {

// What is asked for of one control.
struct SweepForm {
  lab::Control control;             // as it was when it was asked for
  SweepRange range;                 // of numbers
  std::vector<std::string> listed;  // these values instead, where there are any
};

class Sweeper {
 public:
  // Opens on a control of A (or B) and begins with what its declaration suggests. `listed`: with these values. Throws
  // `Error` for an unknown name with the nearest, and where it has no values.
  void open(Desk& desk, const std::string& control, bool of_b = false, const std::vector<std::string>& listed = {});
  // A second control, so that there is a grid; "" for none. Begins anew.
  void cross(Desk& desk, const std::string& control, const std::vector<std::string>& listed = {});
  // Begins anew, as the forms and the shot are now. Throws `Error` where a form is wrong; what was drawn stays.
  void begin(Desk& desk);
  void stop() { sweep_->stop(); }
  void close(Desk& desk);

  bool isOpen() const { return sweep_ != nullptr; }
  const Sweep& sweep() const { return *sweep_; }  // while open, as the following
  std::vector<SweepForm>& forms() { return forms_; }
  bool ofB() const { return of_b_; }
  int serial() const { return serial_; }  // another for each beginning
  // Whether anything but the swept controls changed since it began.
  bool isStale(const Desk& desk) const;
  // The point that has the values which the controls have now.
  std::optional<size_t> current(const Desk& desk) const;

  // ---- a turn: draws for about 15 ms, one frame at least, or lets the desk gather truth. True where there is
  // something new.
  bool turn(Desk& desk);
  // Whether the next turn has work without any input.
  bool busy() const { return isOpen() && !sweep_->isWhole(); }
  // Pictures, errors and times of all points are there.
  bool isComplete() const { return isOpen() && sweep_->isWhole() && sweep_->samples() > 0; }

  // Gives the controls the values of a point, as their widgets would. Throws `Error`.
  void take(Desk& desk, size_t point) const;
  void takeNext(Desk& desk, int by) const;  // ... of the point so many after the current one

  // The experiment that draws the same, as text, and in a new file of the window's folder.
  std::string experiment(const Desk& desk) const;
  Path save(const Desk& desk) const;

 private:
  SweepForm formOf(const Desk& desk, const std::string& control, const std::vector<std::string>& listed) const;
  void begin(Desk& desk, std::vector<SweepForm> forms);
  const lab::Session& session(const Desk& desk) const;

  std::vector<SweepForm> forms_;
  std::unique_ptr<Sweep> sweep_;
  bool of_b_ = false;
  bool truth_next_ = false;  // the desk gathers truth in its next turn
  int serial_ = 0, swaps_ = 0;
};

}  // namespace strobe::live
