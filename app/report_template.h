// The page of the HTML reports, app/report_template.html, as the build embeds it.
#pragma once

namespace cocoon::app {

// Contains the mark "{{report}}" once, where the data go.
extern const char* const report_template;

}  // namespace cocoon::app
