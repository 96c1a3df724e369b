// SPDX-License-Identifier: MIT
#include "live/driven_window.h"

#include <imgui.h>

#include <sstream>

#include "base/log.h"
#include "lab/capture.h"

namespace strobe::live {

static const double kReloadLimit_s = 20;  // limit of 'reloaded'
static const double kTruthLimit_s = 60;   // limit of 'truth' and 'swept'

DrivenWindow::DrivenWindow(const Path& file, const DrivenParts& parts)
    : parts_(parts), drive_(parseDrive(readText(file), file.string()), handlers()) {}

void DrivenWindow::point(const PictureView& view) const {
  dvec2 at = clicked_ ? *clicked_ : pointed_ ? view.inWindow(*pointed_ + dvec2(0.5)) : dvec2(-1e6);
#if IMGUI_VERSION_NUM >= 18700  // since this version, positions and buttons are events
  ImGui::GetIO().AddMousePosEvent(float(at.x), float(at.y));
  ImGui::GetIO().AddMouseButtonEvent(0, pressed_);
#endif
  ImGui::GetIO().MousePos = ImVec2(float(at.x), float(at.y));
  ImGui::GetIO().MouseDown[0] = pressed_;
}

// Calls `then` after `frames` frames of the window.
Handler DrivenWindow::afterFrames(int frames, std::function<void(const Command&)> then) {
  return [this, frames, then](const Command& command) {
    if (!wait_from_) wait_from_ = parts_.state.window_frame;
    if (parts_.state.window_frame < *wait_from_ + frames) return false;
    then(command);
    wait_from_.reset();
    return true;
  };
}

static bool onOff(const Command& command) {
  const std::string& word = command.arguments[0];
  if (word != "on" && word != "off") throw Error(fmt::format("'{}' takes on or off", command.name), command.place);
  return word == "on";
}

void DrivenWindow::addShotHandlers(Handlers& handlers) {
  handlers["set"] = [this](const Command& c) {
    return parts_.desk.sides().set(c.arguments[0], c.arguments[1], "drive"), true;
  };
  handlers["unset"] = [this](const Command& c) { return parts_.desk.sides().unset(c.arguments[0]), true; };
  handlers["pipeline"] = [this](const Command& c) { return parts_.desk.sides().usePipeline(c.arguments[0]), true; };
  handlers["frame"] = [this](const Command& c) { return parts_.desk.goToFrame(integerOf(c, 0)), true; };
  handlers["play"] = [this](const Command& c) { return parts_.desk.playing = onOff(c), true; };
  handlers["orbit"] = [this](const Command& c) {
    Sides& sides = parts_.desk.sides();
    const lab::Shot& shot = parts_.desk.shot();
    dvec3 pivot = sides.pivotAt(dvec2(shot.width, shot.height) / 2.0);
    dvec2 turn = dvec2(-numberOf(c, 0), numberOf(c, 1)) * kRadiansPerPixel;
    return sides.setViewpoint(orbited(sides.viewpoint(), pivot, turn.x, turn.y)), true;
  };
  handlers["expect"] = [this](const Command& c) {
    for (const lab::Control& control : parts_.desk.a().session->controls()) {
      if (control.declaration.name != c.arguments[0]) continue;
      if (lab::plainText(control.value) == c.arguments[1]) return true;
      throw Error(fmt::format("{} is {}, expected {}", c.arguments[0], lab::plainText(control.value), c.arguments[1]),
                  c.place);
    }
    throw Error(fmt::format("unknown control '{}'", c.arguments[0]), c.place);
  };
}

void DrivenWindow::addLookHandlers(Handlers& handlers) {
  handlers["view"] = [this](const Command& c) { return parts_.desk.viewPort(c.arguments[0]), true; };
  handlers["kind"] = [this](const Command& c) { return parts_.desk.look().view.kind = c.arguments[0], true; };
  handlers["mode"] = [this](const Command& c) { return parts_.desk.setMode(modeNamed(c.arguments[0])), true; };
  handlers["wipe"] = [this](const Command& c) { return parts_.desk.look().wipe = numberOf(c, 0), true; };
  handlers["zoom"] = [this](const Command& c) {
    const lab::Shot& shot = parts_.desk.shot();
    dvec2 centre((numberOf(c, 1) + 0.5) / shot.width, (numberOf(c, 2) + 0.5) / shot.height);
    parts_.state.magnification = {std::max(0.1, numberOf(c, 0)), centre};
    return true;
  };
  handlers["point"] = [this](const Command& c) {
    pointed_.reset();
    if (c.arguments.size() == 2) pointed_ = dvec2(integerOf(c, 0), integerOf(c, 1));
    return true;
  };
  handlers["inspect"] = [this](const Command& c) { return parts_.desk.pin(integerOf(c, 0), integerOf(c, 1)), true; };
  handlers["key"] = [this](const Command& c) { return parts_.press(actionNamed(c.arguments[0])), true; };
  handlers["search"] = [this](const Command& c) {
    parts_.state.search = c.arguments.empty() ? "" : c.arguments[0];
    return true;
  };
  handlers["panels"] = [this](const Command& c) { return parts_.state.panels = onOff(c), true; };
  handlers["help"] = [this](const Command& c) { return parts_.state.help = onOff(c), true; };
  handlers["resize"] = [this](const Command& c) {
    auto [width, height] = lab::parseSize(c.arguments[0], "resize");
    parts_.window.resize(width, height);
    return true;
  };
}

void DrivenWindow::addWaitHandlers(Handlers& handlers) {
  handlers["wait"] = [this](const Command& c) { return afterFrames(integerOf(c, 0), [](const Command&) {})(c); };
  handlers["reloaded"] = [this](const Command& c) {
    if (!wait_since_s_) wait_since_s_ = clockSeconds();
    if (clockSeconds() - *wait_since_s_ > kReloadLimit_s) throw Error("no edited file was detected", c.place);
    if (parts_.desk.sides().reloads() == reloads_seen_) return false;
    wait_since_s_.reset();
    reloads_seen_ = parts_.desk.sides().reloads();
    return true;
  };
  handlers["truth"] = [this](const Command& c) {
    if (!wait_since_s_) wait_since_s_ = clockSeconds();
    parts_.desk.wantTruth(integerOf(c, 0));
    if (clockSeconds() - *wait_since_s_ > kTruthLimit_s)
      throw Error(fmt::format("the truth has only {} samples", parts_.desk.truth().samples(parts_.desk.shot())),
                  c.place);
    if (parts_.desk.truth().samples(parts_.desk.shot()) < integerOf(c, 0)) return false;
    wait_since_s_.reset();
    parts_.desk.wantTruth(0);
    return true;
  };
  handlers["problems"] = [this](const Command& c) {
    if (c.arguments[0] != "yes" && c.arguments[0] != "no") throw Error("'problems' takes yes or no", c.place);
    std::vector<std::string> problems = parts_.desk.problems();
    if (problems.empty() != (c.arguments[0] == "no"))
      throw Error(problems.empty() ? "expected a problem, but found none" : problems.front(), c.place);
    return true;
  };
  handlers["quit"] = [this](const Command&) { return parts_.quit = true; };
}

void DrivenWindow::addFileHandlers(Handlers& handlers) {
  handlers["replace"] = [this](const Command& c) {
    reloads_seen_ = parts_.desk.sides().reloads();  // 'reloaded' waits for this edit, not for an earlier one
    return writeFileAtomically(c.arguments[0], readText(c.arguments[1])), true;
  };
  handlers["screenshot"] = [this](const Command& c) {
    if (!wait_from_) wait_from_ = parts_.state.window_frame;
    // Wait until recent changes are drawn and the panels have settled.
    if (!shot_asked_ && parts_.state.window_frame >= *wait_from_ + kSettleFrames) {
      parts_.screenshot = c.arguments[0];
      shot_asked_ = true;
    }
    if (!shot_asked_ || parts_.screenshot) return false;
    shot_asked_ = false;
    wait_from_.reset();
    return true;
  };
  handlers["capture"] = [this](const Command& c) {
    lab::checkPictureName(c.arguments[0]);
    return lab::writePicture(parts_.desk.a().session->capture(), c.arguments[0]), true;
  };
  handlers["record"] = [this](const Command&) { return parts_.begin_recording(), true; };
  handlers["recording"] = [this](const Command& c) { return parts_.stop_recording(c.arguments[0]), true; };
  handlers["trail"] = [this](const Command& c) {
    writeFileAtomically(c.arguments[0], parts_.desk.pixel().json().dump(2) + "\n");
    return true;
  };
}

// Axis from "NAME" or "NAME=VALUE,VALUE,...".
static std::pair<std::string, std::vector<std::string>> axisIn(const std::string& text) {
  size_t at = std::min(text.find('='), text.size());
  std::istringstream list(text.substr(std::min(at + 1, text.size())));
  std::vector<std::string> values;
  for (std::string value; std::getline(list, value, ',');) values.push_back(value);
  return {text.substr(0, at), values};
}

void DrivenWindow::addSweepHandlers(Handlers& handlers) {
  handlers["sweep"] = [this](const Command& c) {
    auto [name, values] = axisIn(c.arguments[0]);
    parts_.sweeper.open(parts_.desk, name, false, values);
    if (c.arguments.size() == 1) return true;
    auto [other, others] = axisIn(c.arguments[1]);
    parts_.sweeper.cross(parts_.desk, other, others);
    return true;
  };
  handlers["swept"] = [this](const Command& c) {
    if (!wait_since_s_) wait_since_s_ = clockSeconds();
    if (!parts_.sweeper.isOpen()) throw Error("no sweep is open", c.place);
    if (clockSeconds() - *wait_since_s_ > kTruthLimit_s) throw Error("the sweep is not complete", c.place);
    if (!parts_.sweeper.isComplete()) return false;
    wait_since_s_.reset();
    return true;
  };
  handlers["experiment"] = [this](const Command& c) {
    return writeFileAtomically(c.arguments[0], parts_.sweeper.experiment(parts_.desk)), true;
  };
  handlers["click"] = [this](const Command& c) {
    if (!wait_from_) wait_from_ = parts_.state.window_frame;
    int passed = parts_.state.window_frame - *wait_from_;
    clicked_ = dvec2(integerOf(c, 0), integerOf(c, 1));
    // Panels need separate frames for pointer moved, button down and button up.
    pressed_ = passed == 2;
    if (passed < 4) return false;
    clicked_.reset();
    wait_from_.reset();
    return true;
  };
}

DrivenWindow::Handlers DrivenWindow::handlers() {
  Handlers handlers;
  addShotHandlers(handlers);
  addLookHandlers(handlers);
  addWaitHandlers(handlers);
  addFileHandlers(handlers);
  addSweepHandlers(handlers);
  return handlers;
}

}  // namespace strobe::live
