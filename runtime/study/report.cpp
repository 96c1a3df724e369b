// SPDX-License-Identifier: MIT
#include "study/report.h"

#include <algorithm>
#include <iterator>

#include "page/markup.h"
#include "page/standalone.h"

namespace strobe::study {

void append(Parts& parts, Parts more) { std::move(more.begin(), more.end(), std::back_inserter(parts)); }

namespace {

using Expectations = std::vector<const Expectation*>;

std::string sentenceOf(const Expectation& one) {
  std::string detail = one.detail.empty() ? "" : " (" + one.detail + ")";
  std::string known = one.known.empty() ? "" : " Known: " + one.known + ".";
  return fmt::format("Expected: {}. This {}{}.{}", one.text, one.outcome, detail, known);
}

// Count of the expectations that apply: "1 of 2 hold".
std::string countOf(const Expectations& expectations) {
  auto count = [&](const char* outcome) {
    return std::count_if(expectations.begin(), expectations.end(),
                         [&](const auto* one) { return one->outcome == outcome; });
  };
  auto holds = count("holds"), absent = count("does not apply");
  std::string text = fmt::format("{} of {} hold", holds, expectations.size() - size_t(absent));
  return text + (absent ? fmt::format(", {} {} not apply.", absent, absent == 1 ? "does" : "do") : ".");
}

// One row per expectation: text, outcome and numbers.
page::Table outcomeTable(const Expectations& expectations) {
  page::Table table;
  table.columns = {"expected", "outcome", "numbers", "known to fail"};
  for (const Expectation* one : expectations) {
    page::Emphasis mark = one->contradicts()        ? page::Emphasis::bad
                          : one->outcome == "holds" ? page::Emphasis::best
                                                    : page::Emphasis::none;
    table.add({one->text, page::TableCell(one->outcome, mark), one->detail, one->known});
  }
  return page::withoutEmptyColumns(std::move(table));
}

// Sentences for terminal and Markdown.
Parts sentencesOf(const Expectations& expectations) {
  Parts parts;
  for (const Expectation* one : expectations)
    parts.push_back(text(sentenceOf(*one), one->contradicts() ? Tone::failure : Tone::finding,
                         ReportPart::kTerminal | ReportPart::kDocument));
  return parts;
}

// All expectations of the experiment, for the head of the page. Sections below repeat some of these.
Parts summaryOf(const Results& results) {
  Expectations all;
  for (const Expectation& one : results.expectations) all.push_back(&one);
  if (all.empty()) return {};
  bool contradicts = std::any_of(all.begin(), all.end(), [](const auto* one) { return one->contradicts(); });
  return {heading("Expectations", 2, "expectations", ReportPart::kPage),
          text(countOf(all), contradicts ? Tone::failure : Tone::finding, ReportPart::kPage),
          {outcomeTable(all), ReportPart::kPage}};
}

bool tells(const Parts& sections, const std::string& sentence) {
  return std::any_of(sections.begin(), sections.end(), [&](const ReportPart& part) {
    const auto* paragraph = std::get_if<page::Paragraph>(&part.block);
    return paragraph && paragraph->text == sentence;
  });
}

// Expectations that no section has: without shot or axis, or with a shot or axis that is not laid out.
Expectations expectationsBeside(const Results& results, const Parts& sections) {
  Expectations list;
  for (const Expectation& one : results.expectations)
    if (!tells(sections, sentenceOf(one))) list.push_back(&one);
  return list;
}

}  // namespace

Parts expectationParts(const Results& results, const std::string& shot, const std::string& axis) {
  Expectations list;
  for (const Expectation& one : results.expectations)
    if (one.shot == shot && one.axis == axis) list.push_back(&one);
  Parts parts = sentencesOf(list);
  if (!list.empty()) parts.push_back({outcomeTable(list), ReportPart::kPage});
  return parts;
}

namespace {

// ---- as text and Markdown; blocks only for pages are ""

struct Plain {
  std::string operator()(const page::Heading& heading) const { return "\n" + heading.text + "\n"; }
  std::string operator()(const page::Paragraph& paragraph) const { return page::inlinePlain(paragraph.text) + "\n"; }
  std::string operator()(const page::Table& table) const { return page::textOf(table) + "\n"; }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

struct Markdown {
  std::string operator()(const page::Heading& heading) const {
    return std::string(size_t(heading.level), '#') + " " + heading.text + "\n\n";
  }
  std::string operator()(const page::Paragraph& paragraph) const { return paragraph.text + "\n\n"; }
  std::string operator()(const page::Table& table) const { return page::markdownOf(table) + "\n"; }
  std::string operator()(const page::Figure& figure) const {
    std::string caption = figure.caption.empty() ? "" : figure.caption + "\n\n";
    return fmt::format("![{}]({}.svg)\n\n{}", figure.alt, figure.name, caption);
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

// ---- as a page

Parts still(Parts parts) {
  for (ReportPart& part : parts) part.still = true;
  return parts;
}

// Adds an ending to the names of figures and to the targets of links.
Parts distinguished(Parts parts, const std::string& ending) {
  for (ReportPart& part : parts) {
    auto* figure = std::get_if<page::Figure>(&part.block);
    auto* heading = std::get_if<page::Heading>(&part.block);
    std::string* name = figure ? &figure->name : heading ? &heading->id : nullptr;
    if (name && !name->empty()) *name += ending;
  }
  return parts;
}

// Puts the explorer before the first still part, or at the end, and collects consecutive still parts in one block.
std::vector<page::Block> blocksOf(Parts parts, const std::optional<page::Explorer>& explorer) {
  std::vector<page::Block> blocks;
  bool placed = !explorer;
  auto place = [&] {
    if (!placed) blocks.push_back(*explorer);
    placed = true;
  };
  for (ReportPart& part : parts) {
    if (!(part.media & ReportPart::kPage)) continue;
    if (!explorer || !part.still) {
      blocks.push_back(std::move(part.block));
      continue;
    }
    place();
    if (!std::holds_alternative<page::Still>(blocks.back())) blocks.push_back(page::Still());
    std::get<page::Still>(blocks.back()).blocks.push_back(std::move(part.block));
  }
  place();
  return blocks;
}

std::string describeLibrary(const page::Library& library) {
  if (library.found()) return "Interactive charts by " + library.name + "; its licence is in the page's source.";
  return fmt::format(
      "This page has static figures and tables. If Debian's package {} is installed, `strobe report` makes a page with "
      "interactive charts.",
      page::kLibraryPackage);
}

}  // namespace

Report::Report(const Results& results, const Path& folder) : results_(results), folder_(folder) {
  if (!results.layout.pictures) return;
  for (const ShotSummary& shot : results.shots) galleries_.push_back(galleryOf(results, shot, folder));
}

Parts Report::sections(const std::optional<PictureSize>& size) const {
  Parts sections;
  const ReportLayout& layout = results_.layout;
  if (layout.pictures) append(sections, pictureParts(results_, galleries_, size));
  if (layout.curves) append(sections, curveParts(results_));
  if (layout.front) append(sections, still(frontParts(results_)));
  if (layout.front || layout.table) append(sections, still(effectParts(results_)));
  if (layout.table) append(sections, layout.table->axes.empty() ? still(tableParts(results_)) : tableParts(results_));
  return sections;
}

Parts Report::sectionsByDevice(const std::optional<PictureSize>& size) const {
  const std::vector<std::string> devices = results_.timedDevices();
  if (devices.size() < 2) return sections(size);
  Parts all = {
      study::text(fmt::format("Times come from {} devices or drivers: {}. Each has sections of its own, because "
                              "times of different devices are not comparable.",
                              devices.size(), fmt::join(devices, "; ")),
                  Tone::finding)};
  for (size_t i = 0; i < devices.size(); ++i) {
    const Results own = results_.onDevice(devices[i]);
    all.push_back(heading("On " + devices[i], 2, fmt::format("device_{}", i + 1)));
    append(all, distinguished(Report(own, folder_).sections(size), fmt::format("_{}", i + 1)));
  }
  return all;
}

// All parts, without empty paragraphs.
Parts Report::parts(const std::optional<PictureSize>& size) const {
  Parts sections = sectionsByDevice(size);
  Parts parts = summaryOf(results_);
  append(parts, sentencesOf(expectationsBeside(results_, sections)));
  if (std::string missing = results_.missingText(); !missing.empty())
    parts.push_back(
        study::text("Not drawn yet: " + missing + ". Run the same sweep again to draw them.", Tone::failure));
  append(parts, std::move(sections));
  std::erase_if(parts, [](const ReportPart& part) {
    const auto* paragraph = std::get_if<page::Paragraph>(&part.block);
    return paragraph && paragraph->text.empty();
  });
  return parts;
}

bool Report::hasSheet() const {
  return std::any_of(galleries_.begin(), galleries_.end(), [](const Gallery& one) { return !one.shown.empty(); });
}

image::Image Report::sheet() const { return sheetOf(results_, galleries_); }

std::string Report::text() const {
  std::string text;
  for (const ReportPart& part : parts())
    if (part.media & ReportPart::kTerminal) text += std::visit(Plain(), part.block);
  return text + "\n" + describeDevice(results_) + "\n";
}

std::string Report::markdown(const std::string& page) const {
  std::string text = fmt::format("<!-- Written by `{}`. -->\n\n# {}\n\n", results_.command, results_.title);
  for (const std::string& one : {results_.question, results_.note})
    if (!one.empty()) text += one + "\n\n";
  if (!page.empty()) text += fmt::format("[The page]({}) opens from disk in a browser.\n\n", page);
  for (const ReportPart& part : parts())
    if (part.media & ReportPart::kDocument) text += std::visit(Markdown(), part.block);
  return text + "Strobe " + results_.strobe + " on " + describeDevice(results_) + ".\n";
}

std::vector<std::pair<std::string, std::string>> Report::figures() const {
  std::vector<std::pair<std::string, std::string>> figures;
  for (const ReportPart& part : parts()) {
    const auto* figure = std::get_if<page::Figure>(&part.block);
    if (figure && (part.media & ReportPart::kDocument))
      figures.emplace_back(figure->name + ".svg", page::standaloneSvg(figure->svg));
  }
  return figures;
}

page::Explorer Report::explorer(const page::Library& library, size_t most_bytes) const {
  // Reserve space for the chart library, tables, style and scripts; pictures of the layout get half of the rest.
  size_t other = library.code.size() + most_bytes / 12;
  size_t rest = (most_bytes - std::min(most_bytes, other)) / (galleries_.empty() ? 1 : 2);
  return {explorerData(results_, folder_, rest), library};
}

std::string Report::page(const page::Library& library, size_t most_bytes) const {
  std::optional<page::Explorer> interactive;
  // The explorer plots all points together, so it needs times of one device.
  if (library.found() && results_.timedDevices().size() < 2) interactive = explorer(library, most_bytes);
  static constexpr PictureSize kSizes[] = {{1, 0}, {1, 92}, {1, 85}, {2, 85}, {3, 80}, {4, 80}, {8, 80}};
  std::string html;
  for (const PictureSize& size : kSizes) {
    page::Page page;
    page.title = results_.title;
    page.note = results_.question.empty() ? results_.note : results_.question + " " + results_.note;
    page.blocks = blocksOf(parts(size), interactive);
    page.footer = {"Strobe " + results_.strobe + " on " + describeDevice(results_) + ".",
                   "Made by `" + results_.command + "`."};
    if (interactive || !library.found()) page.footer.push_back(describeLibrary(library));
    html = page::htmlOf(page);
    if (html.size() <= most_bytes || galleries_.empty()) break;
  }
  return html;
}

}  // namespace strobe::study
