#include "io/file_format.h"

#include <algorithm>
#include <initializer_list>

namespace cocoon {

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

namespace {

bool is_one_of(const std::string& extension, std::initializer_list<const char*> extensions) {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

}  // namespace

FileFormat format_of(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return FileFormat::ply;
  if (extension == ".obj") return FileFormat::obj;
  if (extension == ".off") return FileFormat::off;
  if (extension == ".stl") return FileFormat::stl;
  return is_one_of(extension, {".xyz", ".pts", ".txt", ".csv", ".npts", ".pwn", ".asc"})
             ? FileFormat::text
             : FileFormat::other;
}

bool is_scan_of_others(const std::filesystem::path& path) {
  return is_one_of(extension_of(path), {".las", ".laz", ".e57", ".pcd"});
}

bool is_packed(const std::filesystem::path& path) {
  return is_one_of(extension_of(path), {".gz", ".zip", ".bz2", ".xz", ".zst"});
}

}  // namespace cocoon
