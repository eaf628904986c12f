// Which format a file has: its extension decides.
#pragma once

#include <filesystem>
#include <string>

namespace cocoon {

// The last extension of the path in lower case, with its point; empty if it has none.
std::string extension_of(const std::filesystem::path& path);

enum class FileFormat { ply, obj, off, stl, text, other };

// .xyz .pts .txt .csv .npts .pwn .asc are text.
FileFormat format_of(const std::filesystem::path& path);

// .las .laz .e57 .pcd, which other programs turn into one of these.
bool is_scan_of_others(const std::filesystem::path& path);

// .gz .zip .bz2 .xz .zst.
bool is_packed(const std::filesystem::path& path);

constexpr bool is_mesh(FileFormat format) {
  return format != FileFormat::text && format != FileFormat::other;
}

}  // namespace cocoon
