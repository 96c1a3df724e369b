// SPDX-License-Identifier: MIT
#include "live/driven_window.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/log.h"
#include "base/numbers.h"
#include "lab/capture.h"
#include "plan/named.h"

namespace strobe::live {

static const double kReloadLimit_s = 20;  // limit of 'reloaded'
static const double kTruthLimit_s = 60;   // limit of 'truth' and 'swept'

// ---- commands

static bool onOff(const Command& command) {
  const std::string& word = command.arguments[0];
  if (word != "on" && word != "off") throw Error(fmt::format("'{}' takes on or off", command.name), command.place);
  return word == "on";
}

// Axis from "NAME" or "NAME=VALUE,VALUE,...".
static std::pair<std::string, std::vector<std::string>> axisIn(const std::string& text) {
  size_t at = std::min(text.find('='), text.size());
  std::istringstream list(text.substr(std::min(at + 1, text.size())));
  std::vector<std::string> values;
  for (std::string value; std::getline(list, value, ',');) values.push_back(value);
  return {text.substr(0, at), values};
}

const std::vector<CommandForm> DrivenWindow::kForms = {
    {"set", "NAME VALUE", "set the control NAME, like --set or an option of the shot",
     [](DrivenWindow& w, const Command& c) {
       return w.parts_.desk.sides().set(c.arguments[0], c.arguments[1], "drive"), true;
     }},
    {"unset", "NAME", "reset the control NAME to the value of the preset or the scene, or to the default",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.sides().unset(c.arguments[0]), true; }},
    {"pipeline", "NAME", "run another pipeline",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.sides().usePipeline(c.arguments[0]), true; }},
    {"replace", "FILE BY", "overwrite FILE with the text of BY, like a save in an editor",
     [](DrivenWindow& w, const Command& c) {
       w.reloads_seen_ = w.parts_.desk.sides().reloads();  // 'reloaded' waits for this edit, not for an earlier one
       return writeFileAtomically(c.arguments[0], readText(c.arguments[1])), true;
     }},
    {"reloaded", "", "wait until edited files are loaded or refused, 20 s at most",
     [](DrivenWindow& w, const Command& c) {
       if (w.secondsPassed() > kReloadLimit_s) throw Error("no edited file was detected", c.place);
       if (w.parts_.desk.sides().reloads() == w.reloads_seen_) return false;
       w.reloads_seen_ = w.parts_.desk.sides().reloads();
       return true;
     }},
    {"wait", "N", "wait for N frames of the window",
     [](DrivenWindow& w, const Command& c) { return w.framesPassed() >= integerOf(c, 0); }},
    {"frame", "N", "go to frame N",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.goToFrame(integerOf(c, 0)), true; }},
    {"play", "on|off", "start or stop playback; each drawn frame raises the frame number by one",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.playing = onOff(c), true; }},
    {"orbit", "DX DY", "turn the camera about the point in the middle, as a drag by DX, DY window pixels does",
     [](DrivenWindow& w, const Command& c) {
       Sides& sides = w.parts_.desk.sides();
       const lab::Shot& shot = w.parts_.desk.shot();
       dvec3 pivot = sides.pivotAt(dvec2(shot.width, shot.height) / 2.0);
       dvec2 turn = dvec2(-numberOf(c, 0), numberOf(c, 1)) * kRadiansPerPixel;
       return sides.setViewpoint(orbited(sides.viewpoint(), pivot, turn.x, turn.y)), true;
     }},
    {"view", "PORT", "show an output or NODE.PORT",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.viewPort(c.arguments[0]), true; }},
    {"kind", "NAME", "show the image as colour, depth, ...; auto chooses the kind by its format and name",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.look().view.kind = c.arguments[0], true; }},
    {"mode", "MODE", "display A and B in the mode MODE: single, wipe, flicker, difference or error",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.setMode(modeNamed(c.arguments[0])), true; }},
    {"wipe", "AT", "move the line of the wipe to AT of the width, 0 to 1",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.look().wipe = numberOf(c, 0), true; }},
    {"zoom", "Z X Y", "magnify the fitted picture Z times with pixel (X, Y) in the middle",
     [](DrivenWindow& w, const Command& c) {
       const lab::Shot& shot = w.parts_.desk.shot();
       dvec2 centre((numberOf(c, 1) + 0.5) / shot.width, (numberOf(c, 2) + 0.5) / shot.height);
       w.parts_.state.magnification = {std::max(0.1, numberOf(c, 0)), centre};
       return true;
     }},
    {"point", "[X] [Y]", "move the pointer to a pixel, or away from the picture",
     [](DrivenWindow& w, const Command& c) {
       w.pointed_.reset();
       if (c.arguments.size() == 2) w.pointed_ = dvec2(integerOf(c, 0), integerOf(c, 1));
       return true;
     }},
    {"inspect", "X Y", "pin a pixel, so that the surfaces along its ray stay listed",
     [](DrivenWindow& w, const Command& c) { return w.parts_.desk.pin(integerOf(c, 0), integerOf(c, 1)), true; }},
    {"key", "KEY", "press a key, spelled as in the help",
     [](DrivenWindow& w, const Command& c) { return w.parts_.press(actionNamed(c.arguments[0])), true; }},
    {"sweep", "AXIS [AXIS]", "sweep a control, or two; an axis is NAME or NAME=VALUE,VALUE,...",
     [](DrivenWindow& w, const Command& c) {
       auto [name, values] = axisIn(c.arguments[0]);
       w.parts_.sweeper.open(w.parts_.desk, name, false, values);
       if (c.arguments.size() == 1) return true;
       auto [other, others] = axisIn(c.arguments[1]);
       w.parts_.sweeper.cross(w.parts_.desk, other, others);
       return true;
     }},
    {"swept", "", "wait until the sweep has all pictures, errors and times, 60 s at most",
     [](DrivenWindow& w, const Command& c) {
       if (!w.parts_.sweeper.isOpen()) throw Error("no sweep is open", c.place);
       if (w.secondsPassed() > kTruthLimit_s) throw Error("the sweep is not complete", c.place);
       return w.parts_.sweeper.isComplete();
     }},
    {"experiment", "FILE.lua", "save the sweep as an experiment",
     [](DrivenWindow& w, const Command& c) {
       return writeFileAtomically(c.arguments[0], w.parts_.sweeper.experiment(w.parts_.desk)), true;
     }},
    {"click", "X Y", "click the left button at a pixel of the window",
     [](DrivenWindow& w, const Command& c) {
       w.clicked_ = dvec2(integerOf(c, 0), integerOf(c, 1));
       // Panels need separate frames for pointer moved, button down and button up.
       w.pressed_ = w.framesPassed() == 2;
       if (w.framesPassed() < 4) return false;
       w.clicked_.reset();
       return true;
     }},
    {"search", "[TEXT]", "show only controls with TEXT in name or description",
     [](DrivenWindow& w, const Command& c) {
       w.parts_.state.search = c.arguments.empty() ? "" : c.arguments[0];
       return true;
     }},
    {"panels", "on|off", "show or hide everything but the picture",
     [](DrivenWindow& w, const Command& c) { return w.parts_.state.panels = onOff(c), true; }},
    {"help", "on|off", "show or hide the keys",
     [](DrivenWindow& w, const Command& c) { return w.parts_.state.help = onOff(c), true; }},
    {"resize", "WxH", "resize the window",
     [](DrivenWindow& w, const Command& c) {
       auto [width, height] = lab::parseSize(c.arguments[0], "resize");
       w.parts_.window.resize(width, height);
       return true;
     }},
    {"screenshot", "FILE.png", "write a screenshot of the window",
     [](DrivenWindow& w, const Command& c) {
       // Wait until recent changes are drawn and the panels have settled.
       if (!w.shot_asked_ && w.framesPassed() >= kSettleFrames) {
         w.parts_.screenshot = c.arguments[0];
         w.shot_asked_ = true;
       }
       if (!w.shot_asked_ || w.parts_.screenshot) return false;
       w.shot_asked_ = false;
       return true;
     }},
    {"capture", "FILE.exr", "write the picture like 'strobe render'",
     [](DrivenWindow& w, const Command& c) {
       lab::checkPictureName(c.arguments[0]);
       return lab::writePicture(w.parts_.desk.a().session->capture(), c.arguments[0]), true;
     }},
    {"record", "", "start a recording",
     [](DrivenWindow& w, const Command&) { return w.parts_.begin_recording(), true; }},
    {"recording", "FILE.lua", "write the recording as a capture script",
     [](DrivenWindow& w, const Command& c) { return w.parts_.stop_recording(c.arguments[0]), true; }},
    {"trail", "FILE.json", "write the trail of the pinned pixel",
     [](DrivenWindow& w, const Command& c) {
       writeFileAtomically(c.arguments[0], w.parts_.desk.pixel().json().dump(2) + "\n");
       return true;
     }},
    {"truth", "N", "wait until ground truth in the background has N samples, 60 s at most",
     [](DrivenWindow& w, const Command& c) {
       w.parts_.desk.wantTruth(integerOf(c, 0));
       if (w.secondsPassed() > kTruthLimit_s)
         throw Error(fmt::format("the truth has only {} samples", w.parts_.desk.truth().samples(w.parts_.desk.shot())),
                     c.place);
       if (w.parts_.desk.truth().samples(w.parts_.desk.shot()) < integerOf(c, 0)) return false;
       w.parts_.desk.wantTruth(0);
       return true;
     }},
    {"expect", "NAME VALUE", "fail unless the control has this value",
     [](DrivenWindow& w, const Command& c) {
       for (const lab::Control& control : w.parts_.desk.a().session->controls()) {
         if (control.declaration.name != c.arguments[0]) continue;
         if (lab::plainText(control.value) == c.arguments[1]) return true;
         throw Error(
             fmt::format("{} is {}, expected {}", c.arguments[0], lab::plainText(control.value), c.arguments[1]),
             c.place);
       }
       throw Error(fmt::format("unknown control '{}'", c.arguments[0]), c.place);
     }},
    {"problems", "yes|no", "yes: fail if no problem is shown; no: fail if a problem is shown",
     [](DrivenWindow& w, const Command& c) {
       if (c.arguments[0] != "yes" && c.arguments[0] != "no") throw Error("'problems' takes yes or no", c.place);
       std::vector<std::string> problems = w.parts_.desk.problems();
       if (problems.empty() != (c.arguments[0] == "no"))
         throw Error(problems.empty() ? "expected a problem, but found none" : problems.front(), c.place);
       return true;
     }},
    {"quit", "", "close the window", [](DrivenWindow& w, const Command&) { return w.parts_.quit = true; }},
};

