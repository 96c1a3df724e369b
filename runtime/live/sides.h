// SPDX-License-Identifier: MIT
// One or two sessions under one clock: A, and B that is compared with it. B has its own pipeline and that pipeline's
// values; everything else is A's.
#pragma once

#include "lab/session.h"
#include "live/camera.h"
#include "live/times.h"

namespace strobe::live {

// A session and the frame it drew last.
struct Side {
  static constexpr const char* kDepth = "depth";  // output that is read back with each frame, where there is one

  std::unique_ptr<lab::Session> session;
  graph::FrameResult frame;
  image::Image color;                 // linear, three channels; empty before the first frame
  std::string drawn_port;             // the image of `frame` that is looked at: "color" where it has no other
  std::string problem;                // why the last frame could not be drawn, or ""
  std::vector<std::string> warnings;  // limits the frame met
  TimeHistory times;
  bool stale = true;  // values changed since the frame was drawn
  int frames_drawn = 0;
  size_t more = 0;  // frames to draw without a change, so that their times are known

  // Whether it has to be drawn: also once more without a change, so that its times are known.
  bool isDue() const { return session && (stale || (problem.empty() && (more > 0 || times.lastIsVoid()))); }
  // The image that is looked at as it was read back, or null.
  const graph::ReadImage* image() const;
  // Linear view depth at a pixel, metres; empty for the sky, and without an output "depth".
  std::optional<double> depthAt(int x, int y) const;
};

class Sides {
 public:
  // Opens A. `versus_sets` are B's, when it is opened. Throws `Error` where A cannot run. The bench must outlive it.
  Sides(lab::Workbench& bench, lab::Shot shot, script::Settings versus_sets);

  Side& a() { return a_; }
  const Side& a() const { return a_; }
  Side* b() { return b_.session ? &b_ : nullptr; }
  const Side* b() const { return b_.session ? &b_ : nullptr; }

  void requireB() { sessionOf(true); }  // throws `Error` where there is none

  // These remember a refusal for the control's panel and throw it.
  void set(const std::string& name, const std::string& value, const std::string& origin, bool of_b = false);
  void unset(const std::string& name, bool of_b = false);
  void usePipeline(const std::string& name, bool of_b = false);  // opens B unless it is open
  // What a control refused last, and why; "" where it took its value.
  std::string refusalOf(const std::string& name, bool of_b) const;
  // Seconds the last change of that value took.
  double costOf(const std::string& name) const;

  Viewpoint viewpoint() const;  // of A's camera
  double verticalFov() const;
  // Pivot of a drag that begins at a pixel of A, world space: the point seen there, else the point in the middle of the
  // picture, else the camera's target.
  dvec3 pivotAt(const dvec2& pixel) const;
  void setViewpoint(const Viewpoint& view) { set("view", toText(rounded(view)), "window"); }
  void giveCameraBack();
  int firstFrame() const { return first_frame_; }
  // The last frame of the loop (`scene::loopFrames`); play begins anew after it.
  int lastFrame() const;

  // Looks for edited files. `swapped`: a new version runs; `news`: that, or one was refused.
  struct Looked {
    bool news = false, swapped = false;
  };
  Looked lookAtFiles();
  // Whether edited scripts of either run in the background, which a look soon finds done.
  bool evaluate() const { return a_.session->evaluates() || (b_.session && b_.session->evaluates()); }
  // What the last reload has to say in the window; once.
  std::string takeMessage() { return std::exchange(message_, ""); }
  int reloads() const { return reloads_; }  // edits of A that were swapped in or refused
  int swaps() const { return swaps_; }      // edits of either that were swapped in

  // Draws what is due, with the image `port` read back. True where there was anything.
  bool draw(const std::string& port);
  // What keeps the newest files from running or the last frame from being drawn.
  std::vector<std::string> problems() const;

 private:
  void change(const std::string& name, bool of_b, const std::function<void()>& change);
  void follow();
  void report(const Side& side, const lab::Reload& reload);
  void draw(Side& side, const std::string& port);
  lab::Session& sessionOf(bool of_b);

  lab::Workbench& bench_;
  script::Settings versus_sets_;
  Side a_, b_;
  int first_frame_ = 0;
  std::map<std::pair<bool, std::string>, std::string> refusals_;
  std::map<std::string, double> costs_;
  std::string message_;  // of a reload, until it is taken
  int reloads_ = 0, swaps_ = 0;
};

}  // namespace strobe::live
