#include "formats/image/draw_text.h"

#include <algorithm>
#include <vector>

#include "formats/image/module_function.h"
#include "formats/image/text_module.h"

namespace pentimento {

namespace {
Error failed(const std::string& text) {
  return {ErrorCode::kIo, "the text \"" + text + "\" cannot be drawn"};
}
PentimentoText line_of(const std::string& text, const TextStyle& style) {
  return {text.c_str(), style.scale, style.thickness};
}
}  // namespace

Result<int> text_width(const std::string& text, const TextStyle& style) {
  static const auto measure = image::module_function<decltype(pentimento_measure_text)>(
      image::kTextModule, "pentimento_measure_text");
  if (!measure) return measure.error();
  const PentimentoText line = line_of(text, style);
  int width = 0, height = 0;
  if (measure->call(&line, &width, &height) != 0) return failed(text);
  return width;
}

Result<void> draw_text(const std::string& text, const TextStyle& style, int x, int y,
                       Field<std::uint8_t>& mask) {
  static const auto draw = image::module_function<decltype(pentimento_draw_text)>(
      image::kTextModule, "pentimento_draw_text");
  if (!draw) return draw.error();
  const PentimentoText line = line_of(text, style);
  // The module takes rows without padding.
  const auto width = static_cast<std::size_t>(mask.width());
  std::vector<std::uint8_t> packed(width * static_cast<std::size_t>(mask.height()));
  for (int row = 0; row < mask.height(); ++row)
    std::copy_n(mask.row(row), width, packed.data() + static_cast<std::size_t>(row) * width);
  if (draw->call(&line, x, y, packed.data(), mask.width(), mask.height()) != 0) return failed(text);
  for (int row = 0; row < mask.height(); ++row)
    std::copy_n(packed.data() + static_cast<std::size_t>(row) * width, width, mask.row(row));
  return {};
}

}  // namespace pentimento
