// SPDX-License-Identifier: MIT
// Pages: well-formed HTML for every kind of block, no external resources, and escaped text.
#include "page/page.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "page/templates.h"

namespace strobe::page {
namespace page_test {

// Names of unclosed elements, or of the first mismatched end tag; "" if the HTML is well-formed.
std::string unsound(const std::string& html) {
  static const std::regex tag(R"rx(<(/?)([a-z][a-z0-9]*)((?:[^>"]|"[^"]*")*?)(/?)>)rx");
  static const std::set<std::string> kAlone = {"meta", "link", "img", "input"};
  std::vector<std::string> open;
  std::string body = html.substr(html.find("<html"));
  for (size_t from = body.find("<style>"), end; from != std::string::npos; from = body.find("<style>", end)) {
    end = body.find("</style>", from);
    body.erase(from + 7, end - from - 7);
    end = from + 7;
  }
  for (std::sregex_iterator at(body.begin(), body.end(), tag), end; at != end; ++at) {
    std::string name = (*at)[2];
    if (kAlone.count(name) || (*at)[4] == "/") continue;
    if ((*at)[1] != "/") open.push_back(name);
    else if (open.empty() || open.back() != name) return "</" + name + ">";
    else open.pop_back();
  }
  return open.empty() ? "" : open.back();
}

Page made() {
  Page page{"A & <b>", "About `this`", {}, {"Made by a test"}};
  page.blocks = {Heading{"One", 2, "one"},
                 Paragraph{"Text with <tags> & **weight**"},
                 Heading{"Two", 2, "two"},
                 Paragraph{"It holds.", Paragraph::Kind::finding},
                 Table{"numbers", {"a", {"b", true}}, {{"x", "1"}}},
                 Figure{"<svg class=\"chart\"></svg>\n", "a curve"},
                 Code{"strobe render <x>"},
                 Pictures{{{"\x89PNG", 4, 2, "truth", "", "t"}, {"abc", 4, 2, "a \"method\"", "seen", "m"}}},
                 PictureComparison{"t", {"m"}, ""},
                 Details{"More", {Heading{"Inside", 3}, Code{"x"}}}};
  return page;
}

TEST(Page, EveryBlockIsWellFormed) { EXPECT_EQ(unsound(htmlOf(made())), ""); }

TEST(Page, TextsAreEscaped) {
  std::string html = htmlOf(made());
  for (const char* shown :
       {"<title>A &amp; &lt;b&gt;</title>", "About <code>this</code>", "&lt;tags&gt; &amp; <strong>weight</strong>",
        "<figcaption>a &quot;method&quot;</figcaption>", "strobe render &lt;x&gt;"})
    EXPECT_NE(html.find(shown), std::string::npos) << shown;
}

TEST(Page, PicturesAreEmbeddedOnceAndHaveTexts) {
  std::string html = htmlOf(made());
  EXPECT_NE(html.find("src=\"data:image/png;base64,YWJj\""), std::string::npos);
  EXPECT_EQ(html.find("YWJj", html.find("YWJj") + 1), std::string::npos) << "the comparison reuses the picture";
  static const std::regex without(R"rx(<img(?![^>]*alt=))rx");
  EXPECT_FALSE(std::regex_search(html, without));
  EXPECT_NE(html.find("alt=\"truth\""), std::string::npos) << "the caption if no other text is given";
  EXPECT_NE(html.find("alt=\"seen\""), std::string::npos);
}

TEST(Page, PicturesHaveTheirType) {
  std::string html =
      htmlOf(Page{"a", "", {Pictures{{{"\xff\xd8\xff", 4, 2, "a JPEG"}, {"\x89PNG", 4, 2, "a PNG"}}}}, {}});
  EXPECT_NE(html.find("src=\"data:image/jpeg;base64,/9j/\""), std::string::npos);
  EXPECT_NE(html.find("src=\"data:image/png;base64,iVBORw==\""), std::string::npos);
}

TEST(Page, NeedsNoExternalResources) {
  std::string html = htmlOf(made());
  for (const char* foreign : {"http:", "https:", "@import", "url(", "src=\"/"})
    EXPECT_EQ(html.find(foreign), std::string::npos) << foreign;
}

TEST(Page, HasAScriptOnlyWithAComparison) {
  EXPECT_NE(htmlOf(made()).find("<script>"), std::string::npos);
  EXPECT_EQ(htmlOf(Page{"a", "", {Paragraph{"b"}}, {}}).find("<script"), std::string::npos);
}

// Removes scripts: the text in a script is not HTML.
std::string withoutScripts(std::string html) {
  for (size_t from = html.find("<script"); from != std::string::npos; from = html.find("<script", from))
    html.erase(from, html.find("</script>", from) + 9 - from);
  return html;
}

TEST(Page, ExplorerHasItsDataAndLibrary) {
  Page page = made();
  page.blocks.push_back(Explorer{{{"title", "</script><b>"}}, {"a('</script>')", "charts", "may be copied */"}});
  page.blocks.push_back(Still{{Heading{"Points", 2, "points"}, Paragraph{"as a list"}}});
  std::string html = htmlOf(page);
  EXPECT_EQ(unsound(withoutScripts(html)), "");
  EXPECT_NE(html.find("<a href=\"#explore\">Explore</a>"), std::string::npos);
  EXPECT_NE(html.find(R"({"title":"\u003c/script>\u003cb>"})"), std::string::npos);
  EXPECT_NE(html.find("/*\nmay be copied * /*/\na('<\\/script>')"), std::string::npos);
  EXPECT_NE(html.find("<div class=\"still\">\n<h2 id=\"points\">"), std::string::npos);
  EXPECT_EQ(htmlOf(made()).find("explorer"), std::string::npos) << "style and scripts only with an explorer";
  std::string style = std::string(asset("page.css")) + std::string(asset("explorer.css"));
  static const std::regex classes(R"rx(class="([a-z]+)")rx");
  std::string skeleton(asset("explorer.html"));
  for (std::sregex_iterator at(skeleton.begin(), skeleton.end(), classes), end; at != end; ++at)
    EXPECT_NE(style.find("." + (*at)[1].str()), std::string::npos) << (*at)[1];
}

TEST(Page, HeadingsWithIdsAreTheNavigation) {
  std::string html = htmlOf(made());
  EXPECT_NE(html.find("<a href=\"#two\">Two</a>"), std::string::npos);
  EXPECT_NE(html.find("<h2 id=\"two\">"), std::string::npos);
  EXPECT_EQ(htmlOf(Page{"a", "", {Heading{"One", 2, "one"}}, {}}).find("<nav"), std::string::npos)
      << "one section has no navigation";
}

TEST(Page, IsDeterministic) { EXPECT_EQ(htmlOf(made()), htmlOf(made())); }

TEST(Page, EveryClassHasAStyle) {
  std::string html = htmlOf(made()), style = std::string(asset("page.css")) + std::string(asset("chart.css"));
  static const std::regex classes(R"rx(class="([a-z ]+)")rx"), name("[a-z]+");
  for (std::sregex_iterator at(html.begin(), html.end(), classes), end; at != end; ++at) {
    std::string list = (*at)[1];
    for (std::sregex_iterator one(list.begin(), list.end(), name); one != end; ++one)
      EXPECT_TRUE(one->str() == "flicker" || style.find("." + one->str()) != std::string::npos) << one->str();
  }
}

TEST(Base64, EncodesEveryLength) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace page_test
}  // namespace strobe::page
