#include "bench/picture_sheet.h"

#include "io/atomic_file.h"
#include "io/encoding/base64.h"

namespace cocoon::bench {

void PictureSheet::begin_row(const std::string& name) { rows_.push_back({name, {}}); }

void PictureSheet::add(const std::string& column, const std::string& bmp,
                       const std::string& caption, bool good) {
  rows_.back().cells.push_back({column, bmp, caption, good});
}

void PictureSheet::write(const std::string& file) const {
  AtomicFile out(file);
  std::string& html = out.buffer();
  html += "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>" + title_ +
          "</title>\n<style>body{font:14px sans-serif;margin:2em}td,th{padding:4px 8px;"
          "text-align:center;vertical-align:top}th{position:sticky;top:0;background:#fff}"
          "td:first-child{text-align:left;max-width:12em}small{color:#555}"
          ".bad small{color:#b00;font-weight:bold}</style>\n<h1>" +
          title_ +
          "</h1>\n<p>Gray: triangles seen from outside; red: from inside, through holes or "
          "because they are oriented the wrong way. Captions in red: not closed, or other parts or "
          "handles than the true surface has.</p>\n<table>\n";
  if (!rows_.empty()) {
    html += "<tr><th></th>";
    for (const Cell& cell : rows_.front().cells) html += "<th>" + cell.column + "</th>";
    html += "</tr>\n";
  }
  for (const Row& row : rows_) {
    html += "<tr><td>" + row.name + "</td>";
    for (const Cell& cell : row.cells) {
      html += cell.good ? "<td>" : "<td class=\"bad\">";
      html += "<img alt=\"" + row.name + ", " + cell.column + "\" src=\"data:image/bmp;base64,";
      append_base64(html, cell.bmp);
      html += "\"><br><small>" + cell.caption + "</small></td>";
      out.flush_if_full();
    }
    html += "</tr>\n";
  }
  html += "</table>\n</html>\n";
  out.commit();
}

}  // namespace cocoon::bench
