// The header of a PLY file (Turk 1994): encoding, and which elements with which properties follow.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/file_bytes.h"

namespace cocoon {

enum class PlyEncoding { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t size_of(PlyType type);

// "char", "uchar", ..., "double": the names of the original format (and "int64", "uint64", which it
// lacks).
std::string_view name_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  // of the value, or of a list's values
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  // of a list's length

  friend bool operator==(const PlyProperty&, const PlyProperty&) = default;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t line = 0;  // of the header
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;   // offset of the first byte behind the header
  std::size_t lines = 0;  // of the header
};

// Reads the header at the start of `file`. Lines end with LF, CR LF or CR, the one that follows the
// word "ply"; so the first byte of a binary body is known even if it looks like a line end. Throws
// FileError with the line for: another first word, a missing or unknown format, unknown types or
// keywords, counts that are negative or that the rest of the file cannot hold, no end_header.
PlyHeader read_ply_header(const FileBytes& file);

}  // namespace cocoon
