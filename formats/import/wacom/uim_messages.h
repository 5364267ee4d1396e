#pragma once
// Reads the encodings of Wacom's Universal Ink Model, by Protocol Buffers.

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "formats/import/wacom/uim_ink.h"

namespace pentimento::sketch {

/// Version 3.1: the contents of the chunks INPT and INKD. Errors: kBadInput "NAME: what".
Result<UimInk> read_uim_31(const std::string& name, std::string_view input, std::string_view ink);

/// Version 3.0: the content of the chunk DATA, or the same as JSON. Errors: kBadInput "NAME: what".
Result<UimInk> read_uim_30(const std::string& name, std::string_view data);
Result<UimInk> read_uim_json(const std::string& name, std::string_view json);

}  // namespace pentimento::sketch