// ---- drive files

namespace {

bool tooManyOrFew(const CommandForm& form, size_t count) {
  std::istringstream words(form.arguments);
  size_t least = 0, most = 0;
  for (std::string word; words >> word; ++most) least += word[0] != '[';
  return count < least || count > most;
}

// Words of a line. Sets `problem` if the line is malformed.
std::vector<std::string> wordsOf(const std::string& line, std::string& problem) {
  std::vector<std::string> words;
  size_t at = 0;
  while (true) {
    at = line.find_first_not_of(" \t\r", at);
    if (at == std::string::npos || line[at] == '#') return words;
    bool quoted = line[at] == '"';
    size_t end = quoted ? line.find('"', at + 1) : line.find_first_of(" \t\r#", at);
    if (quoted && end == std::string::npos) {
      problem = "a quotation mark is not closed";
      return words;
    }
    size_t begin = at + quoted;
    words.push_back(line.substr(begin, end == std::string::npos ? end : end - begin));
    at = end == std::string::npos ? line.size() : end + quoted;
  }
}

std::string mistakeIn(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const CommandForm& form : DrivenWindow::kForms) {
    names.push_back(form.name);
    if (words[0] != form.name) continue;
    if (!tooManyOrFew(form, words.size() - 1)) return "";
    return fmt::format("'{}' takes {}, got {} argument{}", form.name,
                       form.arguments.empty() ? "nothing" : form.arguments, words.size() - 1,
                       words.size() == 2 ? "" : "s");
  }
  return fmt::format("unknown command '{}'{}", words[0], didYouMean(words[0], names));
}

}  // namespace

