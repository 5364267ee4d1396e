#pragma once
// The page of a batch's report, without its report. Its files lie in `page`, and travel inside the
// program.

#include <string_view>

namespace pentimento {

/// The text of `report.html`, `report.css` or `report.js`; empty for another name.
std::string_view page_source(std::string_view file);

}  // namespace pentimento
