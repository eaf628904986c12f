#include "io/formats/ply.h"

#include <limits>
#include <string>
#include <vector>

#include "io/encoding/byte_order.h"
#include "io/encoding/number_text.h"
#include "io/encoding/single_precision.h"
#include "io/formats/ply_body.h"
#include "io/formats/ply_header.h"
#include "io/formats/ply_properties.h"

namespace cocoon {

namespace {

constexpr std::int64_t strip_end = -1;

// Which properties of an element the reader takes: their roles, in the order of the file.
enum class Role { none, x, y, z, indices };

Role role_of(const PlyElement& element, const PlyProperty& property) {
  if (element.name == "vertex") {
    if (property.name == "x") return Role::x;
    if (property.name == "y") return Role::y;
    if (property.name == "z") return Role::z;
  }
  if (element.name == "face" || element.name == "tristrips") {
    if (property.name == "vertex_indices" || property.name == "vertex_index") return Role::indices;
  }
  return Role::none;
}

// The role of each property. Throws if one is missing, given twice, or a list where a number
// belongs.
std::vector<Role> roles_of(const PlyElement& element, const FileBytes& file) {
  std::vector<Role> roles;
  int given[5] = {};
  for (const PlyProperty& property : element.properties) {
    const Role role = role_of(element, property);
    roles.push_back(role);
    ++given[static_cast<int>(role)];
    if (role != Role::none && property.is_list != (role == Role::indices)) {
      throw file_error(file.path, element.line,
                       "property " + in_quotes(property.name) + " must " +
                           (property.is_list ? "not " : "") + "be a list");
    }
  }
  const bool is_vertex = element.name == "vertex";
  for (Role role : {Role::x, Role::y, Role::z, Role::indices}) {
    const int wanted = is_vertex == (role != Role::indices) ? 1 : 0;
    const int found = given[static_cast<int>(role)];
    if (found == wanted) continue;
    throw file_error(file.path, element.line,
                     "element " + in_quotes(element.name) + (found == 0 ? " lacks" : " repeats") +
                         (is_vertex ? " a property x, y or z" : " its list vertex_indices") +
                         "; write the file anew with one of each");
  }
  return roles;
}

template <class Body>
class ElementReader {
 public:
  ElementReader(const FileBytes& file, Body& body, bool keep_properties, PolygonSoup& soup)
      : file_(file), body_(body), keep_properties_(keep_properties), soup_(soup) {}

  void read(const PlyElement& element) {
    if (element.name == "vertex") {
      read_vertices(element);
    } else if (element.name == "face" || element.name == "tristrips") {
      read_faces(element);
    } else if (!element.properties.empty()) {
      for (std::size_t i = 0; i < element.count; ++i) {
        body_.begin_element(element, i);
        for (const PlyProperty& property : element.properties) skip(property);
        body_.end_element();
      }
    }
  }

 private:
  void skip(const PlyProperty& property) {
    const std::size_t count =
        property.is_list ? body_.list_length(property.count_type, property.type) : 1;
    body_.skip(property.type, count);
  }

  void read_vertices(const PlyElement& element) {
    const std::vector<Role> roles = roles_of(element, file_);
    std::vector<bool> taken;
    taken.reserve(roles.size());
    for (Role role : roles) taken.push_back(role != Role::none);
    KeptProperties kept(element, taken, keep_properties_);
    soup_.points.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      body_.begin_element(element, i);
      Point point;
      for (std::size_t k = 0; k < roles.size(); ++k) {
        switch (roles[k]) {
          case Role::x:
            point.x = body_.number(element.properties[k].type);
            break;
          case Role::y:
            point.y = body_.number(element.properties[k].type);
            break;
          case Role::z:
            point.z = body_.number(element.properties[k].type);
            break;
          default:
            if (!kept.read(k, body_)) skip(element.properties[k]);
        }
      }
      if (!is_finite(point)) soup_.non_finite.note(i, body_.line());
      soup_.points.push_back(point);
      body_.end_element();
    }
    soup_.properties = kept.take();
  }

  void read_faces(const PlyElement& element) {
    const bool are_strips = element.name == "tristrips";
    if (element.count == 0) return;
    const std::vector<Role> roles = roles_of(element, file_);
    soup_.face_ends.reserve(soup_.face_ends.size() + element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      body_.begin_element(element, i);
      for (std::size_t k = 0; k < roles.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (roles[k] != Role::indices) {
          skip(property);
        } else if (are_strips) {
          read_strips(property);
        } else {
          read_face(property);
        }
      }
      body_.end_element();
    }
  }

  void read_face(const PlyProperty& property) {
    const std::size_t length = body_.list_length(property.count_type, property.type);
    for (std::size_t i = 0; i < length; ++i) {
      soup_.corners.push_back(body_.integer(property.type));
    }
    end_face();
  }

  // Corner i of a strip makes a triangle with the two before it; every second one is turned over,
  // so that all have the orientation of the first.
  void read_strips(const PlyProperty& property) {
    const std::size_t length = body_.list_length(property.count_type, property.type);
    std::int64_t before[2] = {};
    std::size_t in_strip = 0;
    for (std::size_t i = 0; i < length; ++i) {
      const std::int64_t corner = body_.integer(property.type);
      if (corner == strip_end) {
        in_strip = 0;
        continue;
      }
      if (in_strip >= 2) {
        const bool turned = in_strip % 2 == 1;
        soup_.corners.push_back(before[turned ? 1 : 0]);
        soup_.corners.push_back(before[turned ? 0 : 1]);
        soup_.corners.push_back(corner);
        end_face();
      }
      before[0] = before[1];
      before[1] = corner;
      ++in_strip;
    }
  }

