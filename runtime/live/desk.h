// SPDX-License-Identifier: MIT
// What the window works on, without a window: one or two sessions under one clock, the truth that gathers behind them,
// and what is looked at. Panels, keys and drive files change it through the same few verbs.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/running_truth.h"
#include "lab/session.h"
#include "lab/trail.h"
#include "live/camera.h"
#include "live/times.h"
#include "live/views.h"
#include "live/widgets.h"

namespace strobe::live {

enum class Mode { Single, Wipe, Flicker, Difference, Error };
const std::vector<std::string>& modeNames();  // in the order of `Mode`
Mode modeNamed(const std::string& name);      // throws `Error` with the nearest

struct DeskOptions {
  lab::Shot shot;
  std::string versus;            // pipeline of B, or ""
  script::Settings versus_sets;  // of B
  std::string truth;             // what errors are measured against; "" for the pipeline that declares kind = "truth"
  Path out;                      // pictures are saved here
};

// What is looked at and how.
struct Look {
  std::string port = "color";  // an output, or "node.port"
  ViewOptions view;
  Mode mode = Mode::Single;
  bool single_b = false;    // Mode::Single shows B
  double wipe = 0.5;        // of the width
  double gain = 4;          // of differences and errors: full scale at 1 / gain
  int flicker_frames = 12;  // frames of the window for which each side shows
};

// A session and the frame it drew last.
struct Side {
  std::unique_ptr<lab::Session> session;
  graph::FrameResult frame;
  image::Image color;                 // linear, three channels; empty before the first frame
  std::string drawn_port;             // the image of `frame` that is looked at: "color" where it has no other
  std::string problem;                // why the last frame could not be drawn, or ""
  std::vector<std::string> warnings;  // limits the frame met
  TimeHistory times;
  bool stale = true;  // values changed since the frame was drawn
  int frames_drawn = 0;
};

// A value of the picture under the pointer, as the pass wrote it.
struct PixelValue {
  std::string port, format;
  int x = 0, y = 0;            // in its image
  std::vector<double> values;  // integers are exact
  bool integers = false;
};

// A line of a pixel's trail, as a table shows it.
struct TrailLine {
  bool heading = false;  // a surface its ray meets, rather than an image
  std::string name, value, doc;
};

class Desk {
 public:
  // Throws `Error` where the first version cannot run. The bench must outlive it.
  Desk(lab::Workbench& bench, DeskOptions options);

  Side& a() { return a_; }
  Side* b() { return b_.session ? &b_ : nullptr; }
  Look& look() { return look_; }
  const Look& look() const { return look_; }
  bool hasB() const { return b_.session != nullptr; }
  const DeskOptions& options() const { return options_; }

  // ---- values. `set` and `unset` remember a refusal for the control's panel and throw it.
  void set(const std::string& name, const std::string& value, const std::string& origin, bool of_b = false);
  void unset(const std::string& name, bool of_b = false);
  void usePipeline(const std::string& name, bool of_b = false);
  void closeVersus();
  // What a control refused last, and why; "" where it took its value.
  std::string refusalOf(const std::string& name, bool of_b = false) const;
  // Seconds the last change of that value took.
  double costOf(const std::string& name) const;

  // ---- time
  void goToFrame(int frame);
  int frame() const { return a_.session->shot().frame; }
  int firstFrame() const { return first_frame_; }
  int lastFrame() const;  // of the longest animation, else two seconds; play begins anew after it
  bool playing = false;

  // ---- camera
  Viewpoint viewpoint();
  double verticalFov();
  void setViewpoint(const Viewpoint& view);
  void giveCameraBack();
  bool cameraIsMoved() const { return a_.session->shot().view.has_value(); }

  // ---- what is looked at
  void viewPort(const std::string& port);          // throws `Error` with the nearest name
  std::vector<std::string> viewable() const;       // outputs, then every port
  std::vector<std::string> viewKindsHere() const;  // ways to show that image
  void setMode(Mode mode);                         // throws `Error` where there is no B to show
  // The value of what the picture shows at a pixel of the frame; nothing outside of it.
  std::optional<PixelValue> valueAt(int x, int y) const;
  void pin(int x, int y);
  void unpin();
  std::vector<TrailLine> trailLines() const;
  Json trailJson() const;  // throws `Error` without a pinned pixel
  std::optional<std::pair<int, int>> pinned() const { return pinned_; }

  // ---- a turn: looks for edited files, draws what is stale, gathers truth. True where there is something new to show.
  bool turn();
  // Whether the next turn has work without any input.
  bool busy() const;
  // The picture as it is shown, `window_frame` choosing the side that flickers; cached until something changes.
  const image::Image& picture(int window_frame);
  bool pictureChanged(int window_frame) const;

  int truthSamples() const;  // 0 where the truth is that of another shot
  bool gathersTruth() const { return look_.mode == Mode::Error || truth_wanted_ > truthSamples(); }
  void wantTruth(int samples) { truth_wanted_ = samples; }  // gathered in every mode
  std::optional<double> errorOf(const Side& side) const;    // RMSE against the truth so far

  std::vector<std::string> problems() const;
  const std::optional<lab::Reload>& lastReload() const { return last_reload_; }
  // What the last reload has to say in the window; once.
  std::string takeMessage() { return std::exchange(message_, ""); }
  int reloads() const { return reloads_; }  // edits that were swapped in or refused

  // ---- results
  std::string command() const;  // that makes the picture of A
  std::vector<Path> save();     // A, and B where it is compared, as `render` would; returns the files
  void capture(const Path& file);
  Path freeName(const std::string& ending) const;  // in `out`

 private:
  std::unique_ptr<lab::Session> openSession(const lab::Shot& shot, const std::string& origin);
  lab::Session& sessionOf(bool of_b);
  void changed(Side& side, int compilations_before);
  void follow();
  void refuse(bool of_b, const std::string& name, const std::string& text);
  void report(const Side& side, const lab::Reload& reload);
  bool lookAtFiles(Side& side);
  void draw(Side& side);
  std::string truthKey() const;
  bool gatherTruth();
  void refreshTrail();
  image::Image shownSide(const Side& side) const;
  image::Image compose(int window_frame) const;
  image::Image errorPicture() const;
  const Side& flickering(int window_frame) const;

  lab::Workbench& bench_;
  DeskOptions options_;
  Side a_, b_;
  Look look_, shown_look_;
  int first_frame_ = 0;
  std::map<std::pair<bool, std::string>, std::string> refusals_;
  std::map<std::string, double> costs_;
  lab::RunningTruth truth_;
  std::string truth_key_, truth_problem_;
  int truth_wanted_ = 0;
  std::optional<lab::Trail> trail_;
  std::string trail_problem_;
  std::optional<std::pair<int, int>> pinned_;
  std::optional<lab::Reload> last_reload_;
  std::string message_;  // of a reload, until it is taken
  int reloads_ = 0;
  double looked_at_files_s_ = 0;
  image::Image picture_;
  bool picture_stale_ = true, picture_of_b_ = false;
};

}  // namespace strobe::live
