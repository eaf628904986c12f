#include "io/triangulation_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "delaunay/check_delaunay.h"
#include "io/byte_order.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"
#include "io/triangulation_block.h"

namespace cocoon {
namespace {

constexpr std::string_view magic = "COCOONDT";
constexpr std::uint32_t version = 1;
constexpr std::size_t header_size = 48;

// --- Reading ---------------------------------------------------------------------------------

struct Header {
  std::size_t vertices = 0;
  std::size_t cells = 0;
  std::size_t finite_cells = 0;
  std::size_t points = 0;

  // Precondition: the numbers are ids, so that nothing overflows.
  std::size_t file_size() const {
    return header_size + 24 * vertices + 32 * cells + round_up_to_8(4 * points) + checksum_size;
  }
};

// `bytes` begin with a header.
Header read_header(const std::filesystem::path& path, std::string_view bytes) {
  const auto number32 = [&](std::size_t at) {
    return load_number<std::uint32_t>(bytes.data() + at, std::endian::little);
  };
  const auto number64 = [&](std::size_t at) {
    return load_number<std::uint64_t>(bytes.data() + at, std::endian::little);
  };
  if (number32(8) != version) {
    throw file_error(path, "triangulation file of version " + std::to_string(number32(8)) +
                               ", but only version 1 can be read");
  }
  const Header header{number64(16), number64(24), number64(32), number64(40)};
  constexpr std::size_t max_cells = std::size_t{1} << 30;
  if (number32(12) != 0 || header.vertices >= infinite_vertex.value || header.cells > max_cells ||
      header.finite_cells > header.cells || header.points >= infinite_vertex.value ||
      header.points < header.vertices) {
    throw file_error(path, "the numbers in the header cannot be true: the file is damaged");
  }
  if (header.file_size() != bytes.size() + checksum_size) {
    throw file_error(path, "the file has " + std::to_string(bytes.size() + checksum_size) +
                               " bytes, but its header promises " +
                               std::to_string(header.file_size()) + ": it was cut off or damaged");
  }
  return header;
}

TriangulationArrays read_arrays(std::string_view bytes, const Header& header) {
  const char* at = bytes.data() + header_size;
  const auto next = [&at]<class T>(T) {
    const T value = load_number<T>(at, std::endian::little);
    at += sizeof(T);
    return value;
  };
  TriangulationArrays arrays;
  arrays.points.resize(header.vertices);
  for (Point& p : arrays.points) {
    p.x = next(double{});
    p.y = next(double{});
    p.z = next(double{});
  }
  arrays.cells.resize(header.cells);
  for (Cell& cell : arrays.cells) {
    for (VertexId& v : cell.vertices) v = VertexId(next(std::uint32_t{}));
    for (FacetId& f : cell.neighbors) f = FacetId(next(std::uint32_t{}));
  }
  arrays.vertex_of_point.resize(header.points);
  for (VertexId& v : arrays.vertex_of_point) v = VertexId(next(std::uint32_t{}));
  return arrays;
}

bool is_well_formed(const Cell& cell, bool must_be_infinite, std::size_t vertices) {
  for (std::size_t i = 0; i < 4; ++i) {
    const VertexId v = cell.vertices[i];
    const bool in_place = i == 3 && must_be_infinite ? v == infinite_vertex : v.index() < vertices;
    if (!in_place || std::count(cell.vertices.begin(), cell.vertices.end(), v) != 1) return false;
  }
  return true;
}

std::array<VertexId, 3> sorted_facet(const Cell& cell, int i) {
  std::array<VertexId, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    vertices[k] = cell.vertices[static_cast<std::size_t>(facet_corners[i][k])];
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

bool has_mutual_neighbors(const IdVector<CellId, Cell>& cells, CellId c) {
  for (int i = 0; i < 4; ++i) {
    const FacetId behind = cells[c].neighbors[static_cast<std::size_t>(i)];
    if (cell_of(behind).index() >= cells.size() || cell_of(behind) == c) return false;
    const Cell& other = cells[cell_of(behind)];
    if (other.neighbors[static_cast<std::size_t>(index_of(behind))] != facet_id(c, i) ||
        sorted_facet(other, index_of(behind)) != sorted_facet(cells[c], i)) {
      return false;
    }
  }
  return true;
}

// The checksum was right, so whatever is wrong here was written so.
void validate(const std::filesystem::path& path, const Header& header,
              const TriangulationArrays& arrays) {
  const auto require = [&](bool condition, const char* element, std::size_t id, const char* what) {
    if (condition) return;
    throw file_error(path, std::string(element) + " " + std::to_string(id) + " " + what +
                               ": this is no triangulation");
  };
  for (const VertexId v : arrays.points.ids()) {
    require(is_finite(arrays.points[v]), "vertex", v.index(),
            "has a coordinate that is not finite");
  }
  for (const CellId c : arrays.cells.ids()) {
    require(is_well_formed(arrays.cells[c], c.index() >= header.finite_cells, header.vertices),
            "cell", c.index(), "has a vertex out of range or out of place");
  }
  for (const CellId c : arrays.cells.ids()) {
    require(has_mutual_neighbors(arrays.cells, c), "cell", c.index(),
            "and one of its neighbors do not name each other");
  }
  IdVector<VertexId, std::uint8_t> has_point(header.vertices, 0);
  for (const PointId p : arrays.vertex_of_point.ids()) {
    const VertexId v = arrays.vertex_of_point[p];
    require(v.index() < header.vertices, "point", p.index(), "has a vertex out of range");
    has_point[v] = 1;
  }
  for (const VertexId v : has_point.ids()) {
    require(has_point[v] != 0, "vertex", v.index(), "has no input point");
  }
}

}  // namespace

void append_triangulation(SummedFile& file, const Triangulation& triangulation) {
  file.append(magic);
  file.append(version);
  file.append(std::uint32_t{0});
  file.append(std::uint64_t{triangulation.num_vertices()});
  file.append(std::uint64_t{triangulation.num_cells()});
  file.append(std::uint64_t{triangulation.num_finite_cells()});
  file.append(std::uint64_t{triangulation.vertex_of_point().size()});
  for (const Point& p : triangulation.points()) {
    file.append(p.x);
    file.append(p.y);
    file.append(p.z);
  }
  for (const Cell& cell : triangulation.cell_records()) {
    for (const VertexId v : cell.vertices) file.append(v.value);
    for (const FacetId f : cell.neighbors) file.append(f.value);
  }
  for (const VertexId v : triangulation.vertex_of_point()) file.append(v.value);
  file.fill_word();
}

std::size_t triangulation_block_size(const Triangulation& triangulation) {
  const Header header{triangulation.num_vertices(), triangulation.num_cells(),
                      triangulation.num_finite_cells(), triangulation.vertex_of_point().size()};
  return header.file_size() - checksum_size;
}

Triangulation parse_triangulation(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.substr(0, magic.size()) != magic) {
    throw file_error(path, "this is no triangulation file: it does not begin with COCOONDT");
  }
  if (bytes.size() < header_size) {
    throw file_error(path, "the file ends inside its header: it was cut off; write it again");
  }
  const Header header = read_header(path, bytes);
  TriangulationArrays arrays = read_arrays(bytes, header);
  validate(path, header, arrays);
  return Triangulation(std::move(arrays), header.finite_cells);
}

void save_triangulation(const std::filesystem::path& path, const Triangulation& triangulation) {
  SummedFile file(path);
  append_triangulation(file, triangulation);
  file.commit();
}

Triangulation load_triangulation(const std::filesystem::path& path,
                                 const LoadTriangulationOptions& options,
                                 const Execution& execution) {
  report_progress(execution, "load_triangulation", 0);
  Triangulation triangulation;
  {
    const FileBytes file = read_file(path);
    // The header knows better than the checksum what is wrong with the length.
    if (file.size >= header_size + checksum_size && file.view().substr(0, magic.size()) == magic) {
      read_header(path, file.view().substr(0, file.size - checksum_size));
    }
    triangulation = parse_triangulation(path, summed_content(file, magic, "triangulation file"));
  }
  if (options.certify) {
    const DelaunayReport report = check_delaunay(triangulation, {}, execution);
    if (!report.ok()) {
      throw file_error(path, "this is no Delaunay triangulation: " + report.first_violation);
    }
  }
  report_progress(execution, "load_triangulation", 1);
  return triangulation;
}

}  // namespace cocoon
