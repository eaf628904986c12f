#include "app/report/html_report.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace cocoon::app {
namespace {

ReportPage tetrahedron_page() {
  ReportPage page;
  page.title = "A title with </script> in it";
  page.verdicts = {"closed"};
  page.points = {{{10, 0, 0}, {11, 0, 0}, {10, 1, 0}, {10, 0, 1}},
                 {{"model", 0, 4}},
                 {{"a", "b"}, {0, 0, 1, 1}},
                 {{"deviation", {0, -0.5, 0.25, 0}}}};
  page.geometries = {{"model",
                      "the model",
                      PageGeometry::Kind::triangles,
                      {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3},
                      {{"bottom", "side"}, {0, 1, 1, 1}}}};
  page.layers = {{"sides", "its sides", "model", "#123456", {1}, "deviation", 0.5}};
  page.stages = {{"first", "a caption", {"sides"}}};
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

std::vector<float> floats_of(const nlohmann::json& text) {
  const std::vector<unsigned char> bytes = bytes_of_base64(text.get<std::string>());
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
  return values;
}

// By the description in html_report.cpp.
std::vector<std::uint32_t> integers_of(const nlohmann::json& text) {
  std::vector<std::uint32_t> numbers;
  std::uint64_t code = 0;
  int shift = 0;
  for (const unsigned char byte : bytes_of_base64(text.get<std::string>())) {
    code |= static_cast<std::uint64_t>(byte & 127U) << shift;
    shift += 7;
    if (byte >= 128) continue;
    const std::uint64_t last = numbers.empty() ? 0 : numbers.back();
    numbers.push_back(
        static_cast<std::uint32_t>(code % 2 == 0 ? last + code / 2 : last - code / 2 - 1));
    code = 0;
    shift = 0;
  }
  return numbers;
}

TEST(HtmlReport, HoldsTheSceneAndTheNumbers) {
  JsonReport numbers;
  numbers.set("surface/triangles", std::size_t{4});
  const nlohmann::json data = data_of(html_page(tetrahedron_page(), numbers));
  EXPECT_EQ(data["title"], "A title with </script> in it");
  EXPECT_EQ(data["verdicts"][0], "closed");
  EXPECT_EQ(data["points"]["parts"][0]["name"], "model");
  EXPECT_EQ(data["points"]["parts"][0]["count"], 4);
  EXPECT_EQ(data["points"]["texts"][1], "b");
  EXPECT_EQ(integers_of(data["points"]["labels"]), (std::vector<std::uint32_t>{0, 0, 1, 1}));
  EXPECT_EQ(floats_of(data["points"]["fields"][0]["values"]),
            (std::vector<float>{0, -.5F, .25F, 0}));
  EXPECT_EQ(data["geometries"][0]["kind"], "triangles");
  EXPECT_EQ(integers_of(data["geometries"][0]["labels"]), (std::vector<std::uint32_t>{0, 1, 1, 1}));
  EXPECT_EQ(data["layers"][0]["color"], "#123456");
  EXPECT_EQ(data["layers"][0]["labels"], std::vector<int>{1});
  EXPECT_EQ(data["layers"][0]["field"], "deviation");
  EXPECT_EQ(data["stages"][0]["layers"][0], "sides");
  EXPECT_EQ(data["tables"][0]["rows"][0]["cells"][1], 4.5);
  EXPECT_EQ(data["warnings"][0], "a warning");
  EXPECT_EQ(data["json"]["surface"]["triangles"], 4);
}

TEST(HtmlReport, PositionsAreRelativeToTheirCenter) {
  const nlohmann::json data = data_of(html_page(tetrahedron_page(), JsonReport()));
  EXPECT_EQ(data["origin"], (std::vector<double>{10.5, 0.5, 0.5}));
  EXPECT_EQ(data["unit"], 1);
  EXPECT_EQ(
      floats_of(data["points"]["positions"]),
      (std::vector<float>{-.5F, -.5F, -.5F, .5F, -.5F, -.5F, -.5F, .5F, -.5F, -.5F, -.5F, .5F}));
}

TEST(HtmlReport, KeepsTheShapeFarFromTheOrigin) {
  ReportPage page = tetrahedron_page();
  for (Point& p : page.points.positions) p.x += 4500000;  // float32 steps there: 0.5
  const nlohmann::json data = data_of(html_page(page, JsonReport()));
  EXPECT_EQ(floats_of(data["points"]["positions"])[3], 0.5F);
}

TEST(HtmlReport, KeepsTheShapeOfSizesThatAreNoFloats) {
  for (const double size : {0x1p200, 0x1p-190, 0x1p64, 0x1p-64}) {
    ReportPage page = tetrahedron_page();
    for (Point& p : page.points.positions) p = size * p;
    for (double& value : page.points.fields[0].values) value *= size;
    const nlohmann::json data = data_of(html_page(page, JsonReport()));
    const double unit = data["unit"];
    const std::vector<float> positions = floats_of(data["points"]["positions"]);
    const double field_unit = data["points"]["fields"][0]["unit"];
    const std::vector<float> values = floats_of(data["points"]["fields"][0]["values"]);
    EXPECT_EQ(unit * positions[0], -.5 * size);
    EXPECT_EQ(field_unit * values[1], -.5 * size);
    EXPECT_EQ(std::abs(positions[0]), 1);
    EXPECT_EQ(std::abs(values[1]), 1);
  }
}

// Small steps of either sign, and differences that need all 32 bits.
TEST(HtmlReport, PackedIndicesComeBack) {
  ReportPage page = tetrahedron_page();
  page.points.labels.of_element = {0, 63, 64, 0, 4294967295U, 0, 2147483648U, 1, 70000, 69999};
  page.geometries[0].indices = {3, 0, 2, 1, 1, 3};
  const nlohmann::json data = data_of(html_page(page, JsonReport()));
  EXPECT_EQ(integers_of(data["points"]["labels"]), page.points.labels.of_element);
  EXPECT_EQ(integers_of(data["geometries"][0]["indices"]), page.geometries[0].indices);
}

TEST(HtmlReport, IndexBeyondThePointsIsAnError) {
  ReportPage page = tetrahedron_page();
  page.geometries[0].indices[0] = 4;
  EXPECT_THROW(html_page(page, JsonReport()), std::logic_error);
}

// The page asks for nothing; that the viewer asks for nothing either is seen in a browser
// (tests/app/viewer). Its one address names a language of documents.
TEST(HtmlReport, OpensWithoutANetwork) {
  std::string html = html_page(tetrahedron_page(), JsonReport());
  const std::string language = "http://www.w3.org/1999/xhtml";
  for (std::size_t at; (at = html.find(language)) != std::string::npos;) {
    html.erase(at, language.size());
  }
  for (const char* reference : {"http:", "https:", "@import", "url("}) {
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
  }
  html.erase(html.find("<script>"));  // the viewer
  for (const char* reference : {"src=", "href=", "import "}) {
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
  }
}

TEST(HtmlReport, HoldsTheViewerAndItsNotice) {
  const std::string html = html_page(tetrahedron_page(), JsonReport());
  for (const char* mark : {"{{viewer}}", "{{report}}"}) {
    EXPECT_EQ(html.find(mark), std::string::npos) << mark;
  }
  EXPECT_GT(html.size(), 200000U);
  EXPECT_NE(html.find("three.js authors"), std::string::npos);
}

}  // namespace
}  // namespace cocoon::app
