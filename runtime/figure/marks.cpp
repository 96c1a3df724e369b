// SPDX-License-Identifier: MIT
#include "figure/marks.h"

#include <cmath>

namespace strobe::figure {

namespace {

using ShapeKind = FigureShape::Kind;

class Drawer {
 public:
  Drawer(const Taken& taken, const Lens& lens, double size, Problems& problems)
      : taken_(taken), lens_(lens), size_(size), problems_(problems) {}

  void draw(const FigureMark& mark) {
    switch (mark.kind) {
      case FigureMark::Kind::box:
        return box(mark);
      case FigureMark::Kind::circle:
        return circle(mark);
      case FigureMark::Kind::range:
        return range(mark);
      case FigureMark::Kind::arrow:
        return arrow(mark);
      case FigureMark::Kind::text:
        return text(mark);
    }
  }

  std::vector<FigureShape> finished() { return std::move(shapes_); }

 private:
  void arrow(const FigureMark& arrow) {
    std::optional<dvec2> tip = placed(arrow, "an arrow");
    if (!tip) return;
    dvec2 to = lens_.inFigure(*tip), from = to - dvec2(34, 34) * size_;
    if (arrow.from) from = lens_.inFigure(lens_.centre(*arrow.from));
    if (arrow.by) from = lens_.inFigure(*tip + *arrow.by * lens_.scale());
    add(ShapeKind::arrow, arrow).from = from;
    shapes_.back().to = to;
    if (arrow.text.empty()) return;
    double length = glm::length(to - from);
    dvec2 back = length > 0 ? (from - to) / length : dvec2(0, -1);
    add(ShapeKind::words, arrow).to = from + back * 11.0 * size_;
  }

  void circle(const FigureMark& circle) {
    std::optional<dvec2> at = placed(circle, "a circle");
    if (!at) return;
    add(ShapeKind::ring, circle).to = lens_.inFigure(*at);
    shapes_.back().radius = circle.radius * lens_.scale().x * lens_.zoom();
    if (!circle.text.empty()) words(circle, lens_.inFigure(*at) + dvec2(0, shapes_.back().radius + 12 * size_));
  }

  void box(const FigureMark& box) {
    dvec2 corner(box.area.x, box.area.y), far = corner + dvec2(box.area.width, box.area.height);
    dvec2 middle = lens_.corner(0.5 * (corner + far));
    if (!lens_.shows(middle)) return problem(box, "a box has its middle");
    add(ShapeKind::box, box).from = lens_.inFigure(lens_.corner(corner));
    shapes_.back().to = lens_.inFigure(lens_.corner(far));
    if (box.text.empty()) return;
    dvec2 below(0.5 * (shapes_.back().from.x + shapes_.back().to.x), shapes_.back().to.y + 11 * size_);
    words(box, below);
  }

  // X - d t over the times t of the exposure: raster-time position of the point that is at X at time t
  // (shaders/lib/blur.glsl).
  void range(const FigureMark& range) {
    dvec2 at = lens_.centre(range.at.pixel);
    if (!lens_.shows(at)) return problem(range, "a range is placed");
    std::optional<dvec2> found = displacementAt(range, at);
    std::optional<dvec2> window = windowOf(range);
    if (!found || !window) return;
    dvec2 d = *found;
    dvec2 pixel = lens_.inFigure(at);
    double length = glm::length(d);
    if (length > 0.5) {
      dvec2 across = dvec2(-d.y, d.x) / length;
      auto end = [&](double t) { return lens_.inFigure(at - d * t); };
      stroke(range, end(window->x), end(window->y));
      for (double t : {window->x, window->y}) {
        dvec2 cap = across * (range.width + 3) * size_;
        stroke(range, end(t) - cap, end(t) + cap);
      }
      for (int i = 0; i < range.samples; ++i) {
        double t = window->x + (window->y - window->x) * (i + 0.5) / range.samples;
        add(ShapeKind::disc, range).to = end(t);
        shapes_.back().radius = 0.9 * range.width * size_;
      }
      if (range.displacement) {
        dvec2 aside = across * (3 * range.width + 6) * size_;
        add(ShapeKind::arrow, range).from = pixel - aside;
        shapes_.back().to = lens_.inFigure(at + d) - aside;
        shapes_.back().colour = {1, 1, 1};
        shapes_.back().width = 0.75 * range.width * size_;
      }
    }
    add(ShapeKind::disc, range).to = pixel;
    shapes_.back().radius = 1.7 * range.width * size_;
    shapes_.back().colour = {1, 1, 1};
    if (!range.text.empty()) words(range, pixel + dvec2(0, (3 * range.width + 10) * size_));
  }

  void text(const FigureMark& text) {
    dvec2 at = lens_.centre(text.at.pixel);
    if (!lens_.shows(at)) return problem(text, "a text is placed");
    words(text, lens_.inFigure(at));
  }

