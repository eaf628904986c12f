#include "io/tetrahedra_file.h"

#include <algorithm>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "io/atomic_file.h"
#include "io/encoding/base64.h"
#include "io/encoding/byte_order.h"
#include "io/encoding/number_text.h"
#include "io/encoding/point_text.h"
#include "io/file_bytes.h"
#include "io/file_format.h"

namespace cocoon {

namespace {

// The numbering of the file: vertices in the order of their first input point.
struct Numbering {
  std::vector<VertexId> vertices;
  IdVector<VertexId, std::size_t> number_of;
};

Numbering by_first_input_point(const Triangulation& triangulation) {
  Numbering numbering;
  numbering.vertices.reserve(triangulation.num_vertices());
  for (VertexId v : triangulation.vertices()) numbering.vertices.push_back(v);
  std::sort(numbering.vertices.begin(), numbering.vertices.end(), [&](VertexId a, VertexId b) {
    return triangulation.point_of_vertex(a) < triangulation.point_of_vertex(b);
  });
  numbering.number_of.resize(numbering.vertices.size());
  for (std::size_t i = 0; i < numbering.vertices.size(); ++i) {
    numbering.number_of[numbering.vertices[i]] = i;
  }
  return numbering;
}

void append_points(AtomicFile& file, const Triangulation& triangulation, const Numbering& numbering,
                   const char* line_end) {
  for (VertexId v : numbering.vertices) {
    std::string& text = file.buffer();
    append_point(text, triangulation.point(v));
    text += line_end;
    file.flush_if_full();
  }
}

void append_cells(AtomicFile& file, const Triangulation& triangulation, const Numbering& numbering,
                  std::size_t first_number, const char* line_end) {
  for (CellId c : triangulation.finite_cells()) {
    std::string& text = file.buffer();
    for (int i = 0; i < 4; ++i) {
      if (i > 0) text += ' ';
      append_number(text, numbering.number_of[triangulation.vertex(c, i)] + first_number);
    }
    text += line_end;
    file.flush_if_full();
  }
}

void write_tet(AtomicFile& file, const Triangulation& triangulation, const Numbering& numbering) {
  file.write(std::to_string(triangulation.num_vertices()) + " " +
             std::to_string(triangulation.num_finite_cells()) + "\n");
  append_points(file, triangulation, numbering, "\n");
  append_cells(file, triangulation, numbering, 0, "\n");
}

void write_medit(AtomicFile& file, const Triangulation& triangulation, const Numbering& numbering) {
  file.write("MeshVersionFormatted 2\nDimension 3\nVertices\n" +  // version 2: double
             std::to_string(triangulation.num_vertices()) + "\n");
  append_points(file, triangulation, numbering, " 0\n");
  file.write("Tetrahedra\n" + std::to_string(triangulation.num_finite_cells()) + "\n");
  append_cells(file, triangulation, numbering, 1, " 0\n");
  file.write("End\n");
}

// ---- VTK's XML format for unstructured grids, version 1.0 (64-bit lengths) ----

constexpr unsigned char vtk_tetrahedron = 10;  // VTK's number of the cell type

// One base64 block: the number of bytes as UInt64, then the bytes.
template <class Append>
void append_block(AtomicFile& file, std::size_t count, std::size_t value_bytes,
                  const Append& append_values) {
  constexpr std::size_t piece = std::size_t{1} << 14;  // values that are encoded at once
  std::string bytes;
  append_little_endian(bytes, static_cast<std::uint64_t>(count * value_bytes));
  for (std::size_t i = 0; i < count; ++i) {
    append_values(bytes, i);
    const bool last = i + 1 == count;
    if (!last && bytes.size() < piece) continue;
    // Only whole groups of three, so that the pieces join without padding between them.
    const std::size_t ready = last ? bytes.size() : bytes.size() / 3 * 3;
    append_base64(file.buffer(), std::string_view(bytes).substr(0, ready));
    bytes.erase(0, ready);
    file.flush_if_full();
  }
  append_base64(file.buffer(), bytes);
}

class VtuWriter {
 public:
  VtuWriter(AtomicFile& file, const Triangulation& triangulation, const Numbering& numbering,
            const TetrahedraValues& values, bool ascii)
      : file_(file),
        triangulation_(triangulation),
        numbering_(numbering),
        values_(values),
        ascii_(ascii) {}

