// SPDX-License-Identifier: MIT
#include "figure/layout.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace strobe::figure {

using image::Image;
using image::Rectangle;
using LegendKind = image::Legend::Kind;

namespace {

constexpr Colour kStrong = {0.1f, 0.1f, 0.12f}, kSoft = {0.36f, 0.36f, 0.40f}, kPlate = {0.03f, 0.03f, 0.04f},
                 kOnPlate = {0.97f, 0.97f, 0.98f};
constexpr double kCaption = 0.92, kTitle = 1.3, kNote = 0.85, kLeastText = 4;

int ceilOf(double value) { return int(std::ceil(value - 1e-9)); }

// Breaks a text at spaces into lines of at most `width`. A single wider word has a line of its own. '\n' begins a line.
std::vector<std::string> wrapped(const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  std::string line;
  size_t at = 0;
  while (at <= text.size()) {
    size_t end = std::min(text.find_first_of(" \n", at), text.size());
    std::string word = text.substr(at, end - at), longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && textWidth(longer, size) > width) {
      lines.push_back(line);
      longer = word;
    }
    line = longer;
    if (end < text.size() && text[end] == '\n') {
      lines.push_back(line);
      line.clear();
    }
    at = end + 1;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

// Removes the last character of a UTF-8 text.
void cutLast(std::string& text) {
  while (text.size() > 1 && (text.back() & 0xc0) == 0x80) text.pop_back();
  text.pop_back();
}

// Reduces the size of a text that is too wide. If the text is still too wide, cuts it.
void fit(std::string& text, double& size, double width) {
  double own = textWidth(text, size);
  if (own <= width) return;
  size = std::max({kLeastText, 0.55 * size, size * width / own * 0.999});
  if (textWidth(text, size) <= width) return;
  while (!text.empty() && textWidth(text + "…", size) > width) cutLast(text);
  text += "…";
}

// Letters of the cell `i`: a, b, ... z, aa, ab ...
std::string letterOf(size_t i) {
  std::string letters(1, char('a' + i % 26));
  return i < 26 ? letters : letterOf(i / 26 - 1) + letters;
}

}  // namespace

Layout::Layout(const FigureData& figure, std::vector<Block> blocks, Captions captions)
    : figure_(figure), blocks_(std::move(blocks)), captions_(captions) {
  STROBE_ASSERT(!blocks_.empty());
  size_ = figure_.size();
  text_ = std::max(kLeastText, figure_.text_size * size_);
  gap_ = int(std::lround(figure_.gap * size_));
  rim_ = int(std::lround(figure_.border * size_));
  bool framed = std::any_of(blocks_.begin(), blocks_.end(), [](const Block& b) { return b.main.frame.has_value(); });
  if (framed) rim_ = std::max({rim_, 1, int(std::lround(3 * size_))});
  measureGrid();

  int margin = int(std::lround(figure_.margin * size_));
  int inner = labels_beside_;
  for (int width : column_widths_) inner += width + gap_;
  inner -= gap_;
  width_ = inner + 2 * margin;

  int y = margin;
  if (!figure_.title.empty()) y = addParagraph(margin, y, inner, figure_.title, kTitle * text_, kStrong) + gap_;
  int left = margin + labels_beside_;
  for (size_t r = 0; r < row_heights_.size(); ++r) {
    int below = placeHeading(r, margin, y, inner);
    if (row_heights_[r] > 0 && (r == 0 || below > y)) placeColumnLabels(left, below), below += labels_above_;
    placeRowLabel(r, left, below);
    row_tops_.push_back(below);
    y = below + row_heights_[r] + gap_;
  }
  y -= gap_;
  for (const Block& block : blocks_) {
    int x = left;
    for (int c = 0; c < block.column; ++c) x += column_widths_[size_t(c)] + gap_;
    place(block, x, row_tops_[size_t(block.row)]);
  }
  if (!figure_.note.empty()) y = addParagraph(margin, y + gap_, inner, figure_.note, kNote * text_, kSoft);
  std::set<std::string> authors;
  for (const Block& block : blocks_)
    if (figure_.attribution && !block.attribution.empty() && authors.insert(block.attribution).second)
      y = addParagraph(margin, y + gap_ / 2, inner, block.attribution, kNote * text_, kSoft);
  height_ = y + margin;
}

Rectangle Layout::picture(int row, int column) const {
  for (size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i].row != row || blocks_[i].column != column) continue;
    for (const Placed& placed : placed_)
      if (placed.panel == &blocks_[i].main) return placed.area;
  }
  STROBE_ASSERT(false, "{} {}", row, column);
  return {};
}