  FigureShape& add(ShapeKind kind, const FigureMark& mark) {
    FigureShape& shape = shapes_.emplace_back();
    shape.kind = kind, shape.colour = mark.colour, shape.width = mark.width * size_;
    if (kind == ShapeKind::words) shape.text = mark.text;
    return shape;
  }
  void words(const FigureMark& mark, dvec2 centre) { add(ShapeKind::words, mark).to = centre; }
  void stroke(const FigureMark& mark, dvec2 from, dvec2 to) {
    add(ShapeKind::line, mark).from = from;
    shapes_.back().to = to;
  }
  void problem(const FigureMark& mark, const std::string& what) {
    problems_.add(mark.place, what + " outside the visible part of its cell");
  }

  // Position in the picture, pixels. Empty for a node that is not visible.
  std::optional<dvec2> placed(const FigureMark& mark, const std::string& what) {
    const Spot& spot = mark.at;
    if (spot.node.empty()) {
      dvec2 at = lens_.centre(spot.pixel);
      if (lens_.shows(at)) return at;
      problem(mark, what + " is placed");
      return {};
    }
    auto node = taken_.nodes_ws.find(spot.node);
    if (node == taken_.nodes_ws.end()) {
      std::vector<std::string> names;
      for (const auto& [name, position] : taken_.nodes_ws) names.push_back(name);
      problems_.add(mark.place, fmt::format("the scene of shot '{}' has no node '{}'{}", taken_.shot, spot.node,
                                            didYouMean(spot.node, names)));
      return {};
    }
    dvec4 clip = dmat4(taken_.picture->ndc_from_world) * dvec4(node->second, 1);
    if (!(clip.w > 0)) return {};
    const image::Image& color = taken_.picture->frame.outputs.at("color").floats;
    dvec2 at((clip.x / clip.w * 0.5 + 0.5) * color.width, (0.5 - clip.y / clip.w * 0.5) * color.height);
    return lens_.shows(at) ? std::optional(at) : std::nullopt;
  }

  // Displacement over the exposure at a position in the picture, pixels, from the image that the range follows.
  std::optional<dvec2> displacementAt(const FigureMark& range, dvec2 at) {
    const graph::ReadImage* read = findImage(taken_, range.along, range.place, problems_);
    if (!read) return {};
    if (read->floats.empty() || read->floats.channels < 2) {
      problems_.add(range.place, fmt::format("a range follows '{}', which has no displacements", range.along));
      return {};
    }
    auto known = taken_.divides.find(range.along);
    int divide = std::max(1, known == taken_.divides.end() ? 1 : known->second);
    const image::Image& vectors = read->floats;
    int x = std::clamp(int(at.x) / divide, 0, vectors.width - 1),
        y = std::clamp(int(at.y) / divide, 0, vectors.height - 1);
    return dvec2(vectors.at(x, y, 0), vectors.at(x, y, 1));
  }

  // Start and end of the exposure relative to the raster time, in exposures.
  std::optional<dvec2> windowOf(const FigureMark& range) {
    const Json& record = taken_.picture->record;
    std::string anchor = range.anchor;
    if (anchor.empty() && record.contains("shot")) anchor = record["shot"].value("anchor", "end");
    if (anchor == "end" || anchor.empty()) return dvec2(-1, 0);
    if (anchor == "centre") return dvec2(-0.5, 0.5);
    if (anchor == "start") return dvec2(0, 1);
    problems_.add(range.place, fmt::format("unknown anchor '{}'", anchor));
    return {};
  }

  const Taken& taken_;
  const Lens& lens_;
  const double size_;
  Problems& problems_;
  std::vector<FigureShape> shapes_;
};

}  // namespace

bool Lens::shows(dvec2 p) const {
  return p.x >= area_.x && p.y >= area_.y && p.x <= area_.x + area_.width && p.y <= area_.y + area_.height;
}

const graph::ReadImage* findImage(const Taken& taken, const std::string& name, const Place& place, Problems& problems) {
  std::vector<std::string> names;
  for (const auto* images : {&taken.picture->frame.outputs, &taken.picture->frame.taps}) {
    if (auto found = images->find(name); found != images->end()) return &found->second;
    for (const auto& [known, image] : *images) names.push_back(known);
  }
  std::string near = didYouMean(name, names);
  if (near.empty()) near = ", or its file does not store it: see `layers`";
  problems.add(place,
               fmt::format("the picture of shot '{}' drawn by '{}' has no '{}'{}", taken.shot, taken.arm, name, near));
  return nullptr;
}

std::vector<FigureShape> shapesOf(const std::vector<FigureMark>& marks, const Taken& taken, const Lens& lens,
                                  double size, Problems& problems) {
  Drawer drawer(taken, lens, size, problems);
  for (const FigureMark& mark : marks) drawer.draw(mark);
  return drawer.finished();
}

}  // namespace strobe::figure
