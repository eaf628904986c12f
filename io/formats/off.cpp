#include "io/formats/off.h"

#include <string>
#include <string_view>

#include "io/encoding/number_text.h"
#include "io/encoding/point_text.h"
#include "io/encoding/text_lines.h"

namespace cocoon {

namespace {

bool skip_word(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

class OffReader {
 public:
  explicit OffReader(const FileBytes& file) : file_(file), lines_(checked_text(file)) {}

  PolygonSoup read() {
    read_header();
    read_vertices();
    read_faces();
    soup_.trailing_bytes = bytes_left();
    return std::move(soup_);
  }

 private:
  // Binary OFF has a text header; without this it would be called "no text file".
  static std::string_view checked_text(const FileBytes& file) {
    const std::string_view first_line = file.view().substr(0, file.view().find_first_of("\r\n"));
    if (first_line.find("BINARY") != std::string_view::npos) {
      throw file_error(file.path, "is binary OFF, which is not read; save it as text, or as PLY");
    }
    return text_of(file);
  }

  // The next line that holds something besides a comment: `wanted` number `index` of `count`.
  Fields next_line(const char* wanted, std::size_t index = 0, std::size_t count = 1) {
    std::string_view line;
    while (lines_.next(line)) {
      Fields fields(without_comment(line));
      if (!fields.done()) return fields;
    }
    throw file_error(file_.path, lines_.number(),
                     std::string("the file ends before ") + wanted + " " + std::to_string(index) +
                         " of " + std::to_string(count) +
                         "; it is cut off or its counts are wrong");
  }

  // From the next line on that holds something besides a comment.
  std::size_t bytes_left() {
    std::string_view line;
    for (;;) {
      const std::string_view rest = lines_.rest_without_blanks();
      if (!lines_.next(line)) return 0;
      if (!Fields(without_comment(line)).done()) return rest.size();
    }
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw file_error(file_.path, lines_.number(), message);
  }

  void read_header() {
    Fields fields = next_line("header line");
    std::string_view text = fields.rest();
    // The format says ST C N; MeshLab writes N C ST.
    while (skip_word(text, "ST") || skip_word(text, "C") || skip_word(text, "N")) {
    }
    if (text.starts_with("4OFF") || text.starts_with("nOFF") || text.starts_with("4nOFF")) {
      fail(
          "4OFF and nOFF have other than three coordinates a vertex and are not read; "
          "write the mesh as OFF");
    }
    const bool has_keyword = skip_word(text, "OFF");
    const char first = fields.rest().empty() ? ' ' : fields.rest().front();
    if (!has_keyword && (first < '0' || first > '9')) {
      fail("is no OFF file: it begins with neither OFF nor a count; check the extension");
    }
    Fields counts = has_keyword ? Fields(text) : fields;
    if (counts.done()) counts = next_line("line of counts");
    num_vertices_ = read_count(counts, "vertices");
    num_faces_ = read_count(counts, "faces");
    // A count of edges may follow; nobody needs it.
  }

  std::size_t read_count(Fields& fields, const char* name) {
    std::int64_t count = 0;
    if (!fields.integer(count) || count < 0) {
      fail(std::string("the number of ") + name +
           " is missing, negative or no number; correct this line");
    }
    // A line takes a character and its end (which the last one may lack).
    const auto wanted = static_cast<std::size_t>(count);
    const std::size_t available = lines_.rest().size();
    if (wanted > available / 2 + 1) {
      fail("announces " + std::to_string(count) + " " + name + ", but only " +
           std::to_string(available) +
           " bytes follow; the file is cut off or its counts are wrong");
    }
    return wanted;
  }

  void read_vertices() {
    soup_.points.reserve(num_vertices_);
    for (std::size_t i = 0; i < num_vertices_; ++i) {
      Fields fields = next_line("vertex", i, num_vertices_);
      double xyz[3];
      for (double& value : xyz) {
        if (!fields.number(value)) {
          fail("a vertex needs three numbers; found " + found(fields) + "; correct this line");
        }
      }
      const Point point{xyz[0], xyz[1], xyz[2]};
      if (!is_finite(point)) soup_.non_finite.note(i, lines_.number());
      soup_.points.push_back(point);
    }
  }

  void read_faces() {
    soup_.face_ends.reserve(num_faces_);
    soup_.face_lines.reserve(num_faces_);
    for (std::size_t i = 0; i < num_faces_; ++i) {
      Fields fields = next_line("face", i, num_faces_);
      std::int64_t num_corners = 0;
      if (!fields.integer(num_corners) || num_corners < 0) {
        fail("a face begins with its number of corners; found " + found(fields));
      }
      for (std::int64_t k = 0; k < num_corners; ++k) {
        std::int64_t corner = 0;
        if (!fields.integer(corner)) {
          fail("a face of " + std::to_string(num_corners) + " corners lacks one; found " +
               found(fields));
        }
        soup_.corners.push_back(corner);
      }
      soup_.end_face();
      soup_.face_lines.push_back(lines_.number());
    }
  }

  static std::string found(Fields& fields) {
    const std::string_view word = fields.word();
    return word.empty() ? "the end of the line" : in_quotes(word);
  }

  const FileBytes& file_;
  TextLines lines_;
  std::size_t num_vertices_ = 0;
  std::size_t num_faces_ = 0;
  PolygonSoup soup_;
};

void write_points_and_counts(AtomicFile& file, Points points, std::size_t num_faces) {
  file.write("OFF\n" + std::to_string(points.size()) + " " + std::to_string(num_faces) + " 0\n");
  for (const Point& point : points) {
    std::string& text = file.buffer();
    append_point(text, point);
    text += '\n';
    file.flush_if_full();
  }
}

}  // namespace

PolygonSoup read_off(const FileBytes& file) { return OffReader(file).read(); }

void write_off(AtomicFile& file, Points points) { write_points_and_counts(file, points, 0); }

void write_off(AtomicFile& file, const TriangleMesh& mesh) {
  write_points_and_counts(file, mesh.points.span(), mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    std::string& text = file.buffer();
    text += '3';
    for (VertexId v : triangle) {
      text += ' ';
      append_number(text, v.index());
    }
    text += '\n';
    file.flush_if_full();
  }
}

}  // namespace cocoon
