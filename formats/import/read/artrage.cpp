// ArtRage's scripts: UTF-16LE text of commands and strokes. Places in canvas pixels, y down.
// Source: scripts and comments of github.com/captainflasmr/arscript-mode; the format itself is not
// published. Kept: places, times, pressure, size of the canvas, clearing, undo, drying, eraser and
// inverted pen. Guessed: tilt (Ti 1 is upright, 0 flat), its direction (Ro, clockwise from the
// right), the order of colours (alpha, red, green, blue), sizes (percents of the canvas), brushes
// by the names of presets. Dropped: layers, whose order the script does not tell; other properties.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/optics/srgb.h"
#include "formats/import/read/readers.h"
#include "formats/import/sketch/pen_angles.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr std::string_view kMark = "\xFF\xFE";
constexpr std::string_view kTitle = "ArtRage Script File";
constexpr double kMost_px = 1e7;
constexpr double kMost_s = 1e9;

/// Characters beyond ASCII, which only stand in names and pictures, become '?'.
std::string ascii_of(std::string_view utf16) {
  std::string out;
  out.reserve(utf16.size() / 2);
  for (std::size_t i = 0; i + 1 < utf16.size(); i += 2) {
    const auto low = static_cast<unsigned char>(utf16[i]);
    out += utf16[i + 1] == 0 && low != 0 && low < 128 ? static_cast<char>(low) : '?';
  }
  return out;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

/// What follows "key:" in a line; nothing, if the key is not there.
std::optional<std::string_view> after(std::string_view line, std::string_view key) {
  for (std::size_t at = line.find(key); at != line.npos; at = line.find(key, at + 1)) {
    const bool begins =
        at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t' || line[at - 1] == '>';
    const std::string_view rest = line.substr(at + key.size());
    if (begins && rest.starts_with(':')) return trimmed(rest.substr(1));
  }
  return {};
}

/// The number at the beginning of a text, whatever follows it.
std::optional<double> leading_number(std::string_view text) {
  const std::size_t end = text.find_first_not_of("0123456789+-.eE");
  return number_of(text.substr(0, end));
}

class ArtRageReader {
 public:
  explicit ArtRageReader(const Source& source)
      : source_(source),
        text_(ascii_of(
            source.bytes.substr(std::min<std::size_t>(kMark.size(), source.bytes.size())))) {}

  Result<Sketch> read() {
    std::string_view rest = text_;
    for (line_ = 1; !rest.empty(); ++line_) {
      read_line(trimmed(next_line(rest)));
      if (!problem_.empty())
        return Error{ErrorCode::kBadInput, fmt::format("{}:{}: {}", source_.name, line_, problem_)};
    }
    end_stroke();
    finish();
    return std::move(sketch_);
  }

 private:
  void fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
  }

  void read_line(std::string_view line) {
    if (line.empty() || line.starts_with("//")) return;
    if (line == "{" || line == "}") {
      in_block_ = line == "{";
      return;
    }
    if (line.starts_with('<')) in_block_ = false;
    if (in_block_ || skips(line)) return;
    if (line.starts_with("<StrokeEvent>") || line.starts_with("</StrokeEvent>")) {
      end_stroke();
      in_stroke_ = line[1] == 'S';
    } else if (const auto place = after(line, "Loc"); place && in_stroke_) {
      read_point(line, *place);
    } else if (const auto command = after(line, "CommandID")) {
      wait(line);
      read_command(*command, line);
    } else if (after(line, "Wait")) {
      wait(line);
    } else {
      read_size(line);
    }
  }

  /// The brush's memory before the stroke, on the line of its tag or up to the closing one.
  bool skips(std::string_view line) {
    if (!skipped_tag_.empty()) {
      if (line.starts_with(skipped_tag_) || line.starts_with("</StrokeEvent>")) skipped_tag_ = {};
      return !line.starts_with("</StrokeEvent>");
    }
    for (const std::string_view tag :
         {"</Smooth>", "</PrevA>", "</PrevB>", "</OldHd>", "</NewHd>"}) {
      const std::string_view name = tag.substr(2);
      if (!line.starts_with('<') || !line.substr(1).starts_with(name)) continue;
      if (line.size() == name.size() + 1) skipped_tag_ = tag;
      return true;
    }
    return false;
  }

  void read_size(std::string_view line) {
    for (const auto& [key, side] :
         {std::pair{"Painting Width", &Page::width}, std::pair{"Painting Height", &Page::height}}) {
      const auto value = after(line, key);
      if (!value) continue;
      const double pixels = leading_number(*value).value_or(0);
      if (!(pixels >= 1 && pixels <= kMost_px))
        return fail(fmt::format("{} is outside 1..{}", key, kMost_px));
      page_.*side = pixels;
    }
  }

  double field(std::string_view line, std::string_view key, double otherwise, double most) {
    const auto value = after(line, key);
    if (!value) return otherwise;
    const auto number = leading_number(*value);
    if (number && *number >= -most && *number <= most) return *number;
    fail(fmt::format("{} is no number within +-{}", key, most));
    return otherwise;
  }

  void wait(std::string_view line) {
    // "1.2s": the unit ends the number.
    const double seconds = field(line, "Wait", 0, kMost_s);
    if (seconds < 0) fail(fmt::format("Wait {} s is negative", seconds));
    time_s_ += seconds;
    if (time_s_ > kMost_s) fail(fmt::format("the time is over {} s", kMost_s));
  }

  void read_point(std::string_view line, std::string_view place) {
    wait(line);
    const std::size_t comma = std::min(place.find(','), place.size());
    const std::size_t end = std::min(place.find(')'), place.size());
    if (!place.starts_with('(') || comma >= end) return fail("Loc is not (x, y)");
    const auto x = number_of(trimmed(place.substr(1, comma - 1)));
    const auto y = number_of(trimmed(place.substr(comma + 1, end - comma - 1)));
    if (!x || !y || std::abs(*x) > kMost_px || std::abs(*y) > kMost_px)
      return fail(fmt::format("Loc is no place within +-{}", kMost_px));
    Sample s{.x = *x, .y = *y, .time_s = time_s_};
    const double pressure = field(line, "Pr", 1, 1e6);
    if (!(pressure >= 0 && pressure <= 1))
      return fail(fmt::format("pressure {} is outside 0..1", pressure));
    s.pressure = static_cast<float>(pressure);
    const double upright = std::clamp(field(line, "Ti", 1, 1e6), 0.0, 1.0);
    std::tie(s.tilt_x_deg, s.tilt_y_deg) =
        tilts_deg(upright * std::numbers::pi / 2, field(line, "Ro", 0, 1e6));
    stroke_.has_pressure |= after(line, "Pr").has_value();
    stroke_.has_tilt |= upright < 1;
    if (const auto inverted = after(line, "Iv"); inverted && inverted->starts_with("YES"))
      stroke_.erases = true;
    stroke_.samples.push_back(s);
  }

  void end_stroke() {
    if (stroke_.samples.empty()) return;
    stroke_.timed = true;
    stroke_.color = color_;
    stroke_.opacity = opacity_;
    stroke_.brush = brush_;
    stroke_.erases |= eraser_;
    stroke_.width = size_;  // percents until the canvas is known
    sketch_.items.push_back(std::move(stroke_));
    stroke_ = {};
    if (dries_) sketch_.items.push_back(SketchAction::kDry);
  }

  void read_command(std::string_view command, std::string_view line) {
    const auto is = [&](std::string_view name) {
      return command.find(name) != std::string_view::npos;
    };
    end_stroke();
    if (is("SetForeColour")) {
      read_color(line);
    } else if (is("SetToolProperty")) {
      read_property(line);
    } else if (is("ToolPreset")) {
      read_preset(line);
    } else if (is("SetClearCanvas")) {
      sketch_.items.push_back(SketchAction::kClear);
    } else if (is("Undo")) {
      sketch_.items.push_back(SketchAction::kUndo);
    } else if (is("Redo")) {
      sketch_.items.push_back(SketchAction::kRedo);
    } else {
      ++(is("Layer") ? layers_ : others_);
    }
  }

  /// `{ 0x0AARRGGBB }`
  void read_color(std::string_view line) {
    const std::size_t at = line.find("0x");
    std::uint64_t argb = 0;
    if (at == std::string_view::npos ||
        std::from_chars(line.data() + at + 2, line.data() + line.size(), argb, 16).ec !=
            std::errc() ||
        argb > 0xFFFFFFFF)
      return fail("the colour is not 0x0AARRGGBB");
    for (std::size_t i = 0; i < 3; ++i) color_[i] = kSrgb8ToLinear[argb >> (16 - 8 * i) & 255];
    opacity_ = static_cast<double>(argb >> 24) / 255;
  }

  /// `{ 0x0B2D05E64 (Size), 1.35 }`
  void read_property(std::string_view line) {
    const std::size_t name = line.find('('), end = line.find(')');
    if (name == line.npos || end == line.npos || end < name) return;
    const std::string_view rest = line.substr(end + 1);
    const std::size_t value_at = rest.find_first_not_of(", \t");
    const auto value =
        leading_number(value_at == rest.npos ? std::string_view() : rest.substr(value_at));
    const std::string_view property = line.substr(name + 1, end - name - 1);
    if (property == "Size") {
      if (!value || !(*value >= 0 && *value <= 1e6)) return fail("Size is outside 0..1000000");
      size_ = *value;
    } else if (property == "Insta-Dry") {
      dries_ = value && *value != 0;
    } else {
      ++others_;
    }
  }

  void read_preset(std::string_view line) {
    const auto has = [&](std::string_view name) { return line.find(name) != line.npos; };
    eraser_ = has("Eraser");
    brush_ = has("Oil") || has("Paint") || has("Gloop") ? BrushKind::kBristle
             : has("Knife") || has("Roller")            ? BrushKind::kFlat
                                                        : BrushKind::kRound;
  }

  void finish() {
    if (page_.width > 0 && page_.height > 0) sketch_.page = page_;
    const double percent_px = std::max(page_.width, page_.height) / 100;
    for (Item& item : sketch_.items)
      if (auto* stroke = std::get_if<Stroke>(&item)) stroke->width *= percent_px;
    sketch_.report.kept = {"places", "times", "pressure", "eraser", "clearing", "undo", "drying"};
    sketch_.report.guessed = {"tilt", "order of colours", "sizes as percents of the canvas",
                              "brushes by name"};
    const auto drop = [&](int count, std::string_view what) {
      if (count > 0) sketch_.report.dropped.push_back(fmt::format("{} {}", count, what));
    };
    drop(layers_, "commands for layers");
    drop(others_, "other commands and properties");
  }

  const Source& source_;
  std::string text_;
  Sketch sketch_;
  Page page_;
  Stroke stroke_;
  log::Rgb color_ = {0, 0, 0};
  double opacity_ = 1, size_ = 0, time_s_ = 0;
  BrushKind brush_ = BrushKind::kBristle;  // what a new painting begins with: the oil brush
  bool eraser_ = false, dries_ = false, in_stroke_ = false, in_block_ = false;
  std::string_view skipped_tag_;
  std::string problem_;
  int line_ = 0, layers_ = 0, others_ = 0;
};
}  // namespace

bool is_artrage(std::string_view bytes) {
  constexpr std::size_t kHead = 512;
  if (!bytes.starts_with(kMark)) return false;
  return ascii_of(bytes.substr(kMark.size(), kHead)).find(kTitle) != std::string::npos;
}

Result<Sketch> read_artrage(const Source& source, const ReadOptions&) {
  return ArtRageReader(source).read();
}

}  // namespace pentimento::sketch
