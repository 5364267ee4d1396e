#pragma once
// Turns header and events into lines of JSON. Members stand in the documented order, numbers in the
// shortest form that reads back exactly. What is absent stays absent, but all parameters of the
// model are written.

#include <string>

#include "formats/log/tables/events.h"

namespace pentimento::log {

/// One line without its line feed.
std::string header_json(const Header& header);
/// One line without its line feed; an Extension's as it was read.
std::string event_json(const Event& event);

}  // namespace pentimento::log
