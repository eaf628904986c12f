#include "app/html_report.h"

#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cocoon::app {
namespace {

ReportPage tetrahedron_page() {
  ReportPage page;
  page.title = "A title with </script> in it";
  page.geometries = {{"model",
                      {{10, 0, 0}, {11, 0, 0}, {10, 1, 0}, {10, 0, 1}},
                      {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}}};
  page.layers = {{"all", "all of it", "model", PageLayer::Kind::triangles, "#123456", 0.5, 3, 9}};
  page.stages = {{"first", "a caption", {"all"}}};
  page.tables = {{"counts", {"what", "number"}, {{std::string("angle"), 4.5}}}};
  page.warnings = {"a warning"};
  return page;
}

// The data element of a page, as a browser would read it.
nlohmann::json data_of(const std::string& html) {
  const std::string begin = "<script id=\"report\" type=\"application/json\">";
  const std::size_t from = html.find(begin) + begin.size();
  return nlohmann::json::parse(html.substr(from, html.find("</script>", from) - from));
}

std::vector<unsigned char> bytes_of_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    held += 6;
    if (held >= 8) bytes.push_back(static_cast<unsigned char>(bits >> (held -= 8) & 0xFFU));
  }
  return bytes;
}

template <class T>
std::vector<T> unpacked(const nlohmann::json& text) {
  const std::vector<unsigned char> bytes = bytes_of_base64(text.get<std::string>());
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

TEST(HtmlReport, HoldsTheSceneAndTheNumbers) {
  JsonReport numbers;
  numbers.set("surface/triangles", std::size_t{4});
  const nlohmann::json data = data_of(html_page(tetrahedron_page(), numbers));
  EXPECT_EQ(data["title"], "A title with </script> in it");
  EXPECT_EQ(data["layers"][0]["color"], "#123456");
  EXPECT_EQ(data["layers"][0]["first"], 3);
  EXPECT_EQ(data["layers"][0]["count"], 9);
  EXPECT_EQ(data["layers"][0]["kind"], "triangles");
  EXPECT_EQ(data["stages"][0]["layers"][0], "all");
  EXPECT_EQ(data["tables"][0]["rows"][0]["cells"][1], 4.5);
  EXPECT_EQ(data["warnings"][0], "a warning");
  EXPECT_EQ(data["json"]["surface"]["triangles"], 4);
}

TEST(HtmlReport, PositionsAreRelativeToTheirCenter) {
  const nlohmann::json data = data_of(html_page(tetrahedron_page(), JsonReport()));
  EXPECT_EQ(data["origin"], (std::vector<double>{10.5, 0.5, 0.5}));
  EXPECT_EQ(
      unpacked<float>(data["geometries"]["model"]["positions"]),
      (std::vector<float>{-.5F, -.5F, -.5F, .5F, -.5F, -.5F, -.5F, .5F, -.5F, -.5F, -.5F, .5F}));
  EXPECT_EQ(unpacked<std::uint32_t>(data["geometries"]["model"]["indices"]),
            (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
}

TEST(HtmlReport, KeepsTheShapeFarFromTheOrigin) {
  ReportPage page = tetrahedron_page();
  for (Point& p : page.geometries[0].points) p.x += 4500000;  // float32 steps there: 0.5
  const nlohmann::json data = data_of(html_page(page, JsonReport()));
  EXPECT_EQ(unpacked<float>(data["geometries"]["model"]["positions"])[3], 0.5F);
}

TEST(HtmlReport, OpensWithoutANetwork) {
  const std::string html = html_page(tetrahedron_page(), JsonReport());
  for (const char* reference : {"src=", "href=", "http:", "https:", "import ", "url("}) {
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
  }
}

}  // namespace
}  // namespace cocoon::app
