#include "formats/exr/typed_attribute.h"

#include <ImfDoubleAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "formats/io/utf8.h"

namespace pentimento::exr {

namespace {
/// `text` as numbers with `separator` between them; empty if it is anything else.
template <typename Number>
std::vector<Number> numbers_in(std::string_view text, std::string_view separator) {
  std::vector<Number> numbers;
  for (;;) {
    const std::size_t end = std::min(text.find(separator), text.size());
    Number value{};
    const auto [stop, error] = std::from_chars(text.data(), text.data() + end, value);
    if (error != std::errc{} || stop != text.data() + end) return {};
    numbers.push_back(value);
    if (end == text.size()) return numbers;
    text.remove_prefix(end + separator.size());
  }
}

/// The attribute of `text` read as numbers; null if it is not so many or so few numbers.
std::unique_ptr<Imf::Attribute> numeric(const std::string& text) {
  if (const auto n = numbers_in<int>(text, " x "); n.size() == 1)
    return std::make_unique<Imf::IntAttribute>(n[0]);
  else if (n.size() == 2)
    return std::make_unique<Imf::V2iAttribute>(IMATH_NAMESPACE::V2i(n[0], n[1]));
  const auto n = numbers_in<double>(text, " ");
  if (n.size() == 1) return std::make_unique<Imf::DoubleAttribute>(n[0]);
  if (n.size() == 2) return std::make_unique<Imf::V2dAttribute>(IMATH_NAMESPACE::V2d(n[0], n[1]));
  if (n.size() == 3)
    return std::make_unique<Imf::V3dAttribute>(IMATH_NAMESPACE::V3d(n[0], n[1], n[2]));
  return nullptr;
}

/// The attribute as one of the given kind; null if it is of another.
template <typename Kind>
const Kind* as(const Imf::Attribute& attribute) {
  return dynamic_cast<const Kind*>(&attribute);
}
}  // namespace

std::unique_ptr<Imf::Attribute> typed_attribute(const std::string& text) {
  std::unique_ptr<Imf::Attribute> number = numeric(text);
  if (number && attribute_text(*number) == text) return number;
  return std::make_unique<Imf::StringAttribute>(valid_utf8(text));
}

std::optional<std::string> attribute_text(const Imf::Attribute& attribute) {
  if (const auto* text = as<Imf::StringAttribute>(attribute)) return text->value();
  if (const auto* n = as<Imf::IntAttribute>(attribute)) return fmt::format("{}", n->value());
  if (const auto* n = as<Imf::DoubleAttribute>(attribute)) return fmt::format("{}", n->value());
  if (const auto* n = as<Imf::V2iAttribute>(attribute))
    return fmt::format("{} x {}", n->value().x, n->value().y);
  if (const auto* n = as<Imf::V2dAttribute>(attribute))
    return fmt::format("{} {}", n->value().x, n->value().y);
  if (const auto* n = as<Imf::V3dAttribute>(attribute))
    return fmt::format("{} {} {}", n->value().x, n->value().y, n->value().z);
  return std::nullopt;
}

}  // namespace pentimento::exr