std::vector<Command> parseDrive(const std::string& text, const std::string& file) {
  std::vector<Command> commands;
  std::vector<std::string> problems;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::string problem;
    std::vector<std::string> words = wordsOf(line, problem);
    if (problem.empty() && words.empty()) continue;
    if (problem.empty()) problem = mistakeIn(words);
    Place place{file, number};
    if (!problem.empty()) problems.push_back(fmt::format("{}: {}", place.text(), problem));
    else commands.push_back({words[0], {words.begin() + 1, words.end()}, place});
  }
  throwIfAny(problems);
  return commands;
}

double numberOf(const Command& command, size_t argument) {
  const std::string& text = command.arguments.at(argument);
  if (std::optional<double> number = finiteNumber(text)) return *number;
  throw Error(fmt::format("'{}': '{}' is not a number", command.name, text), command.place);
}

int integerOf(const Command& command, size_t argument) {
  const std::string& text = command.arguments.at(argument);
  if (auto number = numbersIn<int, 1>(text, ',')) return number->front();
  throw Error(fmt::format("'{}': '{}' is not a whole number", command.name, text), command.place);
}

// ---- window

DrivenWindow::DrivenWindow(const Path& file, const DrivenParts& parts)
    : parts_(parts), commands_(parseDrive(readText(file), file.string())) {}

void DrivenWindow::advance() {
  for (; !done(); ++next_) {
    const Command& command = commands_[next_];
    if (!start_) start_ = {parts_.state.window_frame, clockSeconds()};
    try {
      if (!plan::find(kForms, command.name)->run(*this, command)) return;
    } catch (const Error& error) {
      bool placed = error.place().file == command.place.file && error.place().line == command.place.line;
      if (placed) throw;
      throw Error(fmt::format("'{}' failed: {}", command.name, error.what()), command.place);
    }
    start_.reset();
  }
}

int DrivenWindow::framesPassed() const { return parts_.state.window_frame - start_->frame; }
double DrivenWindow::secondsPassed() const { return clockSeconds() - start_->time_s; }

void DrivenWindow::point(const PictureView& view) const {
  dvec2 at = clicked_ ? *clicked_ : pointed_ ? view.inWindow(*pointed_ + dvec2(0.5)) : dvec2(-1e6);
#if IMGUI_VERSION_NUM >= 18700  // since this version, positions and buttons are events
  ImGui::GetIO().AddMousePosEvent(float(at.x), float(at.y));
  ImGui::GetIO().AddMouseButtonEvent(0, pressed_);
#endif
  ImGui::GetIO().MousePos = ImVec2(float(at.x), float(at.y));
  ImGui::GetIO().MouseDown[0] = pressed_;
}

}  // namespace strobe::live
