// The page of the HTML reports and its viewer, as the build embeds them.
#pragma once

namespace cocoon::app {

// app/report/report_template.html. Contains the marks "{{report}}", where the data go, and then
// "{{viewer}}", where the viewer goes, once each.
extern const char* const report_template;

// app/viewer/viewer.min.js: a script without "</script>" in it.
extern const char* const report_viewer;

}  // namespace cocoon::app
