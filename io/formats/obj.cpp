#include "io/formats/obj.h"

#include <string>
#include <string_view>

#include "io/encoding/number_text.h"
#include "io/encoding/point_text.h"
#include "io/encoding/text_lines.h"

namespace cocoon {

namespace {

class ObjReader {
 public:
  explicit ObjReader(const FileBytes& file) : file_(file), lines_(text_of(file)) {}

  PolygonSoup read() {
    std::string_view statement;
    while (next_statement(statement)) {
      Fields fields(statement);
      const std::string_view keyword = fields.word();
      if (is_vertex(keyword)) read_vertex(fields);
      if (is_face(keyword)) read_face(fields);
    }
    if (soup_.points.empty()) {
      throw file_error(file_.path, "has no vertex (no line 'v x y z'); is it an OBJ file?");
    }
    return std::move(soup_);
  }

 private:
  // The next line without its comment, joined with the lines that continue it if it is read.
  bool next_statement(std::string_view& statement) {
    if (!lines_.next(statement)) return false;
    line_ = lines_.number();
    statement = without_comment(statement);
    // Elsewhere a backslash may end the name of a folder, which must not take the next vertex away.
    if (!is_continued(statement) || !is_read(Fields(statement).word())) return true;

    joined_.clear();
    while (is_continued(statement)) {
      joined_.append(statement.substr(0, statement.rfind('\\')));
      joined_ += ' ';
      statement = lines_.next(statement) ? without_comment(statement) : std::string_view{};
    }
    joined_.append(statement);
    statement = joined_;
    return true;
  }

  // By a backslash, behind which there may be blanks.
  static bool is_continued(std::string_view statement) {
    const std::size_t last = statement.find_last_not_of(" \t");
    return last != std::string_view::npos && statement[last] == '\\';
  }

  static bool is_vertex(std::string_view keyword) { return keyword == "v"; }
  static bool is_face(std::string_view keyword) { return keyword == "f" || keyword == "fo"; }
  static bool is_read(std::string_view keyword) { return is_vertex(keyword) || is_face(keyword); }

  void read_vertex(Fields& fields) {
    double xyz[3];
    for (double& value : xyz) {
      if (!fields.number(value)) {
        const std::string_view found = fields.word();
        throw file_error(file_.path, line_,
                         "a vertex needs three numbers, found " +
                             (found.empty() ? "the end of the line" : in_quotes(found)) +
                             "; correct this line");
      }
    }
    const Point point{xyz[0], xyz[1], xyz[2]};
    if (!is_finite(point)) soup_.non_finite.note(soup_.points.size(), line_);
    soup_.points.push_back(point);
  }

  void read_face(Fields& fields) {
    while (!fields.done()) {
      const std::string_view corner = fields.word();
      const char* at = corner.data();
      const char* end = at + corner.size();
      std::int64_t index = 0;
      if (!parse_integer(at, end, index) || (at != end && *at != '/') || index == 0) {
        throw file_error(
            file_.path, line_,
            "a corner of a face is " + in_quotes(corner) +
                ", not i, i/t, i//n or i/t/n with indices from 1 or -1 on; correct this line");
      }
      // Negative: counted back from the last vertex so far.
      soup_.corners.push_back(index > 0 ? index - 1
                                        : static_cast<std::int64_t>(soup_.points.size()) + index);
    }
    soup_.end_face();
    soup_.face_lines.push_back(line_);
  }

  const FileBytes& file_;
  TextLines lines_;
  std::size_t line_ = 0;  // where the current statement begins
  std::string joined_;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup read_obj(const FileBytes& file) { return ObjReader(file).read(); }

void write_obj(AtomicFile& file, Points points) {
  file.write("# written by cocoon\n");
  for (const Point& point : points) {
    std::string& text = file.buffer();
    text += "v ";
    append_point(text, point);
    text += '\n';
    file.flush_if_full();
  }
}

void write_obj(AtomicFile& file, const TriangleMesh& mesh) {
  write_obj(file, mesh.points.span());
  for (const Triangle& triangle : mesh.triangles) {
    std::string& text = file.buffer();
    text += 'f';
    for (VertexId v : triangle) {
      text += ' ';
      append_number(text, v.index() + 1);
    }
    text += '\n';
    file.flush_if_full();
  }
}

}  // namespace cocoon
