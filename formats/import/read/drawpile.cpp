// Drawpile's text recordings: lines of `USER message {json}`. Places in pixels, y down.
// Source: github.com/drawpile/Drawpile, src/drawdance/generators/protogen (protocol.yaml and the
// text writer). Kept: dabs joined to strokes by user, colour, opacity, eraser, layers, size of the
// canvas, undo and redo by user. Guessed: pressure, from the sizes of the dabs; times, as pauses
// below half a second are not stored; other blend modes paint. Dropped: fills, images, chat.

#include <fmt/format.h>
#include <simdjson.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "formats/import/read/css_color.h"
#include "formats/import/read/readers.h"
#include "formats/import/sketch/layers.h"
#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
namespace dom = simdjson::dom;

constexpr std::string_view kMagic = "!version=dp:";
constexpr double kMost_px = 1e7;

struct Layer {
  std::string id;
  double opacity = 1;
};

/// What one user does now. Each has undo of their own.
struct User {
  std::optional<std::size_t> stroke;      // that is being painted
  std::size_t group = 0;                  // since the last undo point; 0 is never undone
  std::vector<std::size_t> done, undone;  // groups
};

/// A stroke and what decides on it in the end.
struct Painted {
  Stroke stroke;
  std::string layer;
  log::Rgb color = {};
  double alpha = 1;
  std::string mode;
  std::size_t group = 0;
};

class DrawpileReader {
 public:
  explicit DrawpileReader(const Source& source) : source_(source) {}

  Result<Sketch> read() {
    std::string_view rest = without_bom(source_.bytes);
    for (line_ = 1; !rest.empty() && problem_.empty(); ++line_) {
      const std::string_view line = next_line(rest);
      if (!line.empty() && line[0] != '!' && line[0] != '#') read_line(line);
      if (!problem_.empty()) break;
    }
    if (!problem_.empty())
      return Error{ErrorCode::kBadInput, fmt::format("{}:{}: {}", source_.name, line_, problem_)};
    finish();
    return std::move(sketch_);
  }

