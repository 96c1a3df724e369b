// SPDX-License-Identifier: MIT
#include "base/json_text.h"

#include <utility>
#include <vector>

#include "base/json.h"

template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace strobe {

namespace {

// Handles the library's events. Creates an object or a list at its end, with its final size.
class JsonBuilder : public Json::json_sax_t {
 public:
  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(int64_t value) override { return add(value); }
  bool number_unsigned(uint64_t value) override { return add(value); }
  bool number_float(double value, const std::string&) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(Json::binary_t&) override { return false; }
  bool key(std::string& key) override { return key_ = std::move(key), true; }
  bool start_object(size_t) override { return open(); }
  bool start_array(size_t) override { return open(); }

  bool end_object() override {
    Json::object_t object;
    object.reserve(fields_.size() - begins_.back());
    for (size_t i = begins_.back(); i < fields_.size(); ++i)
      object.emplace_back(std::move(fields_[i].first), std::move(fields_[i].second));
    return close(std::move(object));
  }

  bool end_array() override {
    Json::array_t list;
    list.reserve(fields_.size() - begins_.back());
    for (size_t i = begins_.back(); i < fields_.size(); ++i) list.push_back(std::move(fields_[i].second));
    return close(std::move(list));
  }

  bool parse_error(size_t, const std::string&, const Json::exception&) override { return false; }

  Json take() { return std::move(fields_.front().second); }

 private:
  bool add(Json value) { return fields_.emplace_back(std::move(key_), std::move(value)), true; }

  bool open() {
    add(nullptr);
    begins_.push_back(fields_.size());
    return true;
  }

  bool close(Json made) {
    fields_.resize(begins_.back());
    begins_.pop_back();
    fields_.back().second = std::move(made);
    return true;
  }

  std::string key_;
  // Entries of all open objects and lists, the innermost last. Entries of a list have no key.
  std::vector<std::pair<std::string, Json>> fields_;
  std::vector<size_t> begins_;  // index of the first entry of each open object or list
};

}  // namespace

Json jsonFromText(const std::string& text) {
  JsonBuilder builder;
  return Json::sax_parse(text, &builder) ? builder.take() : Json(Json::value_t::discarded);
}

std::string textOf(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace strobe
