// SPDX-License-Identifier: MIT
#include "page/page.h"

#include <openssl/evp.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "page/markup.h"
#include "page/templates.h"

namespace strobe::page {

std::string base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '\0');
  auto* letters = reinterpret_cast<unsigned char*>(text.data());  // OpenSSL writes the final zero too
  EVP_EncodeBlock(letters, reinterpret_cast<const unsigned char*>(bytes.data()), int(bytes.size()));
  return text;
}

namespace {

// Writes blocks as HTML, each with the template of its kind.
class Writer {
 public:
  std::string blocks(const std::vector<Block>& blocks) {
    for (const Block& block : blocks) remember(block);
    std::string html;
    for (const Block& block : blocks) html += std::visit([this](const auto& one) { return written(one); }, block);
    return html;
  }
  bool compares() const { return compares_; }
  const Explorer* explorer() const { return explorer_; }

 private:
  void remember(const Block& block) {
    if (const auto* pictures = std::get_if<Pictures>(&block))
      for (const PagePicture& picture : pictures->pictures)
        if (!picture.name.empty())
          STROBE_ASSERT(captions_.emplace(picture.name, picture.caption).second, "{}", picture.name);
  }

  std::string written(const Heading& heading) {
    return rendered(
        "heading.mustache",
        {{"level", std::clamp(heading.level, 2, 4)}, {"id", heading.id}, {"text_html", inlineHtml(heading.text)}});
  }

  std::string written(const Paragraph& paragraph) {
    static const char* const kClasses[] = {"", "soft", "finding", "finding failure"};
    if (paragraph.text.empty()) return "";
    return rendered("paragraph.mustache",
                    {{"classes", kClasses[int(paragraph.kind)]}, {"text_html", inlineHtml(paragraph.text)}});
  }

  std::string written(const Table& table) { return htmlOf(table); }

  std::string written(const Figure& figure) {
    return rendered("figure.mustache", {{"svg", figure.svg}, {"caption_html", inlineHtml(figure.caption)}});
  }

  std::string written(const Pictures& pictures) {
    Json list = Json::array();
    for (const PagePicture& picture : pictures.pictures)
      list.push_back({{"id", picture.name},
                      {"width", picture.width},
                      {"height", picture.height},
                      {"alt", picture.alt.empty() ? inlinePlain(picture.caption) : picture.alt},
                      {"data", base64(picture.file)},
                      {"type", picture.file.starts_with("\xff\xd8") ? "jpeg" : "png"},
                      {"caption_html", inlineHtml(picture.caption)}});
    return rendered("pictures.mustache", {{"pixels", pictures.pixels}, {"pictures", list}});
  }

  std::string written(const PictureComparison& comparison) {
    compares_ = true;
    Json others = Json::array();
    const std::string& chosen = comparison.chosen.empty() ? comparison.others.at(0) : comparison.chosen;
    for (const std::string& name : comparison.others)
      others.push_back({{"id", name}, {"label", captionOf(name)}, {"chosen", name == chosen}});
    return rendered("comparison.mustache", {{"reference", comparison.reference},
                                            {"reference_label", captionOf(comparison.reference)},
                                            {"others", others}});
  }

  std::string written(const Code& code) { return rendered("code.mustache", {{"text", code.text}}); }

  std::string written(const Details& details) {
    std::string inside = blocks(details.blocks);
    return rendered("details.mustache", {{"summary_html", inlineHtml(details.summary)}, {"blocks_html", inside}});
  }

  std::string written(const Explorer& explorer) {
    STROBE_ASSERT(!explorer_ && explorer.library.found(), "a page has one explorer, with its library");
    explorer_ = &explorer;
    return std::string(asset("explorer.html"));
  }

  std::string written(const Still& still) {
    return rendered("still.mustache", {{"blocks_html", blocks(still.blocks)}});
  }

  std::string captionOf(const std::string& name) const {
    auto found = captions_.find(name);
    STROBE_ASSERT(found != captions_.end(), "the picture '{}' of a comparison is neither before nor beside it", name);
    return inlinePlain(found->second);
  }

  std::map<std::string, std::string> captions_;  // by name of the picture
  bool compares_ = false;
  const Explorer* explorer_ = nullptr;
};

// Replaces every `what`. Used for text inside a <script> element or a comment, which must not end there.
std::string replacedAll(std::string text, const std::string& what, const std::string& with) {
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

constexpr const char* kExplorerScripts[] = {"explorer_model.js", "explorer_charts.js", "explorer_effects.js",
                                            "explorer_table.js", "explorer_point.js",  "explorer.js"};

void addExplorer(const Explorer& explorer, Json& json) {
  json["explorer"] = true;
  json["data"] = replacedAll(explorer.data.dump(), "<", "\\u003c");
  json["library"] = "/*\n" + replacedAll(explorer.library.licence, "*/", "* /") + "*/\n" +
                    replacedAll(explorer.library.code, "</script", "<\\/script");
  json["style"] = json["style"].get<std::string>() + std::string(asset("explorer.css"));
  std::string script;
  for (const char* name : kExplorerScripts) script += std::string(asset(name)) + "\n";
  json["explorer_script"] = script;
}

Json navigationOf(const Page& page) {
  Json links = Json::array();
  for (const Block& block : page.blocks) {
    if (const auto* heading = std::get_if<Heading>(&block))
      if (heading->level == 2 && !heading->id.empty())
        links.push_back({{"id", heading->id}, {"text_html", inlineHtml(heading->text)}});
    if (std::holds_alternative<Explorer>(block)) links.push_back({{"id", "explore"}, {"text_html", "Explore"}});
  }
  return links;
}

}  // namespace

std::string htmlOf(const Page& page) {
  Writer writer;
  Json json = {{"title", inlinePlain(page.title)},          {"title_html", inlineHtml(page.title)},
               {"note_html", inlineHtml(page.note)},        {"links", navigationOf(page)},
               {"blocks_html", writer.blocks(page.blocks)}, {"footer", Json::array()}};
  for (const std::string& text : page.footer) json["footer"].push_back({{"text_html", inlineHtml(text)}});
  json["navigation"] = json["links"].size() > 1;
  json["style"] = std::string(asset("light.css")) + std::string(asset("page.css")) + std::string(asset("chart.css"));
  json["script"] = writer.compares() ? std::string(asset("comparison.js")) : "";
  if (writer.explorer()) addExplorer(*writer.explorer(), json);
  return rendered("page.mustache", json);
}

}  // namespace strobe::page
