#pragma once
// What a picture tells of itself, as attributes of OpenEXR that have the kind of what they tell:
// other programs can calculate with numbers, not with texts. Internal to formats/exr.

#include <ImfAttribute.h>

#include <memory>
#include <optional>
#include <string>

namespace pentimento::exr {

/// `text` as an int, a double, two ints ("1024 x 768"), or two or three doubles ("0.1 0.2 0.3"),
/// where that gives the text back to the letter; else as a string.
std::unique_ptr<Imf::Attribute> typed_attribute(const std::string& text);

/// The text of an attribute that typed_attribute() made; nothing for other kinds.
std::optional<std::string> attribute_text(const Imf::Attribute& attribute);

}  // namespace pentimento::exr