// ---- sizes

Rectangle Layout::belowOf(const Block& block) const {
  Rectangle size;
  for (const Panel& inset : block.insets) {
    if (inset.at != "below") continue;
    int rim = std::max(1, int(std::lround(2 * size_)));
    size.width += (size.width > 0 ? gap_ : 0) + inset.display.width + 2 * rim;
    size.height = std::max(size.height, inset.display.height + 2 * rim);
  }
  return size;
}

int Layout::outerWidth(const Block& block) const {
  return std::max(block.main.display.width + 2 * rim_, belowOf(block).width);
}

int Layout::keyHeight(const image::Legend& legend) const {
  double small = 0.8 * text_;
  switch (legend.kind) {
    case LegendKind::none:
      return 0;
    case LegendKind::words:
      return ceilOf(lineHeight(small));
    case LegendKind::wheel:
      return 2 * int(std::lround(1.3 * text_)) + 1;
    default:
      return ceilOf(0.7 * text_ + lineHeight(small) + 0.15 * text_);
  }
}

std::vector<std::string> Layout::captionLines(const std::string& caption, int width) const {
  if (caption.empty()) return {};
  if (captions_ == Captions::one_line) return {caption};
  return wrapped(caption, kCaption * text_, width);
}

int Layout::heightOf(const Block& block, int width) const {
  int height = block.main.display.height + 2 * rim_;
  if (int below = belowOf(block).height) height += gap_ + below;
  int space = int(std::lround(0.3 * text_));
  if (int key = keyHeight(block.legend)) height += space + key;
  size_t lines = captionLines(block.caption, width).size();
  if (lines > 0) height += space + ceilOf(double(lines) * lineHeight(kCaption * text_));
  return height;
}

void Layout::measureGrid() {
  column_widths_.assign(std::max<size_t>(1, figure_.columns.size()), 0);
  row_heights_.assign(std::max<size_t>(1, figure_.rows.size()), 0);
  for (const Block& block : blocks_) {
    int& width = column_widths_.at(size_t(block.column));
    width = std::max(width, outerWidth(block));
  }
  for (const Block& block : blocks_) {
    int& height = row_heights_.at(size_t(block.row));
    height = std::max(height, heightOf(block, column_widths_[size_t(block.column)]));
  }
  auto any = [](const std::vector<std::string>& labels) {
    return std::any_of(labels.begin(), labels.end(), [](const std::string& label) { return !label.empty(); });
  };
  if (any(figure_.columns)) labels_above_ = ceilOf(1.25 * lineHeight(text_));
  if (any(figure_.rows)) labels_beside_ = ceilOf(1.35 * lineHeight(text_));
}

// ---- places

void Layout::addLine(double x, double y, int width, const std::string& text, double size, const Colour& colour,
                     bool centred) {
  std::string shown = text;
  double height = lineHeight(size);
  fit(shown, size, width);
  if (centred) x += (width - textWidth(shown, size)) / 2;
  lines_.push_back({x, y + (height - lineHeight(size)) / 2, shown, size, colour, false});
}

// Returns the y coordinate of the paragraph's end.
int Layout::addParagraph(int x, int y, int width, const std::string& text, double size, const Colour& colour) {
  double height = lineHeight(size), at = y;
  for (const std::string& line : wrapped(text, size, width)) {
    addLine(x, at, width, line, size, colour, false);
    at += height;
  }
  return ceilOf(at);
}

void Layout::placeColumnLabels(int x, int y) {
  for (size_t c = 0; c < column_widths_.size(); ++c) {
    if (labels_above_ && !figure_.columns[c].empty())
      addLine(x, y, column_widths_[c], figure_.columns[c], text_, kStrong, true);
    x += column_widths_[c] + gap_;
  }
}

