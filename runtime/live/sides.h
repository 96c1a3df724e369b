// SPDX-License-Identifier: MIT
// One or two sessions with the same clock: A, and B for comparison. B has its own pipeline and pipeline values, and
// takes all other values from A.
#pragma once

#include "base/limit.h"
#include "lab/session.h"
#include "live/camera.h"
#include "live/times.h"

namespace strobe::live {

// A session and its last drawn frame.
struct Side {
  static constexpr const char* kDepth = "depth";  // output that is read back with each frame, if the pipeline has it

  std::unique_ptr<lab::Session> session;
  graph::FrameResult frame;
  image::Image color;            // linear, three channels; empty before the first frame
  std::string drawn_port;        // displayed image of `frame`; "color" if the chosen image is missing
  std::string problem;           // message of a failed last frame, or ""
  std::vector<LimitMet> limits;  // limits that the frame met
  TimeHistory times;
  bool stale = true;  // values changed since the frame was drawn
  int frames_drawn = 0;
  size_t more = 0;  // frames to draw without a change, to measure their times

  // True if a frame has to be drawn, after a change or to measure times.
  bool isDue() const { return session && (stale || (problem.empty() && (more > 0 || times.lastIsVoid()))); }
  // Displayed image as read back, or null.
  const graph::ReadImage* image() const;
  // Linear view depth at a pixel, metres. Empty for the sky, outside of the image, and without an output "depth".
  std::optional<double> depthAt(int x, int y) const;
};

// The two compared renderings of the window: A, and optionally B with another pipeline. Both share the camera, the
// scene and the frame number.
class Sides {
 public:
  // Opens A. `versus_sets`: pipeline values of B, used when B is opened. Throws `Error` if A cannot run. `bench` must
  // outlive this object.
  Sides(lab::Workbench& bench, lab::Shot shot, script::Settings versus_sets);

  Side& a() { return a_; }
  const Side& a() const { return a_; }
  Side* b() { return b_.session ? &b_ : nullptr; }
  const Side* b() const { return b_.session ? &b_ : nullptr; }

  void requireB() { sessionOf(true); }  // throws `Error` if B is not open

  // On a refusal, these functions store the message for the control panel and throw it.
  void set(const std::string& name, const std::string& value, const std::string& origin, bool of_b = false);
  void unset(const std::string& name, bool of_b = false);
  void usePipeline(const std::string& name, bool of_b = false);  // opens B if it is not open
  // Message of the control's last refusal; "" after an accepted value.
  std::string refusalOf(const std::string& name, bool of_b) const;
  // Duration of the last change of that value, seconds; 0 before the first change.
  double costOf(const std::string& name) const;

  Viewpoint viewpoint() const;  // of A's camera
  double verticalFov() const;   // radians
  // Pivot of a drag that begins at a pixel of A, world space: the surface point at that pixel; otherwise the surface
  // point in the middle of the picture; otherwise the camera's target.
  dvec3 pivotAt(const dvec2& pixel) const;
  void setViewpoint(const Viewpoint& view) { set("view", toText(rounded(view)), "window"); }
  void giveCameraBack();
  int firstFrame() const { return first_frame_; }
  // Last frame of the loop (`scene::loopFrames`). Playback restarts after it.
  int lastFrame() const;

  // Result of reloading edited files. `swapped`: a new version runs. `news`: a new version runs or was refused.
  struct Looked {
    bool news = false, swapped = false;
  };
  Looked lookAtFiles();
  // True if edited scripts of A or B are evaluated in the background. `lookAtFiles` collects the result.
  bool evaluate() const { return a_.session->evaluates() || (b_.session && b_.session->evaluates()); }
  // Returns and clears the last reload's message for the window.
  std::string takeMessage() { return std::exchange(message_, ""); }
  int reloads() const { return reloads_; }  // edits of A that were swapped in or refused
  int swaps() const { return swaps_; }      // edits of A or B that were swapped in

  // Draws the sides that are due and reads back the image `port`. True if a side was due.
  bool draw(const std::string& port);
  // Problems that keep the newest files from running or the last frame from being drawn.
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
  std::string message_;  // message of a reload, until it is taken
  int reloads_ = 0, swaps_ = 0;
};

}  // namespace strobe::live
