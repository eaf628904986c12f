#include "app/json_report.h"

#include <nlohmann/json.hpp>

namespace cocoon::app {

using Json = nlohmann::ordered_json;

struct JsonReport::Tree {
  Json root = Json::object();

  Json& at(std::string_view path) {
    Json* node = &root;
    for (;;) {
      const std::size_t slash = path.find('/');
      node = &(*node)[std::string(path.substr(0, slash))];
      if (slash == std::string_view::npos) return *node;
      path.remove_prefix(slash + 1);
    }
  }
};

JsonReport::JsonReport() : tree_(std::make_unique<Tree>()) {}
JsonReport::~JsonReport() = default;
JsonReport::JsonReport(JsonReport&&) noexcept = default;
JsonReport& JsonReport::operator=(JsonReport&&) noexcept = default;

JsonReport JsonReport::copy() const {
  JsonReport result;
  result.tree_->root = tree_->root;
  return result;
}

void JsonReport::set(std::string_view path, bool value) { tree_->at(path) = value; }
void JsonReport::set(std::string_view path, std::size_t value) { tree_->at(path) = value; }
void JsonReport::set(std::string_view path, std::ptrdiff_t value) { tree_->at(path) = value; }
void JsonReport::set(std::string_view path, int value) { tree_->at(path) = value; }
void JsonReport::set(std::string_view path, double value) { tree_->at(path) = value; }
void JsonReport::set(std::string_view path, const char* value) { tree_->at(path) = value; }
void JsonReport::set(std::string_view path, const std::string& value) { tree_->at(path) = value; }

void JsonReport::set(std::string_view path, const std::vector<std::size_t>& values) {
  tree_->at(path) = values;
}
void JsonReport::set(std::string_view path, const std::vector<double>& values) {
  tree_->at(path) = values;
}
void JsonReport::set(std::string_view path, const std::vector<std::string>& values) {
  tree_->at(path) = values;
}
void JsonReport::set(std::string_view path, const JsonReport& object) {
  tree_->at(path) = object.tree_->root;
}
void JsonReport::add(std::string_view path, std::size_t count) {
  Json& value = tree_->at(path);
  value = count + (value.is_null() ? 0 : value.get<std::size_t>());
}
void JsonReport::set_empty_array(std::string_view path) { tree_->at(path) = Json::array(); }
void JsonReport::append(std::string_view path, const JsonReport& object) {
  tree_->at(path).push_back(object.tree_->root);
}
void JsonReport::append(std::string_view path, const std::string& value) {
  tree_->at(path).push_back(value);
}
void JsonReport::append(std::string_view path, double value) { tree_->at(path).push_back(value); }

// File names may hold any bytes: what is not UTF-8 is replaced and does not end the report.
std::string JsonReport::text() const {
  return tree_->root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string JsonReport::script_text() const {
  std::string text = tree_->root.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    text.replace(at, 1, "\\u003c");
  }
  return text;
}

}  // namespace cocoon::app
