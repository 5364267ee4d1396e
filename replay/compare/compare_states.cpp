#include <fmt/format.h>

#include <algorithm>

#include "formats/log/tables/model_fields.h"
#include "replay/compare/compare.h"
#include "replay/compare/plane_difference.h"

namespace pentimento {

namespace {

/// Compares planes by name, the peak being the largest value of the first.
class States {
 public:
  explicit States(Comparison& out) : out_(out) {}
  void add(const std::string& name, const Field<float>& a, const Field<float>& b) {
    out_.planes.push_back(plane_difference(name, a.view(), b.view(), largest_value(a.view())));
  }
  void add(const std::string& name, const Field<std::uint32_t>& a, const Field<std::uint32_t>& b) {
    double peak = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) peak = std::max(peak, static_cast<double>(a(x, y)));
    out_.planes.push_back(plane_difference(name, a.view(), b.view(), peak));
  }

 private:
  Comparison& out_;
};

/// Whether the planes mean the same, whatever their size.
bool same_paint(const CanvasSource& a, const CanvasSource& b) {
  return a.layers() == b.layers() && a.channels() == b.channels() && a.bands() == b.bands();
}

std::string shape_text(const CanvasSource& s) {
  return fmt::format("{} x {} cells, {} layers, {} channels, {} bands", s.geometry().width,
                     s.geometry().height, s.layers(), s.channels(), s.bands());
}

void note_model(const Model& a, const Model& b, Comparison& out) {
  for (const log::ModelField& field : log::model_fields()) {
    const std::string left = log::model_value_json(field, a);
    const std::string right = log::model_value_json(field, b);
    if (left != right)
      out.notes.push_back(fmt::format("{}: {} against {}", field.name, left, right));
  }
}

bool same_picture(const std::array<Field<float>, 3>& a, const std::array<Field<float>, 3>& b) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (a[c].width() != b[c].width() || a[c].height() != b[c].height()) return false;
    if (plane_difference("", a[c].view(), b[c].view(), 1).differing > 0) return false;
  }
  return true;
}

bool same_light(const Lighting& a, const Lighting& b) {
  if (!same_picture(a.reflection.rgb, b.reflection.rgb)) return false;
  if (!same_picture(a.probe, b.probe)) return false;
  return a.lamps == b.lamps && a.varnish == b.varnish && a.occlusion == b.occlusion &&
         a.white_xy == b.white_xy && a.tone == b.tone && a.environment.L == b.environment.L &&
         a.reflection.fov_deg == b.reflection.fov_deg &&
         a.reflection.mirror == b.reflection.mirror && a.roughness_wet == b.roughness_wet &&
         a.roughness_dry == b.roughness_dry && a.refractive_index == b.refractive_index &&
         a.relief_scale == b.relief_scale && a.exposure_ev == b.exposure_ev;
}

bool same_palette(const std::vector<Pigment>& a, const std::vector<Pigment>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Pigment& x, const Pigment& y) {
    return x.name == y.name && x.K.size() == y.K.size() && x.K == y.K && x.S == y.S;
  });
}

void note_rest(const StateDump& a, const StateDump& b, Comparison& out) {
  if (a.state.step != b.state.step)
    out.notes.push_back(fmt::format("step: {} against {}", a.state.step, b.state.step));
  const CanvasGeometry& g = a.state.geometry;
  const CanvasGeometry& h = b.state.geometry;
  if (g.width_m != h.width_m || g.height_m != h.height_m)
    out.notes.push_back(fmt::format("canvas: {} x {} m against {} x {} m", g.width_m, g.height_m,
                                    h.width_m, h.height_m));
  note_model(a.model, b.model, out);
  if (!same_palette(a.palette, b.palette)) out.notes.push_back("the palettes differ");
  if (!same_light(a.lighting, b.lighting)) out.notes.push_back("the lighting differs");
}

void compare_planes(const CanvasState& s, const CanvasState& t, Comparison& out) {
  States states(out);
  states.add("/fluid/depth", s.depth_m, t.depth_m);
  states.add("/fluid/velocity_x", s.velocity_x_m_s, t.velocity_x_m_s);
  states.add("/fluid/velocity_y", s.velocity_y_m_s, t.velocity_y_m_s);
  states.add("/canvas/base", s.base_m, t.base_m);
  states.add("/canvas/paper", paper_relief_of(s), paper_relief_of(t));
  for (std::size_t i = 0; i < s.reflectance.size(); ++i)
    states.add(fmt::format("/canvas/reflectance[{}]", i), s.reflectance[i].values(),
               t.reflectance[i].values());
  for (int layer = 0; layer < s.layers; ++layer)
    for (int c = 0; c < s.channels; ++c)
      states.add(fmt::format("/layers/pigment[{},{}]", layer, c), s.channel(layer, c),
                 t.channel(layer, c));
  states.add("/layers/stroke", s.stroke, t.stroke);
}

}  // namespace

Result<Comparison> compare_states(const StateDump& a, const StateDump& b, const Threads& threads) {
  Comparison out;
  out.kind = "state";
  note_rest(a, b, out);
  const StateSource left(a.state), right(b.state);
  const CanvasSource& s = a.fine ? *a.fine : left;
  const CanvasSource& t = b.fine ? *b.fine : right;
  const int up = whole_ratio(s.geometry(), t.geometry());
  const int down = whole_ratio(t.geometry(), s.geometry());
  if (!same_paint(s, t) || (up == 0 && down == 0)) {
    out.notes.push_back(shape_text(s) + " against " + shape_text(t));
    out.comparable = false;
    return out;
  }
  if (up == 1 && !a.fine && !b.fine) {
    compare_planes(a.state, b.state, out);
    return out;
  }
  out.reduced = std::max(up, down);
  out.notes.push_back(fmt::format("the detail canvas was reduced {} times", out.reduced));
  if (up > 0) {
    compare_reduced(s, t, a.basis, threads, out);
  } else {
    compare_reduced(t, s, b.basis, threads, out);
  }
  for (const CanvasSource* canvas : {&s, &t})
    if (Result<void> read = canvas->status(); !read) return read.error();
  if (a.guide_sha256 != b.guide_sha256) out.notes.push_back("the guides differ");
  return out;
}

}  // namespace pentimento