void Layout::placeRowLabel(size_t row, int x, int y) {
  if (!labels_beside_ || figure_.rows[row].empty()) return;
  // In the middle of the pictures, without the captions below them.
  int height = 0;
  for (const Block& block : blocks_)
    if (block.row == int(row)) height = std::max(height, block.main.display.height + 2 * rim_);
  std::string label = figure_.rows[row];
  double size = text_;
  fit(label, size, height);
  lines_.push_back({double(x - labels_beside_), y + (height + textWidth(label, size)) / 2, label, size, kStrong, true});
}

// Returns the y coordinate where the row begins.
int Layout::placeHeading(size_t row, int x, int y, int width) {
  if (row >= figure_.headings.size() || figure_.headings[row].empty()) return y;
  const RowHeading& heading = figure_.headings[row];
  std::string note;
  for (const CaptionPart& part : heading.note) note += part.text;  // for a row without cells
  for (const Block& block : blocks_)
    if (block.row == int(row) && !block.above.empty()) note = block.above;
  bool first = row == 0 && figure_.title.empty();
  y = addParagraph(x, y + (first ? 0 : 2 * gap_), width, heading.title, kTitle * text_, kStrong);
  return addParagraph(x, y, width, note, kNote * text_, kSoft) + gap_;
}

void Layout::placeInset(const Panel& inset, const Rectangle& picture, int& below_x, int below_y) {
  int rim = std::max(1, int(std::lround(2 * size_))), away = rim + std::max(2, int(std::lround(4 * size_)));
  Rectangle area = {below_x + rim, below_y + rim, inset.display.width, inset.display.height};
  if (inset.at == "below") {
    below_x += area.width + 2 * rim + gap_;
  } else {
    bool right = inset.at.ends_with("right"), bottom = inset.at.starts_with("bottom");
    area.x = right ? picture.x + picture.width - area.width - away : picture.x + away;
    area.y = bottom ? picture.y + picture.height - area.height - away : picture.y + away;
  }
  placed_.push_back({&inset, area, rim, inset.frame.value_or(kOnPlate), ""});
}

void Layout::place(const Block& block, int x, int y) {
  int width = column_widths_[size_t(block.column)];
  int left = x + (width - outerWidth(block)) / 2;
  Rectangle picture = {left + rim_, y + rim_, block.main.display.width, block.main.display.height};
  std::string letter = figure_.letters ? letterOf(size_t(&block - blocks_.data())) : "";
  placed_.push_back({&block.main, picture, block.main.frame ? rim_ : int(std::lround(figure_.border * size_)),
                     block.main.frame.value_or(kStrong), letter});
  int at = y + picture.height + 2 * rim_, below_x = left;
  for (const Panel& inset : block.insets) placeInset(inset, picture, below_x, at + gap_);
  if (int below = belowOf(block).height) at += gap_ + below;

  int space = int(std::lround(0.3 * text_));
  std::vector<std::string> lines = captionLines(block.caption, width);
  for (size_t i = 0; i < lines.size(); ++i)
    addLine(x, at + space + double(i) * lineHeight(kCaption * text_), width, lines[i], kCaption * text_, kStrong, true);
  if (!lines.empty()) at += space + ceilOf(double(lines.size()) * lineHeight(kCaption * text_));
  if (int key = keyHeight(block.legend))
    keys_.push_back({block.legend, {left + rim_, at + space, std::min(picture.width, outerWidth(block)), key}});
}

// ---- drawing

void Layout::drawPlate(Canvas& canvas, const Rectangle& within, dvec2 centre, const std::string& text, double size,
                       const Colour& colour) const {
  double pad = 0.3 * size, width = textWidth(text, size), height = lineHeight(size);
  auto placed = [pad](double middle, double length, double from, double room) {
    double most = from + room - length - pad;
    return std::max(from + pad, std::min(middle - length / 2, most));
  };
  double x = placed(centre.x, width, within.x, within.width), y = placed(centre.y, height, within.y, within.height);
  Rectangle plate = {int(std::floor(x - pad)), int(std::floor(y)), 0, 0};
  plate.width = ceilOf(x + width + pad) - plate.x, plate.height = ceilOf(y + height) - plate.y;
  canvas.fill(plate, kPlate, 0.72);
  canvas.text(x, y, text, size, colour);
}

