#include "replay/commands/exchange_pigments.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/optics/paints/pigment_library.h"
#include "core/optics/plain_name.h"
#include "formats/log/json/nearest_name.h"
#include "formats/log/parse/fields.h"
#include "formats/log/parse/palette_file.h"
#include "replay/log/palette.h"
#include "replay/play/channel_change.h"

namespace pentimento {

namespace {

Error wrong(const std::string& what) {
  return {ErrorCode::kUsage, "--palette: " + what};
}

Result<PigmentExchange> parse_pair(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return wrong(fmt::format("\"{}\" is not NAME=PAINT", text));
  PigmentExchange exchange{std::string(text.substr(0, equals)), {}};
  const std::string paint(text.substr(equals + 1));
  exchange.paint.name = paint;
  if (paint.starts_with('#')) {
    exchange.paint.color = log::parse_hex_color(paint);
    if (!exchange.paint.color) return wrong("\"" + paint + "\" is no colour #rrggbb");
    return exchange;
  }
  exchange.paint.library = true;
  if (in_pigment_library(paint)) return exchange;
  return wrong("no pigment of the library is called \"" + paint + "\"" +
               did_you_mean(paint, library_pigment_names()));
}

/// Index of the dump's pigment of that name, however written; -1 if there is none.
Eigen::Index find_pigment(const std::vector<Pigment>& palette, const std::string& name) {
  const std::string wanted = plain_name(name);
  for (std::size_t i = 0; i < palette.size(); ++i)
    if (plain_name(palette[i].name) == wanted) return static_cast<Eigen::Index>(i);
  return -1;
}

Error unknown_pigment(const std::vector<Pigment>& palette, const std::string& name) {
  std::string known;
  for (const Pigment& pigment : palette) known += (known.empty() ? "" : ", ") + pigment.name;
  return wrong(fmt::format("the dump has no pigment \"{}\", but {}", name, known));
}

}  // namespace

Result<std::vector<PigmentExchange>> parse_exchanges(const std::string& text) {
  std::vector<PigmentExchange> exchanges;
  if (text.find('=') == std::string::npos) {
    Result<std::vector<log::PigmentSpec>> palette = log::read_palette_file(text);
    if (!palette) return palette.error();
    for (log::PigmentSpec& paint : *palette) exchanges.push_back({paint.name, std::move(paint)});
    return exchanges;
  }
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    Result<PigmentExchange> pair = parse_pair(std::string_view(text).substr(start, comma - start));
    if (!pair) return pair.error();
    exchanges.push_back(std::move(*pair));
    start = comma + 1;
  }
  return exchanges;
}

Result<void> exchange_pigments(const std::vector<PigmentExchange>& exchanges, StateDump& dump) {
  if (!channel_per_pigment(dump.basis)) {
    return Error{ErrorCode::kBadInput,
                 "--palette: this dump has optical channels (a palette of more than " +
                     std::to_string(most_palette_channels(dump.state.bands)) +
                     " pigments), which do not know their pigments any more"};
  }
  const PaintMaker maker(dump.basis.wavelength_nm, {static_cast<double>(dump.model.saunderson_k1),
                                                    static_cast<double>(dump.model.saunderson_k2)});
  for (const PigmentExchange& exchange : exchanges) {
    const Eigen::Index i = find_pigment(dump.palette, exchange.pigment);
    if (i < 0) return unknown_pigment(dump.palette, exchange.pigment);
    const Result<Pigment> paint = make_pigment(exchange.paint, maker);
    if (!paint) return paint.error();
    Pigment& old = dump.palette[static_cast<std::size_t>(i)];
    if (paint->K.size() != dump.basis.K.rows()) {
      return Error{ErrorCode::kBadInput,
                   fmt::format("--palette: the dump has {} bands, its optics {}",
                               dump.basis.K.rows(), paint->K.size())};
    }
    old.K = dump.basis.K.col(i) = paint->K;
    old.S = dump.basis.S.col(i) = paint->S;
  }
  return {};
}

}  // namespace pentimento
