// SPDX-License-Identifier: MIT
#include "live/desk.h"

#include <algorithm>

#include "base/log.h"
#include "lab/capture.h"

namespace strobe::live {

Desk::Desk(lab::Workbench& bench, const DeskOptions& options)
    : options_(options),
      sides_(bench, options.shot, options.versus_sets),
      budget_(options.budget_ms),
      truth_(bench, options.truth),
      pixel_(bench) {
  if (options.versus.empty()) return;
  sides_.usePipeline(options.versus, true);
  look_.mode = Mode::Wipe;
}

void Desk::goToFrame(int frame) { sides_.set("frame", std::to_string(std::max(0, frame)), "window"); }

// ---- displayed image

std::vector<std::string> Desk::viewable() const {
  const lab::Session& session = *sides_.a().session;
  std::vector<std::string> names;
  for (const auto& [name, image] : session.plan().outputs) names.push_back(name);
  std::vector<std::string> ports = session.ports();
  names.insert(names.end(), ports.begin(), ports.end());
  return names;
}

void Desk::viewPort(const std::string& port) {
  std::vector<std::string> names = viewable();
  if (std::find(names.begin(), names.end(), port) == names.end())
    throw Error(fmt::format("this frame has no image '{}'{}", port, didYouMean(port, names)));
  look_.port = port;
  look_.view.kind = "auto";
  a().stale = true;
  if (b()) b()->stale = true;
}

void Desk::setMode(Mode mode) {
  if (comparesWithB(mode)) sides_.requireB();
  look_.mode = mode;
}

Shown Desk::shown(int window_frame) const { return {sides_.a(), b(), look_, truth_, window_frame}; }

std::vector<PixelValue> Desk::valuesAt(int x, int y, int window_frame) const {
  return shown(window_frame).valuesAt(x, y);
}

// ---- turns

bool Desk::busy() const {
  bool gathers = gathersTruth() && !truth_.isComplete(shot());
  return playing || sides_.a().isDue() || (b() && b()->isDue()) || gathers || look_.mode == Mode::Flicker;
}

bool Desk::turn(const std::function<bool()>& felt) {
  auto looked = sides_.lookAtFiles();
  bool news = looked.news;
  if (looked.swapped) truth_.forget();
  if (playing && !a().stale) goToFrame(shot().frame >= sides_.lastFrame() ? sides_.firstFrame() : shot().frame + 1);
  bool redrawn = a().stale;
  const int drawn = a().frames_drawn;
  if (sides_.draw(look_.port)) news = picture_stale_ = true;
  if (redrawn) pixel_.follow(shot());
  budget_.follow(sides_, a().frames_drawn > drawn, redrawn);
  bool gathered = gathersTruth() && truth_.gather(shot(), felt);
  if (gathered && look_.mode == Mode::Error) picture_stale_ = true;
  return news || gathered;
}

std::vector<std::string> Desk::problems() const {
  std::vector<std::string> all = sides_.problems();
  if (!truth_.problem().empty() && gathersTruth()) all.push_back("truth: " + truth_.problem());
  if (!pixel_.problem().empty()) all.push_back("trail: " + pixel_.problem());
  return all;
}

// ---- the picture

bool Desk::pictureChanged(int window_frame) const {
  return picture_stale_ || look_ != shown_look_ || (&shown(window_frame).side() == b()) != picture_of_b_;
}

const image::Image& Desk::picture(int window_frame) {
  if (!pictureChanged(window_frame)) return picture_;
  picture_ = shown(window_frame).compose(legends_);
  picture_stale_ = false;
  shown_look_ = look_;
  picture_of_b_ = &shown(window_frame).side() == b();
  return picture_;
}

// ---- results

Path Desk::freeName(const std::string& ending) const {
  std::string stem =
      fmt::format("{}_{}_f{}", Path(shot().pipeline).stem().string(), Path(shot().scene).stem().string(), shot().frame);
  for (int i = 1;; ++i) {
    Path file = options_.out / fmt::format("{}_{:03}{}", stem, i, ending);
    if (!std::filesystem::exists(file)) return file;
  }
}

std::vector<Path> Desk::save() {
  Path file = freeName(".exr");
  std::vector<Path> files = lab::writePicture(a().session->capture(), file);
  if (!b() || !comparesWithB(look_.mode)) return files;
  Path other = file.parent_path() / (file.stem().string() + "_b.exr");
  for (const Path& written : lab::writePicture(b()->session->capture(), other)) files.push_back(written);
  return files;
}

}  // namespace strobe::live