void Layout::drawPanel(Canvas& canvas, const Placed& placed) const {
  const Rectangle& area = placed.area;
  Rectangle around = {area.x - placed.rim, area.y - placed.rim, area.width + 2 * placed.rim,
                      area.height + 2 * placed.rim};
  if (placed.rim > 0) canvas.frame(around, placed.rim, placed.rim_colour);
  canvas.picture(placed.panel->display, area.x, area.y);
  canvas.clip(area);
  dvec2 origin(area.x, area.y);
  for (const FigureShape& shape : placed.panel->shapes) {
    dvec2 from = origin + shape.from, to = origin + shape.to;
    switch (shape.kind) {
      case FigureShape::Kind::arrow:
        canvas.arrow(from, to, shape.width, shape.colour);
        break;
      case FigureShape::Kind::line:
        canvas.line(from, to, shape.width, shape.colour);
        break;
      case FigureShape::Kind::ring:
        canvas.ring(to, shape.radius, shape.width, shape.colour);
        break;
      case FigureShape::Kind::disc:
        canvas.disc(to, shape.radius, shape.colour);
        break;
      case FigureShape::Kind::words:
        drawPlate(canvas, area, to, shape.text, kCaption * text_, shape.colour);
        break;
      case FigureShape::Kind::box: {
        Rectangle box = {int(std::lround(from.x)), int(std::lround(from.y)), 0, 0};
        box.width = std::max(3, int(std::lround(to.x)) - box.x),
        box.height = std::max(3, int(std::lround(to.y)) - box.y);
        canvas.frame(box, std::max(1, int(std::lround(shape.width))), shape.colour);
      }
    }
  }
  if (!placed.letter.empty()) drawPlate(canvas, area, origin, placed.letter, 1.1 * text_, kOnPlate);
  canvas.unclip();
}

void Layout::drawKey(Canvas& canvas, const Key& key) const {
  double small = 0.8 * text_;
  const Rectangle& area = key.area;
  auto line = [&](double x, double y, double width, std::string text, double aligned) {
    double size = small;
    fit(text, size, width);
    canvas.text(x + aligned * (width - textWidth(text, size)), y, text, size, kSoft);
  };
  if (key.legend.kind == LegendKind::words) return line(area.x, area.y, area.width, key.legend.text, 0);
  if (key.legend.kind == LegendKind::wheel) {
    Image wheel = image::wheelOf((area.height - 1) / 2);
    canvas.picture(wheel, area.x, area.y, true);
    double x = area.x + wheel.width + 0.5 * small;
    return line(x, area.y + (area.height - lineHeight(small)) / 2, area.x + area.width - x,
                fmt::format("direction and length, up to {:g} px", key.legend.high), 0);
  }
  int height = std::max(2, int(std::lround(0.7 * text_)));
  canvas.picture(image::barOf(key.legend, area.width, height), area.x, area.y);
  std::array<std::string, 3> texts = image::textsOf(key.legend);
  double y = area.y + height + 0.1 * text_, ends = std::max(textWidth(texts[0], small), textWidth(texts[2], small));
  line(area.x, y, area.width, texts[0], 0);
  line(area.x, y, area.width, texts[2], 1);
  double room = area.width - 2 * ends - small;
  if (!texts[1].empty() && room > 4 * small) line(area.x + (area.width - room) / 2, y, room, texts[1], 0.5);
}

void Layout::draw(Canvas& canvas) const {
  for (const Placed& placed : placed_) drawPanel(canvas, placed);
  for (const Key& key : keys_) drawKey(canvas, key);
  for (const Line& line : lines_)
    if (line.turned) canvas.turnedText(line.x, line.y, line.text, line.size, line.colour);
    else canvas.text(line.x, line.y, line.text, line.size, line.colour);
}

}  // namespace strobe::figure
