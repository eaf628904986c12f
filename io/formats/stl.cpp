#include "io/formats/stl.h"

#include <cctype>
#include <string>
#include <string_view>

#include "geom/search/point_welder.h"
#include "io/encoding/byte_order.h"
#include "io/encoding/number_text.h"
#include "io/encoding/point_text.h"
#include "io/encoding/single_precision.h"
#include "io/encoding/text_lines.h"

namespace cocoon {

namespace {

constexpr std::size_t header_bytes = 84;  // 80 of text, 4 of count
constexpr std::size_t facet_bytes = 50;   // normal, 3 corners, 2 bytes of attributes

bool equals_ignoring_case(std::string_view text, std::string_view lower_case) {
  if (text.size() != lower_case.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::tolower(static_cast<unsigned char>(text[i])) != lower_case[i]) return false;
  }
  return true;
}

// ---- binary ----

std::size_t announced_facets(const FileBytes& file) {
  return load_number<std::uint32_t>(file.data.get() + 80, std::endian::little);
}

// Behind the facets there may be a few bytes, too few for another facet.
bool has_size_of_binary(const FileBytes& file) {
  if (file.size < header_bytes) return false;
  const std::size_t count = announced_facets(file);
  const std::size_t bytes = file.size - header_bytes;
  if (bytes < facet_bytes * count) return false;
  const std::size_t behind = bytes - facet_bytes * count;
  return behind == 0 || (count > 0 && behind < facet_bytes);
}

PolygonSoup read_binary(const FileBytes& file) {
  const std::size_t count = announced_facets(file);
  PolygonSoup soup;
  PointWelder welder(soup.points);
  soup.corners.reserve(3 * count);
  soup.face_ends.reserve(count);
  const char* at = file.data.get() + header_bytes;
  for (std::size_t facet = 0; facet < count; ++facet, at += facet_bytes) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const char* xyz = at + 12 * (corner + 1);
      const Point point{load_number<float>(xyz, std::endian::little),
                        load_number<float>(xyz + 4, std::endian::little),
                        load_number<float>(xyz + 8, std::endian::little)};
      if (!is_finite(point)) soup.non_finite.note(soup.points.size(), 0);
      soup.corners.push_back(static_cast<std::int64_t>(welder.add(point)));
    }
    soup.end_face();
  }
  soup.trailing_bytes = file.size - header_bytes - facet_bytes * count;
  return soup;
}

// ---- text ----

class StlTextReader {
 public:
  explicit StlTextReader(const FileBytes& file)
      : file_(file), lines_(text_of(file)), welder_(soup_.points) {}

  PolygonSoup read() {
    while (next_word()) {
      if (is("solid")) {
        if (in_solid_) fail("a solid begins before the last one ended");
        in_solid_ = true;
        skip_name();
      } else if (is_end_of_solid() && in_solid_) {
        in_solid_ = false;
        skip_name_after_end();
      } else if (is("facet") && in_solid_) {
        read_facet();
      } else {
        fail("expected " + std::string(in_solid_ ? "facet or endsolid" : "solid") + ", found " +
             in_quotes(word_));
      }
    }
    if (in_solid_) fail("the file ends without endsolid; it is cut off");
    return std::move(soup_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw file_error(file_.path, lines_.number(), message);
  }

  bool is(std::string_view lower_case) const { return equals_ignoring_case(word_, lower_case); }

  // Assimp has written "endsolidAssimpScene".
  bool is_end_of_solid() const { return equals_ignoring_case(word_.substr(0, 8), "endsolid"); }

  bool next_word() {
    while (fields_.done()) {
      std::string_view line;
      if (!lines_.next(line)) return false;
      fields_ = Fields(line);
    }
    word_ = fields_.word();
    if (is("end")) join_end();
    return true;
  }

  // The rest of the line, up to where facets begin, or the end of the solid.
  void skip_name() {
    while (!fields_.done()) {
      const Fields here = fields_;
      const std::string_view word = fields_.word();
      if (begins_facet(word, fields_) || equals_ignoring_case(word, "endsolid")) {
        fields_ = here;
        return;
      }
    }
  }

  // The same, up to the next solid if it has facets on this line: "solid" may be part of a name.
  void skip_name_after_end() {
    Fields next_solid("");
    while (!fields_.done()) {
      const Fields here = fields_;
      const std::string_view word = fields_.word();
      if (equals_ignoring_case(word, "solid")) next_solid = here;
      if (!begins_facet(word, fields_)) continue;
      fields_ = next_solid.done() ? here : next_solid;
      return;
    }
  }

  static bool begins_facet(std::string_view word, Fields behind) {
    return equals_ignoring_case(word, "facet") && !behind.done() &&
           equals_ignoring_case(behind.word(), "normal");
  }

  // Some write "end solid", "end facet" and "end loop".
  void join_end() {
    const Fields behind_end = fields_;
    const std::string_view what = fields_.word();
    for (const std::string_view known : {"endsolid", "endfacet", "endloop"}) {
      if (equals_ignoring_case(what, known.substr(3))) word_ = known;
    }
    if (is("end")) fields_ = behind_end;
  }

  void next_word_of_facet() {
    if (!next_word()) fail("the file ends within a facet; it is cut off");
  }

  // The last word of a file may be half of one.
  [[noreturn]] void fail_expected(const std::string& expected) {
    if (fields_.done() && lines_.rest_without_blanks().empty()) {
      fail("the file ends within a facet; it is cut off");
    }
    fail("expected " + expected + ", found " + in_quotes(word_));
  }

  void expect(std::string_view lower_case) {
    next_word_of_facet();
    if (!is(lower_case)) fail_expected(std::string(lower_case));
  }

  // facet normal a b c / outer loop / vertex x y z (three times or more) / endloop / endfacet
  void read_facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) next_word_of_facet();
    expect("outer");
    expect("loop");
    const std::size_t line = lines_.number();
    const std::size_t begin = soup_.corners.size();
    for (next_word_of_facet(); is("vertex"); next_word_of_facet()) read_corner();
    if (!is("endloop")) fail_expected("vertex or endloop");
    if (soup_.corners.size() < begin + 3) fail("a facet has fewer than three corners");
    expect("endfacet");
    soup_.end_face();
    soup_.face_lines.push_back(line);
  }

  void read_corner() {
    double xyz[3];
    for (double& value : xyz) {
      next_word_of_facet();
      if (!Fields(word_).number(value)) fail_expected("a number");
    }
    const Point point{xyz[0], xyz[1], xyz[2]};
    if (!is_finite(point)) soup_.non_finite.note(soup_.points.size(), lines_.number());
    soup_.corners.push_back(static_cast<std::int64_t>(welder_.add(point)));
  }

  const FileBytes& file_;
  TextLines lines_;
  Fields fields_{std::string_view()};
  std::string_view word_;
  bool in_solid_ = false;
  PolygonSoup soup_;
  PointWelder welder_;
};