  void end_face() {
    soup_.end_face();
    if (body_.line() != 0) soup_.face_lines.push_back(body_.line());
  }

  const FileBytes& file_;
  Body& body_;
  bool keep_properties_;
  PolygonSoup& soup_;
};

template <class Body>
PolygonSoup read_elements(const FileBytes& file, const PlyHeader& header, bool keep_properties) {
  PolygonSoup soup;
  Body body(file, header);
  ElementReader<Body> reader(file, body, keep_properties, soup);
  for (const PlyElement& element : header.elements) reader.read(element);
  soup.surplus_lines = body.surplus_lines();
  soup.first_surplus_line = body.first_surplus_line();
  soup.trailing_bytes = body.trailing_bytes();
  return soup;
}

void check_elements(const FileBytes& file, const PlyHeader& header) {
  for (const char* name : {"vertex", "face", "tristrips"}) {
    std::size_t found = 0;
    for (const PlyElement& element : header.elements) {
      if (element.name != name) continue;
      if (++found > 1) {
        throw file_error(file.path, element.line,
                         "a second element '" + element.name + "'; it is not clear which is meant");
      }
    }
    if (found == 0 && std::string(name) == "vertex") {
      throw file_error(file.path, "has no element 'vertex' with x, y, z; nothing to read");
    }
  }
}

// ---- writing ----

// No reader would take back what it cannot tell from the rest of a header.
void require_names(const VertexProperties& properties) {
  for (const VertexProperty& column : properties.columns) {
    const std::string& name = column.declaration.name;
    const bool is_name = !name.empty() && name.find_first_of(" \t\n\v\f\r") == std::string::npos;
    if (is_name && name != "x" && name != "y" && name != "z") continue;
    throw FileError("a PLY file cannot have a property named " + in_quotes(name) +
                    "; use letters and digits, but not x, y or z");
  }
}

std::string header_text(std::size_t points, const TriangleMesh* mesh,
                        const VertexProperties& properties, const MeshWriteOptions& options) {
  require_names(properties);
  const std::string type = options.single_precision ? "float" : "double";
  std::string text = "ply\nformat ";
  text += options.ascii ? "ascii" : "binary_little_endian";
  text += " 1.0\ncomment written by cocoon\nelement vertex " + std::to_string(points) + "\n";
  for (const char* axis : {"x", "y", "z"}) text += "property " + type + " " + axis + "\n";
  for (const VertexProperty& column : properties.columns) {
    text += "property " + type_text(column.declaration) + " " + column.declaration.name + "\n";
  }
  if (mesh != nullptr && !mesh->triangles.empty()) {
    // int is what most readers expect; beyond its range the same bytes are a uint.
    const bool fits_int = points <= static_cast<std::size_t>(std::numeric_limits<int>::max());
    text += "element face " + std::to_string(mesh->triangles.size()) + "\nproperty list uchar " +
            (fits_int ? "int" : "uint") + " vertex_indices\n";
  }
  return text + "end_header\n";
}

template <class T>
void append_coordinate(std::string& bytes, T value, bool ascii) {
  if (ascii) {
    append_number(bytes, value);
  } else {
    append_little_endian(bytes, value);
  }
}

void write_position(AtomicFile& file, const Point& point, const MeshWriteOptions& options) {
  for (int axis = 0; axis < 3; ++axis) {
    float rounded = 0;
    if (options.ascii && axis > 0) file.buffer() += ' ';
    if (!options.single_precision) {
      append_coordinate(file.buffer(), point[axis], options.ascii);
    } else if (round_to_float(point[axis], rounded)) {
      append_coordinate(file.buffer(), rounded, options.ascii);
    } else {
      throw file_error(file.target(),
                       "a coordinate is too large for float; write doubles (without --float)");
    }
  }
}

void write_vertices(AtomicFile& file, Points points, const VertexProperties& properties,
                    const MeshWriteOptions& options) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    write_position(file, points[i], options);
    for (const VertexProperty& column : properties.columns) {
      if (options.ascii) {
        append_as_text(column, i, file.buffer());
      } else {
        append_as_bytes(column, i, file.buffer());
      }
    }
    if (options.ascii) file.buffer() += '\n';
    file.flush_if_full();
  }
}

void write_faces(AtomicFile& file, const TriangleMesh& mesh, const MeshWriteOptions& options) {
  for (const Triangle& triangle : mesh.triangles) {
    std::string& bytes = file.buffer();
    bytes += options.ascii ? '3' : '\3';
    for (VertexId v : triangle) {
      if (options.ascii) {
        bytes += ' ';
        append_number(bytes, v.index());
      } else {
        append_little_endian(bytes, v.value);
      }
    }
    if (options.ascii) bytes += '\n';
    file.flush_if_full();
  }
}

}  // namespace

PolygonSoup read_ply(const FileBytes& file, bool keep_properties) {
  const PlyHeader header = read_ply_header(file);
  check_elements(file, header);
  if (header.encoding == PlyEncoding::ascii) {
    return read_elements<PlyTextBody>(file, header, keep_properties);
  }
  return read_elements<PlyBinaryBody>(file, header, keep_properties);
}

void write_ply(AtomicFile& file, const TriangleMesh& mesh, const VertexProperties& properties,
               const MeshWriteOptions& options) {
  file.write(header_text(mesh.points.size(), &mesh, properties, options));
  write_vertices(file, mesh.points.span(), properties, options);
  write_faces(file, mesh, options);
}

void write_ply(AtomicFile& file, Points points, const MeshWriteOptions& options) {
  file.write(header_text(points.size(), nullptr, {}, options));
  write_vertices(file, points, {}, options);
}

}  // namespace cocoon
