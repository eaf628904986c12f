// A page of pictures, a row for each model and a column for each method.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cocoon::bench {

class PictureSheet {
 public:
  explicit PictureSheet(std::string title) : title_(std::move(title)) {}

  void begin_row(const std::string& name);
  // A BMP file with a few words below it, marked as good or not. Precondition: a row has begun.
  void add(const std::string& column, const std::string& bmp, const std::string& caption,
           bool good);

  // One self-contained HTML file; it appears complete or not at all. Errors: FileError.
  void write(const std::string& file) const;

 private:
  struct Cell {
    std::string column;
    std::string bmp;
    std::string caption;
    bool good;
  };
  struct Row {
    std::string name;
    std::vector<Cell> cells;
  };
  std::string title_;
  std::vector<Row> rows_;
};

}  // namespace cocoon::bench