 private:
  void fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
  }

  void read_line(std::string_view line) {
    const std::size_t brace = std::min(line.find('{'), line.size());
    const std::vector<std::string_view> words = words_of(line.substr(0, brace));
    if (words.size() != 2) return fail("a line is: user, message, {members}");
    const auto user = number_of(words[0]);
    if (!user || !(*user >= 0 && *user <= 255) || *user != std::floor(*user))
      return fail("the user is outside 0..255");
    const std::string_view json = brace < line.size() ? line.substr(brace) : "{}";
    dom::element members;
    if (const auto problem = parser_.parse(json.data(), json.size()).get(members))
      return fail(fmt::format("not JSON: {}", simdjson::error_message(problem)));
    read_message(static_cast<int>(*user), words[1], members);
  }

  void read_message(int user_id, std::string_view name, dom::element members) {
    User& user = users_[user_id];
    if (name == "classicdabs" || name == "pixeldabs" || name == "squarepixeldabs" ||
        name == "mypaintdabs") {
      read_dabs(user, name, members);
    } else if (name == "penup") {
      user.stroke.reset();
    } else if (name == "undopoint") {
      user.stroke.reset();
      user.group = ++groups_;
      user.done.push_back(user.group);
      user.undone.clear();
    } else if (name == "undo") {
      read_undo(user_id, members);
    } else if (name == "resize") {
      read_resize(members);
    } else if (name == "layertreecreate" || name == "layercreate") {
      create_layer(text(members, "id"), text(members, "target"));
    } else if (name == "layerattr") {
      layer_of(text(members, "id")).opacity = number(members, "opacity", 255, 0, 255) / 255;
    } else if (name != "interval" && name != "join" && name != "leave") {
      ++others_;
    }
  }

  double number(dom::element in, const char* key, double otherwise, double least, double most) {
    dom::element value;
    if (in[key].get(value) != simdjson::SUCCESS) return otherwise;
    return checked(value, key, least, most);
  }
  double checked(dom::element value, const char* key, double least, double most) {
    double out = 0;
    if (value.get_double().get(out) != simdjson::SUCCESS)
      fail(fmt::format("{} is not a number", key));
    else if (!(out >= least && out <= most))
      fail(fmt::format("{} {} is outside {}..{}", key, out, least, most));
    return problem_.empty() ? out : least;
  }
  /// A member as text, also where it is an integer.
  static std::string text(dom::element in, const char* key) {
    std::string_view out;
    if (in[key].get(out) == simdjson::SUCCESS) return std::string(out);
    std::int64_t number = 0;
    return in[key].get(number) == simdjson::SUCCESS ? std::to_string(number) : "";
  }

  /// Above the target, or above all.
  void create_layer(const std::string& id, const std::string& target) {
    const auto at = std::find_if(layers_.begin(), layers_.end(),
                                 [&](const Layer& layer) { return layer.id == target; });
    layers_.insert(at == layers_.end() ? at : at + 1, Layer{id});
  }
  Layer& layer_of(const std::string& id) {
    const auto at = std::find_if(layers_.begin(), layers_.end(),
                                 [&](const Layer& layer) { return layer.id == id; });
    return at != layers_.end() ? *at : layers_.emplace_back(Layer{id});
  }

  /// The canvas grows by so much on each side; later places count from its new corner.
  void read_resize(dom::element members) {
    const double top = number(members, "top", 0, -kMost_px, kMost_px);
    const double right = number(members, "right", 0, -kMost_px, kMost_px);
    const double bottom = number(members, "bottom", 0, -kMost_px, kMost_px);
    const double left = number(members, "left", 0, -kMost_px, kMost_px);
    page_.x -= left;
    page_.y -= top;
    page_.width += left + right;
    page_.height += top + bottom;
    if (!(page_.width > 0 && page_.width <= kMost_px && page_.height > 0 &&
          page_.height <= kMost_px && std::abs(page_.x) <= kMost_px &&
          std::abs(page_.y) <= kMost_px))
      return fail(fmt::format("a canvas of {} x {} pixels", page_.width, page_.height));
  }

  void read_undo(int user_id, dom::element members) {
    const double other = number(members, "override_user", 0, 0, 255);
    User& user = users_[other > 0 ? static_cast<int>(other) : user_id];
    bool redo = false;
    if (members["redo"].get(redo) != simdjson::SUCCESS) redo = false;
    auto& from = redo ? user.undone : user.done;
    auto& to = redo ? user.done : user.undone;
    user.stroke.reset();
    if (from.empty()) return;
    to.push_back(from.back());
    from.pop_back();
  }

  /// The stroke that the user's dabs belong to: the last one, if it looks alike.
  Painted* stroke_for(User& user, dom::element members) {
    Painted now;
    now.layer = text(members, "layer");
    now.mode = text(members, "mode");
    // An alpha tells that the dabs are merged first and have that opacity together; 0: they do not.
    std::string name = text(members, "color");
    if (name.size() == 9) {
      const auto alpha = css_color(fmt::format("#000000{}", name.substr(1, 2)));
      if (!alpha) return fail("the colour is none"), nullptr;
      if (alpha->opacity > 0) now.alpha = alpha->opacity;
      name = fmt::format("#{}", name.substr(3));
    }
    const auto color = css_color(name);
    if (!color) return fail("the colour is none"), nullptr;
    now.color = color->linear;
    if (user.stroke) {
      Painted& last = painted_[*user.stroke];
      if (last.layer == now.layer && last.mode == now.mode && last.color == now.color &&
          last.alpha == now.alpha)
        return &last;
    }
    now.group = user.group;
    now.stroke.opacity = 0;
    user.stroke = painted_.size();
    return &painted_.emplace_back(std::move(now));
  }

  void read_dabs(User& user, std::string_view name, dom::element members) {
    double x = number(members, "x", 0, -kMost_px, kMost_px);
    double y = number(members, "y", 0, -kMost_px, kMost_px);
    dom::array dabs;
    if (members["_"].get_array().get(dabs) != simdjson::SUCCESS)
      return fail("no array '_' of dabs");
    Painted* painted = stroke_for(user, members);
    if (painted == nullptr) return;
    if (layer_known_.insert(painted->layer).second) layer_of(painted->layer);
    // Pixel brushes have no hardness.
    const std::size_t opacity_at = name.ends_with("pixeldabs") ? 3 : 4;
    for (const dom::element dab : dabs) {
      x += value(dab, "x", 0, -kMost_px);
      y += value(dab, "y", 1, -kMost_px);
      const double size = value(dab, "size", 2, 0);
      const double opacity = std::min(value(dab, "opacity", opacity_at, 0), 255.0) / 255;
      if (!(std::abs(x) <= kMost_px && std::abs(y) <= kMost_px))
        fail(fmt::format("a dab at {}, {}", x, y));
      if (!problem_.empty()) return;
      // The dab's size waits in the place of the pressure until the greatest is known.
      painted->stroke.samples.push_back(
          {.x = x + page_.x, .y = y + page_.y, .pressure = static_cast<float>(size)});
      painted->stroke.width = std::max(painted->stroke.width, size);
      painted->stroke.opacity = std::max(painted->stroke.opacity, opacity);
    }
  }

  /// A dab is an object, or an array in the order of its fields.
  double value(dom::element dab, const char* key, std::size_t at, double least) {
    dom::array fields;
    dom::element found;
    const bool there = dab.get_array().get(fields) == simdjson::SUCCESS
                           ? fields.at(at).get(found) == simdjson::SUCCESS
                           : dab[key].get(found) == simdjson::SUCCESS;
    if (!there) return fail(fmt::format("a dab has no {}", key)), 0;
    return checked(found, key, least, kMost_px);
  }

  void finish() {
    std::vector<bool> undone(groups_ + 1, false);
    for (const auto& [id, user] : users_)
      for (const std::size_t group : user.undone) undone[group] = true;
    std::map<std::string, std::pair<int, double>> layers;
    for (const Layer& layer : layers_)
      layers.emplace(layer.id, std::pair(static_cast<int>(layers.size()), layer.opacity));
    int taken_back = 0, unseen = 0;
    for (Painted& p : painted_) {
      const auto& [layer, layer_opacity] = layers[p.layer];
      p.stroke.opacity *= p.alpha * layer_opacity;
      if (p.stroke.samples.empty()) continue;
      if (undone[p.group]) {
        ++taken_back;
      } else if (p.stroke.opacity == 0 || p.stroke.width == 0) {
        ++unseen;
      } else {
        p.stroke.layer = layer;
        p.stroke.color = p.color;
        p.stroke.erases = p.mode == "0" || p.mode == "svg:dst-out";
        for (Sample& s : p.stroke.samples) {
          s.pressure = std::min(1.0f, s.pressure / static_cast<float>(p.stroke.width));
          p.stroke.has_pressure |= s.pressure < 1;
        }
        sketch_.items.push_back(std::move(p.stroke));
      }
    }
    if (page_.width > 0) sketch_.page = page_;
    sketch_.report.kept = {"places", "colour", "opacity", "eraser", "undo by user"};
    if (paint_layer_by_layer(sketch_) > 1)
      sketch_.report.kept.emplace_back("layers, each dry before the next");
    sketch_.report.guessed = {"pressure from the sizes of dabs", "times"};
    const auto drop = [&](int count, std::string_view what) {
      if (count > 0) sketch_.report.dropped.push_back(fmt::format("{} {}", count, what));
    };
    drop(taken_back, "undone strokes");
    drop(unseen, "strokes that are not seen");
    drop(others_, "messages that are no strokes");
  }

  const Source& source_;
  dom::parser parser_;
  Sketch sketch_;
  Page page_;
  std::map<int, User> users_;
  std::vector<Painted> painted_;
  std::vector<Layer> layers_;
  std::set<std::string> layer_known_;
  std::string problem_;
  std::size_t groups_ = 0;
  int line_ = 0, others_ = 0;
};
}  // namespace

bool is_drawpile(std::string_view bytes) {
  // Comments may come first.
  std::string_view rest = without_bom(bytes);
  while (rest.starts_with('#')) next_line(rest);
  return rest.starts_with(kMagic);
}

Result<Sketch> read_drawpile(const Source& source, const ReadOptions&) {
  return DrawpileReader(source).read();
}

}  // namespace pentimento::sketch