bool begins_with_solid(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && equals_ignoring_case(text.substr(begin, 5), "solid");
}

// ---- writing ----

Vec3 unit_normal(const TriangleMesh& mesh, const Triangle& triangle) {
  const Point& a = mesh.points[triangle[0]];
  return unit(cross(mesh.points[triangle[1]] - a, mesh.points[triangle[2]] - a));
}

void append_floats(AtomicFile& file, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    float rounded = 0;
    if (!round_to_float(v[axis], rounded)) {
      throw file_error(file.target(),
                       "a coordinate is too large for the floats of binary STL; write ascii STL, "
                       "PLY, OBJ or OFF");
    }
    append_little_endian(file.buffer(), rounded);
  }
}

void append_text(AtomicFile& file, const char* keywords, const Vec3& v) {
  std::string& text = file.buffer();
  text += keywords;
  text += ' ';
  append_point(text, v);
  text += '\n';
}

void write_binary(AtomicFile& file, const TriangleMesh& mesh) {
  std::string header = "binary STL written by cocoon";  // must not begin with "solid"
  header.resize(header_bytes - 4, ' ');
  append_little_endian(header, static_cast<std::uint32_t>(mesh.triangles.size()));
  file.write(header);
  for (const Triangle& triangle : mesh.triangles) {
    append_floats(file, unit_normal(mesh, triangle));
    for (VertexId v : triangle) append_floats(file, mesh.points[v]);
    append_little_endian(file.buffer(), std::uint16_t{0});
    file.flush_if_full();
  }
}

void write_text(AtomicFile& file, const TriangleMesh& mesh) {
  file.write("solid cocoon\n");
  for (const Triangle& triangle : mesh.triangles) {
    append_text(file, "facet normal", unit_normal(mesh, triangle));
    file.buffer() += "outer loop\n";
    for (VertexId v : triangle) append_text(file, "vertex", mesh.points[v]);
    file.buffer() += "endloop\nendfacet\n";
    file.flush_if_full();
  }
  file.write("endsolid cocoon\n");
}

}  // namespace

PolygonSoup read_stl(const FileBytes& file) {
  if (file.size == 0) {
    throw file_error(file.path, "is empty (0 bytes); was it written completely?");
  }
  if (has_size_of_binary(file)) return read_binary(file);
  const bool holds_nul = file.view().find('\0') != std::string_view::npos;
  if (begins_with_solid(file.view()) && !holds_nul) return StlTextReader(file).read();
  if (file.size < header_bytes) {
    throw file_error(file.path,
                     "is no STL file: it neither begins with 'solid' nor has the 84 "
                     "bytes of a binary header; check the extension");
  }
  const std::size_t announced = announced_facets(file);
  throw file_error(file.path, "is no STL file, or damaged: as binary STL it announces " +
                                  std::to_string(announced) + " facets, which take " +
                                  std::to_string(header_bytes + facet_bytes * announced) +
                                  " bytes, but has " + std::to_string(file.size) +
                                  "; check the extension, or get a whole copy");
}

void write_stl(AtomicFile& file, const TriangleMesh& mesh, const MeshWriteOptions& options) {
  if (options.ascii) {
    write_text(file, mesh);
  } else {
    write_binary(file, mesh);
  }
}

}  // namespace cocoon
