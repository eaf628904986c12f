#include "io/file_format.h"

namespace cocoon {

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

FileFormat format_of(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return FileFormat::ply;
  if (extension == ".obj") return FileFormat::obj;
  if (extension == ".off") return FileFormat::off;
  if (extension == ".stl") return FileFormat::stl;
  for (const char* text : {".xyz", ".pts", ".txt", ".csv", ".npts", ".pwn", ".asc"}) {
    if (extension == text) return FileFormat::text;
  }
  return FileFormat::other;
}

}  // namespace cocoon