  void write() {
    const std::size_t num_cells = triangulation_.num_finite_cells();
    file_.write(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
        std::to_string(triangulation_.num_vertices()) + "\" NumberOfCells=\"" +
        std::to_string(num_cells) + "\">\n<Points>\n");
    write_array<double>("Points", 3, 3 * triangulation_.num_vertices(), [&](std::size_t i) {
      return triangulation_.point(numbering_.vertices[i / 3])[static_cast<int>(i % 3)];
    });
    file_.write("</Points>\n<Cells>\n");
    write_array<std::int64_t>("connectivity", 1, 4 * num_cells, [&](std::size_t i) {
      const VertexId v = triangulation_.vertex(CellId(i / 4), static_cast<int>(i % 4));
      return static_cast<std::int64_t>(numbering_.number_of[v]);
    });
    write_array<std::int64_t>("offsets", 1, num_cells,
                              [](std::size_t i) { return static_cast<std::int64_t>(4 * (i + 1)); });
    write_array<std::uint8_t>("types", 1, num_cells, [](std::size_t) { return vtk_tetrahedron; });
    file_.write("</Cells>\n");
    write_values();
    file_.write("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  }

 private:
  void write_values() {
    if (!values_.of_vertices.empty()) file_.write("<PointData>\n");
    for (const NamedValues& column : values_.of_vertices) {
      write_array<double>(column.name.c_str(), 1, column.values.size(), [&](std::size_t i) {
        return column.values[numbering_.vertices[i].index()];
      });
    }
    if (!values_.of_vertices.empty()) file_.write("</PointData>\n");
    if (values_.of_cells.empty()) return;
    file_.write("<CellData>\n");
    for (const NamedValues& column : values_.of_cells) {
      write_array<double>(column.name.c_str(), 1, column.values.size(),
                          [&](std::size_t i) { return column.values[i]; });
    }
    file_.write("</CellData>\n");
  }

  template <class T>
  static const char* type_name() {
    if (std::is_same_v<T, double>) return "Float64";
    return std::is_same_v<T, std::int64_t> ? "Int64" : "UInt8";
  }

  template <class T, class ValueAt>
  void write_array(const char* name, int components, std::size_t count, const ValueAt& value_at) {
    file_.write(std::string("<DataArray type=\"") + type_name<T>() + "\" Name=\"" + name +
                "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"" +
                (ascii_ ? "ascii" : "binary") + "\">\n");
    if (ascii_) {
      for (std::size_t i = 0; i < count; ++i) {
        append_text(value_at(i));
        file_.buffer() += i % 12 == 11 ? '\n' : ' ';
        file_.flush_if_full();
      }
    } else {
      append_block(file_, count, sizeof(T), [&](std::string& bytes, std::size_t i) {
        append_little_endian(bytes, static_cast<T>(value_at(i)));
      });
    }
    file_.write("\n</DataArray>\n");
  }

  void append_text(double value) { append_number(file_.buffer(), value); }
  void append_text(std::int64_t value) {
    append_number(file_.buffer(), static_cast<std::size_t>(value));
  }
  void append_text(unsigned char value) {
    append_number(file_.buffer(), static_cast<std::size_t>(value));
  }

  AtomicFile& file_;
  const Triangulation& triangulation_;
  const Numbering& numbering_;
  const TetrahedraValues& values_;
  bool ascii_;
};

void require_values(const char* what, const std::vector<NamedValues>& columns, std::size_t count) {
  for (const NamedValues& column : columns) {
    if (column.name.find_first_of("<>&\"") != std::string::npos) {
      throw InputError("write_tetrahedra: the name " + in_quotes(column.name) +
                       " has a character of markup; choose another");
    }
    if (column.values.size() == count) continue;
    throw InputError("write_tetrahedra: " + std::to_string(column.values.size()) + " values " +
                     in_quotes(column.name) + " for " + std::to_string(count) + " " + what +
                     "; give one each");
  }
}

}  // namespace

void write_tetrahedra(const std::filesystem::path& path, const Triangulation& triangulation,
                      const TetrahedraWriteOptions& options, FileBatch* batch) {
  write_tetrahedra(path, triangulation, TetrahedraValues(), options, batch);
}

void write_tetrahedra(const std::filesystem::path& path, const Triangulation& triangulation,
                      const TetrahedraValues& values, const TetrahedraWriteOptions& options,
                      FileBatch* batch) {
  require_values("vertices", values.of_vertices, triangulation.num_vertices());
  require_values("finite cells", values.of_cells, triangulation.num_finite_cells());
  const std::string extension = extension_of(path);
  const bool has_values = !values.of_vertices.empty() || !values.of_cells.empty();
  if (has_values && extension != ".vtu") {
    throw InputError("write_tetrahedra: " + in_quotes(path.string()) +
                     " has no place for values; give a .vtu");
  }
  if (extension != ".vtu" && extension != ".mesh" && extension != ".tet") {
    throw file_error(path, "tetrahedra are not written with extension " + in_quotes(extension) +
                               "; use .vtu, .mesh or .tet");
  }
  const Numbering numbering = by_first_input_point(triangulation);
  AtomicFile file(path);
  if (extension == ".tet") write_tet(file, triangulation, numbering);
  if (extension == ".mesh") write_medit(file, triangulation, numbering);
  if (extension == ".vtu") {
    VtuWriter(file, triangulation, numbering, values, options.ascii).write();
  }
  file.commit(batch);
}

}  // namespace cocoon
