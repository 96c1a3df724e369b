// SPDX-License-Identifier: MIT
// Text of an XML 1.0 document, indented.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace strobe::scene {

// Writer of an indented XML document; elements are appended in order, and open elements are nested.
class Xml {
 public:
  using Attributes = std::vector<std::pair<std::string, std::string>>;

  // <tag a="b"/>
  void empty(const std::string& tag, const Attributes& attributes) { line("<" + tag + text(attributes) + "/>"); }
  // <tag name="..." value="..."/>
  void value(const std::string& tag, const std::string& name, const std::string& value) {
    empty(tag, {{"name", name}, {"value", value}});
  }
  // <tag a="b">, until `close`.
  void open(const std::string& tag, const Attributes& attributes);
  void close();
  // Repeated hyphens, which a comment must not have, become one hyphen.
  void comment(std::string_view text);

  const std::string& document() const { return document_; }

 private:
  static std::string text(const Attributes& attributes);
  void line(const std::string& text);

  std::string document_;
  std::vector<std::string> open_;
};

}  // namespace strobe::scene
