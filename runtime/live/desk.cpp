// SPDX-License-Identifier: MIT
#include "live/desk.h"

#include <algorithm>

#include "base/log.h"
#include "lab/capture.h"

namespace strobe::live {

static const int kFlickerFrames = 12;  // frames of the window for which each side shows

const std::vector<std::string>& modeNames() {
  static const std::vector<std::string> names = {"single", "wipe", "flicker", "difference", "error"};
  return names;
}

Mode modeNamed(const std::string& name) {
  auto found = std::find(modeNames().begin(), modeNames().end(), name);
  if (found == modeNames().end())
    throw Error(fmt::format("there is no mode '{}'{}", name, didYouMean(name, modeNames())));
  return Mode(found - modeNames().begin());
}

bool comparesWithB(Mode mode) { return mode == Mode::Wipe || mode == Mode::Flicker || mode == Mode::Difference; }

Desk::Desk(lab::Workbench& bench, const DeskOptions& options)
    : options_(options), sides_(bench, options.shot, options.versus_sets), truth_(bench, options.truth), pixel_(bench) {
  if (!options.versus.empty()) sides_.usePipeline(options.versus, true);
}

void Desk::goToFrame(int frame) { sides_.set("frame", std::to_string(std::max(0, frame)), "window"); }

// ---- what is looked at

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

const Side& Desk::sideShown(int window_frame) const {
  bool show_b = look_.mode == Mode::Flicker ? window_frame / kFlickerFrames % 2 != 0 : look_.single_b;
  return show_b && b() ? *b() : sides_.a();
}

template <class Pixels>
static void takeTexel(PixelValue& value, const Pixels& image, int divide, const lab::Shot& shot, int x, int y) {
  value.x = divide > 0 ? x / divide : x * image.width / shot.width;
  value.y = divide > 0 ? y / divide : y * image.height / shot.height;
  bool inside = value.x < image.width && value.y < image.height;
  for (int c = 0; c < image.channels && inside; ++c) value.values.push_back(double(image.at(value.x, value.y, c)));
}

std::optional<PixelValue> Desk::valueAt(int x, int y) const {
  const Side& side = look_.mode == Mode::Single ? sideShown(0) : sides_.a();
  const graph::ReadImage* read = side.image();
  const lab::Shot& of = side.session->shot();
  if (!read || x < 0 || y < 0 || x >= of.width || y >= of.height) return {};
  int divide = lab::divideOf(side.session->plan(), side.drawn_port);
  PixelValue value{side.drawn_port, read->format};
  value.integers = !read->uints.values.empty();
  if (value.integers) takeTexel(value, read->uints, divide, of, x, y);
  else takeTexel(value, read->floats, divide, of, x, y);
  if (value.values.empty()) return {};
  return value;
}

// ---- turns

bool Desk::busy() const {
  bool gathers = gathersTruth() && !truth_.isComplete(shot());
  return playing || sides_.a().isDue() || (b() && b()->isDue()) || gathers || look_.mode == Mode::Flicker;
}

bool Desk::turn() {
  auto looked = sides_.lookAtFiles();
  bool news = looked.news;
  if (looked.swapped) truth_.forget();
  if (playing && !a().stale) goToFrame(shot().frame >= sides_.lastFrame() ? sides_.firstFrame() : shot().frame + 1);
  bool redrawn = a().stale;
  if (sides_.draw(look_.port)) news = picture_stale_ = true;
  if (redrawn) pixel_.follow(shot());
  bool gathered = gathersTruth() && truth_.gather(shot());
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

image::Image Desk::shownSide(const Side& side) const {
  const lab::Shot& of = side.session->shot();
  const graph::ReadImage* read = side.image();
  if (!read) return image::Image(of.width, of.height, 3);
  return lab::shown(*read, side.drawn_port, lab::divideOf(side.session->plan(), side.drawn_port), of.width, of.height,
                    look_.view, side.color.empty() ? nullptr : &side.color);
}

bool Desk::pictureChanged(int window_frame) const {
  return picture_stale_ || look_ != shown_look_ || (&sideShown(window_frame) == b()) != picture_of_b_;
}

const image::Image& Desk::picture(int window_frame) {
  if (!pictureChanged(window_frame)) return picture_;
  picture_ = compose(window_frame);
  picture_stale_ = false;
  shown_look_ = look_;
  picture_of_b_ = &sideShown(window_frame) == b();
  return picture_;
}

image::Image Desk::compose(int window_frame) const {
  const Side &a = sides_.a(), &b = this->b() ? *this->b() : a;
  // A value that B refuses, or a frame that could not be drawn, leaves the two with pictures of different sizes.
  const lab::Shot &of_a = a.session->shot(), &of_b = b.session->shot();
  bool one_frame = &a != &b && of_a.width == of_b.width && of_a.height == of_b.height;
  bool both = &a != &b && !a.color.empty() && !b.color.empty();
  if (look_.mode == Mode::Wipe && both && one_frame) return lab::wiped(shownSide(a), shownSide(b), look_.wipe);
  if (look_.mode == Mode::Difference && both && image::sameSize(a.color, b.color))
    return lab::difference(a.color, b.color, look_.gain);
  if (look_.mode != Mode::Error) return shownSide(sideShown(window_frame));
  auto errors = [&](const Side& side) {
    bool measured = !side.color.empty() && image::sameSize(side.color, truth_.mean());
    return measured ? lab::difference(side.color, truth_.mean(), look_.gain, "mean |x - truth|") : shownSide(side);
  };
  return one_frame ? lab::wiped(errors(a), errors(b), look_.wipe) : errors(a);
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
