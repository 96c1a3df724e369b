// SPDX-License-Identifier: MIT
#include "lab/html.h"

#include <algorithm>

#include "image/png.h"
#include "lab/figures.h"
#include "lab/html_parts.h"
#include "lab/sheet.h"

namespace strobe::lab {

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '&') result += "&amp;";
    else if (c == '"') result += "&quot;";
    else result += c;
  }
  return result;
}

std::string base64(const std::string& bytes) {
  static const char* const kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t word = 0;
    size_t count = std::min<size_t>(3, bytes.size() - i);
    for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < count ? uint8_t(bytes[i + k]) : 0);
    for (size_t k = 0; k < 4; ++k) text += k <= count ? kLetters[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

namespace {

using image::Image;

std::string dataOf(const std::string& png) { return "data:image/png;base64," + base64(png); }

bool isTruth(const Entry& entry) { return entry.column->role == DemoColumn::Role::truth; }

// A page in the making: pictures at a fraction of their size.
class Page {
 public:
  Page(const Exhibition& exhibition, int divisor)
      : exhibition_(exhibition), demo_(*exhibition.demo), divisor_(divisor) {}
  std::string text();

 private:
  void shot(const ShotResult& result, int number);
  void viewer(const Group& group, int number);
  void pictures(const ShotResult& result, const Group& group, int number);
  void crops(const ShotResult& result, const Group& group, size_t index);
  void differences(const Group& group);
  void table(const ShotResult& result, const Group& group);
  void figure(const std::string& id, const Image& display, const std::string& caption);
  void paragraph(const std::string& text, const char* kind = "") {
    if (!text.empty())
      page_ += fmt::format("<p{}>{}</p>\n", *kind ? fmt::format(" class=\"{}\"", kind) : "", escaped(text));
  }

  const Exhibition& exhibition_;
  const Demo& demo_;
  int divisor_;
  std::string page_;
};

std::string pictureId(int shot, size_t entry) { return fmt::format("picture-{}-{}", shot, entry); }

void Page::figure(const std::string& id, const Image& display, const std::string& caption) {
  page_ += fmt::format(
      "<figure><img{} width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\"><figcaption>{}</figcaption></figure>\n",
      id.empty() ? "" : fmt::format(" id=\"{}\"", id), display.width, display.height, escaped(caption),
      dataOf(image::encodePng(display)), escaped(caption));
}

// The page starts with the last method that is not the floor: usually the one the demo is about.
void Page::viewer(const Group& group, int number) {
  size_t truth = 0, chosen = 0;
  for (size_t i = 0; i < group.entries.size(); ++i) {
    if (isTruth(group.entries[i])) truth = i;
    if (group.entries[i].column->role == DemoColumn::Role::method && group.entries[i].column->shown) chosen = i;
  }
  page_ += fmt::format("<div class=\"viewer\" data-truth=\"{}\"><div class=\"bar\">", pictureId(number, truth));
  for (size_t i = 0; i < group.entries.size(); ++i) {
    if (isTruth(group.entries[i]) || !group.entries[i].column->shown) continue;
    page_ += fmt::format("<button type=\"button\" data-picture=\"{}\"{}>{}</button>", pictureId(number, i),
                         i == chosen ? " data-chosen" : "", escaped(group.entries[i].column->label));
  }
  page_ +=
      "<span class=\"space\"></span><span class=\"soft\">move over the picture to wipe</span>"
      "<button type=\"button\" class=\"flicker\" aria-pressed=\"false\">flicker</button></div>\n"
      "<div class=\"stage\"><img class=\"truth\" alt=\"truth\"><img class=\"method\" alt=\"the chosen method\">"
      "<div class=\"edge\"></div><span class=\"tag left\"></span>";
  page_ +=
      fmt::format("<span class=\"tag right\">{}</span></div></div>\n", escaped(group.entries[truth].column->label));
}

void Page::pictures(const ShotResult& result, const Group& group, int number) {
  page_ += "<div class=\"grid\">\n";
  for (size_t i = 0; i < group.entries.size(); ++i) {
    const Entry& entry = group.entries[i];
    if (!entry.column->shown) continue;
    Image smaller = shrunk(entry.shown, entry.shown.width / divisor_, entry.shown.height / divisor_);
    figure(pictureId(number, i), image::toneMap(smaller, result.shot->tone), entry.column->label);
  }
  page_ += "</div>\n";
}

void Page::crops(const ShotResult& result, const Group& group, size_t index) {
  const image::Rectangle& area = result.crops[index];
  page_ +=
      fmt::format("<h3>Crop {}x{} at {},{}</h3>\n<div class=\"grid crop\">\n", area.width, area.height, area.x, area.y);
  for (const Entry& entry : group.entries)
    if (entry.column->shown)
      figure("", image::toneMap(image::crop(entry.shown, area), result.shot->tone), entry.column->label);
  page_ += "</div>\n";
}

void Page::differences(const Group& group) {
  page_ += fmt::format("<h3>|Difference from truth| × {:g}, linear values</h3>\n<div class=\"grid\">\n",
                       demo_.difference_gain);
  for (const Entry& entry : group.entries) {
    if (!entry.column->shown || isTruth(entry)) continue;
    Image difference = differenceFromTruth(entry, group, demo_.difference_gain);
    int divisor = std::max(1, difference.width / 480);
    figure("", shrunk(difference, difference.width / divisor, difference.height / divisor), entry.column->label);
  }
  page_ += "</div>\n";
}

// The smallest error among methods in each region stands out.
void Page::table(const ShotResult& result, const Group& group) {
  Table table = tableOf(exhibition_, result, group);
  page_ += "<div class=\"scroll\"><table><thead><tr>";
  for (const std::string& cell : table.head) page_ += "<th scope=\"col\">" + escaped(cell) + "</th>";
  page_ += "</tr></thead><tbody>\n";
  auto best = [&](size_t column) {
    double least = INFINITY;
    for (size_t i = 0; i < table.rows.size(); ++i)
      if (group.entries[i].column->role == DemoColumn::Role::method)
        least = std::min(least, std::strtod(table.rows[i][column].c_str(), nullptr));
    return least;
  };
  for (size_t i = 0; i < table.rows.size(); ++i) {
    bool method = group.entries[i].column->role == DemoColumn::Role::method;
    std::string role = describeRole(*group.entries[i].column);
    page_ += method ? "<tr>" : fmt::format("<tr class=\"aside\" title=\"{}\">", escaped(role));
    for (size_t column = 0; column < table.rows[i].size(); ++column) {
      const std::string& cell = table.rows[i][column];
      bool error = column > 0 && table.head[column].find(' ') != std::string::npos &&
                   (table.head[column].starts_with("RMSE") || table.head[column].find("FLIP") != std::string::npos);
      bool stands_out =
          method && error && cell[0] >= '0' && cell[0] <= '9' && std::strtod(cell.c_str(), nullptr) == best(column);
      page_ += fmt::format("<td{}>{}</td>", stands_out ? " class=\"best\"" : "", escaped(cell));
    }
    page_ += "</tr>\n";
  }
  page_ += "</tbody></table></div>\n";
}

void Page::shot(const ShotResult& result, int number) {
  page_ += "<section>\n<h2>" + escaped(result.shot->title) + "</h2>\n";
  if (!result.shot->missing.empty()) {
    paragraph("Skipped: " + result.shot->missing + ".");
    page_ += "</section>\n";
    return;
  }
  paragraph(result.shot->note);
  paragraph(describeShot(result) + ".", "soft");
  const Group& group = result.groups.front();
  viewer(group, number);
  for (const Group& one : result.groups) {
    page_ += fmt::format("<h3>Errors, anchor {}</h3>\n", escaped(one.anchor));
    table(result, one);
  }
  paragraph(
      "± is truth's own standard error. A floor is truth at a method's own samples: what no filter with as many can "
      "pass.",
      "soft");
  paragraph(describeContrast(result), "soft");
  if (result.verdict) paragraph(result.verdict->text + ".", "verdict");
  page_ += "<h3>Pictures</h3>\n";
  pictures(result, group, number);
  for (size_t i = 0; i < result.crops.size(); ++i) crops(result, group, i);
  differences(group);
  paragraph(result.attribution, "soft");
  page_ += "</section>\n";
}

std::string Page::text() {
  page_ =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(demo_.title) + "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>" + kPageStyle +
      "</style>\n</head>\n<body>\n<h1>" + escaped(demo_.title) + "</h1>\n";
  paragraph(demo_.note);
  for (size_t i = 0; i < exhibition_.shots.size(); ++i) shot(exhibition_.shots[i], int(i));
  page_ += "<footer>\n";
  paragraph("Strobe " STROBE_VERSION " on " + describeDevice(exhibition_) + ".");
  paragraph(
      "RMSE of linear values over all channels; FLIP at 67 pixels per degree; one sample per pixel at its centre, for "
      "methods and truth alike. Regions are the truth's: inner, where the exposure shows what is farther than the "
      "capture sees; hidden, what the capture could not see; outer, what is nearer.");
  if (divisor_ > 1)
    paragraph(fmt::format("Pictures here have 1/{} of their width; crops and the files beside this page are whole.",
                          divisor_));
  page_ += "</footer>\n<script>" + std::string(kPageScript) + "</script>\n</body>\n</html>\n";
  return page_;
}

}  // namespace

std::string pageOf(const Exhibition& exhibition, size_t most_bytes) {
  for (int divisor = 1;; ++divisor) {
    std::string page = Page(exhibition, divisor).text();
    if (page.size() <= most_bytes || divisor == 8) return page;
  }
}

}  // namespace strobe::lab
