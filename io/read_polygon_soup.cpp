#include "io/read_polygon_soup.h"

#include "io/file_bytes.h"
#include "io/file_format.h"
#include "io/formats/obj.h"
#include "io/formats/off.h"
#include "io/formats/ply.h"
#include "io/formats/stl.h"
#include "io/input_file.h"

namespace cocoon {

PolygonSoup read_polygon_soup(const std::filesystem::path& path, bool keep_properties) {
  const FileFormat format = format_of(path);
  if (!is_mesh(format)) {
    require_input(path);  // else its name is wrong in another way
    throw file_error(path, "extension " + in_quotes(extension_of(path)) +
                               " is not that of a mesh; use .ply, .obj, .off or .stl");
  }
  const FileBytes file = read_file(path);
  if (format == FileFormat::ply) return read_ply(file, keep_properties);
  if (format == FileFormat::obj) return read_obj(file);
  if (format == FileFormat::off) return read_off(file);
  return read_stl(file);
}

}  // namespace cocoon
