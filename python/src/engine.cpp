// The Python module `pentimento._engine`: an easel, and the catalogues of what a log may name.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "formats/hdf5/state_dump.h"
#include "formats/log/json/json_line.h"
#include "formats/log/json/nearest_name.h"
#include "formats/log/parse/header_parser.h"
#include "formats/log/tables/slider_fields.h"
#include "replay/commands/catalogue.h"
#include "replay/commands/easel.h"
#include "replay/job/build_info.h"

namespace py = pybind11;

namespace pentimento {
namespace {

[[noreturn]] void fail(const Error& error) {
  if (error.code == ErrorCode::kIo) {
    PyErr_SetString(PyExc_OSError, error.message.c_str());
    throw py::error_already_set();
  }
  throw py::value_error(error.message);
}

log::Header header_of(const std::string& json) {
  constexpr int kMostDepth = 16;
  std::string padded = json;
  padded.append(log::JsonLine::kPadding, '\0');
  log::JsonLine line;
  log::Header header;
  std::string problem = line.parse(std::string_view(padded).substr(0, json.size()), kMostDepth);
  if (problem.empty()) problem = log::parse_header(line, header);
  if (!problem.empty()) throw py::value_error(problem);
  return header;
}

/// A view of a plane: no copy, read-only, alive as long as the canvas that owns it.
template <typename T>
py::array view_of(const Field<T>& plane, const py::object& owner) {
  const FieldView<const T> view = plane.view();
  const auto row = static_cast<py::ssize_t>(reinterpret_cast<const char*>(view.row(1)) -
                                            reinterpret_cast<const char*>(view.row(0)));
  py::array array(py::dtype::of<T>(), {plane.height(), plane.width()},
                  {plane.height() > 1 ? row : static_cast<py::ssize_t>(sizeof(T)) * plane.width(),
                   static_cast<py::ssize_t>(sizeof(T))},
                  view.row(0), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// All canvases of the process draw the tip of a brush once.
const std::shared_ptr<TipRack>& shared_tips() {
  static const auto tips = std::make_shared<TipRack>();
  return tips;
}

class EaselHandle {
 public:
  EaselHandle(const std::string& header_json, int threads) {
    Result<std::unique_ptr<Easel>> opened =
        Easel::open(header_of(header_json), threads, shared_tips());
    if (!opened) fail(opened.error());
    easel_ = std::move(*opened);
  }
  explicit EaselHandle(std::unique_ptr<Easel> easel) : easel_(std::move(easel)) {}

  void brush(const std::string& name, const std::map<std::string, double>& sliders) {
    BrushSettings settings = settings_;
    for (const auto& [slider, value] : sliders) {
      const log::Parameter* parameter = log::find_slider(slider);
      const std::string problem = parameter ? log::value_problem(*parameter, value)
                                            : "there is no slider \"" + slider + "\"" +
                                                  did_you_mean(slider, log::slider_names());
      if (!problem.empty()) throw py::value_error(problem);
      Model unused;
      log::apply_slider(slider, value, settings, unused);
    }
    settings_ = settings;
    easel_->take_brush(name, settings_);
    check();
  }
  void color(const std::string& pigment) {
    easel_->take_color(pigment);
    check();
  }
  void stroke(const std::vector<std::array<double, 3>>& points, double speed_m_s) {
    if (!(speed_m_s > 0)) throw py::value_error("speed_m_s must be more than 0");
    std::vector<StrokePoint> path;
    for (const auto& [x_m, y_m, pressure] : points) {
      if (!(pressure >= 0 && pressure <= 1)) throw py::value_error("a pressure is outside 0..1");
      path.push_back({x_m, y_m, static_cast<float>(pressure)});
    }
    py::gil_scoped_release others;
    easel_->stroke(path, speed_m_s);
  }
  void wait(double seconds) {
    if (!(seconds >= 0)) throw py::value_error("seconds must not be negative");
    py::gil_scoped_release others;
    easel_->wait(seconds);
  }
  void step(int steps) {
    if (steps < 0) throw py::value_error("steps must not be negative");
    py::gil_scoped_release others;
    easel_->step(steps);
  }
  void dry() {
    easel_->dry();
    if (under_paint_) show(*under_paint_);
  }
  void gravity(double x, double y, double z) { easel_->set_gravity(x, y, z); }
  std::unique_ptr<EaselHandle> fork() const {
    auto twin = std::make_unique<EaselHandle>(easel_->fork());
    twin->settings_ = settings_;
    return twin;
  }
  py::array_t<std::uint8_t> picture(int width) {
    const Result<EaselPicture> picture = easel_->picture(width);
    if (!picture) fail(picture.error());
    py::array_t<std::uint8_t> array({picture->height, picture->width, 3});
    std::copy(picture->rgb.begin(), picture->rgb.end(), array.mutable_data());
    return array;
  }
  std::string save(const std::string& path, int width) {
    Result<Published> done = easel_->write_png(path, width);
    if (!done) fail(done.error());
    return done->sha256;
  }
  const CanvasState& state() const { return easel_->simulation().state(); }
  /// What lies under the wet paint. The state keeps only where it differs from fresh paper; here it
  /// is whole, as views need it, from the first call on. It changes when the canvas dries.
  struct UnderPaint {
    Field<float> paper_m;
    std::vector<Field<float>> reflectance;
  };
  const UnderPaint& under_paint() {
    if (!under_paint_) {
      const CanvasGeometry& grid = state().geometry;
      under_paint_.emplace();
      under_paint_->paper_m = Field<float>(grid.width, grid.height);
      for (int band = 0; band < state().bands; ++band)
        under_paint_->reflectance.emplace_back(grid.width, grid.height);
      show(*under_paint_);
    }
    return *under_paint_;
  }
  std::vector<std::string> channels() const { return easel_->simulation().basis().name; }
  double time_s() const { return easel_->time_s(); }

 private:
  void show(UnderPaint& planes) const {
    for (int y = 0; y < state().geometry.height; ++y) {
      read_paper(state(), 0, y, planes.paper_m.view().row_span(y));
      for (std::size_t band = 0; band < planes.reflectance.size(); ++band)
        state().reflectance[band].read(0, y, planes.reflectance[band].view().row_span(y));
    }
  }
  void check() const {
    if (easel_->problem()) fail(*easel_->problem());
  }
  std::unique_ptr<Easel> easel_;
  BrushSettings settings_;
  std::optional<UnderPaint> under_paint_;
};

/// The planes by their names in a dump; `/layers/pigment` as a list of layers of channels.
py::dict planes_of(const py::object& self) {
  auto& easel = self.cast<EaselHandle&>();
  const CanvasState& state = easel.state();
  const EaselHandle::UnderPaint& under = easel.under_paint();
  py::dict planes;
  planes["depth_m"] = view_of(state.depth_m, self);
  planes["velocity_x_m_s"] = view_of(state.velocity_x_m_s, self);
  planes["velocity_y_down_m_s"] = view_of(state.velocity_y_m_s, self);
  planes["base_m"] = view_of(state.base_m, self);
  planes["paper_m"] = view_of(under.paper_m, self);
  planes["stroke"] = view_of(state.stroke, self);
  py::list reflectance, pigment;
  for (const Field<float>& band : under.reflectance) reflectance.append(view_of(band, self));
  for (int layer = 0; layer < state.layers; ++layer) {
    py::list channels;
    for (int c = 0; c < state.channels; ++c)
      channels.append(view_of(state.channel(layer, c), self));
    pigment.append(channels);
  }
  planes["reflectance"] = reflectance;
  planes["pigment"] = pigment;
  return planes;
}

}  // namespace
}  // namespace pentimento

PYBIND11_MODULE(_engine, module) {
  using namespace pentimento;
  module.doc() = "The simulation and shading of pentimento.";
  module.def("version", &version);
  module.def("catalogue", [](const std::string& kind) {
    const Result<Catalogue> found = catalogue(kind, "");
    if (!found) fail(found.error());
    return catalogue_json(*found);
  });
  py::class_<EaselHandle>(module, "Easel")
      .def(py::init<const std::string&, int>())
      .def("brush", &EaselHandle::brush)
      .def("color", &EaselHandle::color)
      .def("stroke", &EaselHandle::stroke)
      .def("wait", &EaselHandle::wait)
      .def("step", &EaselHandle::step)
      .def("dry", &EaselHandle::dry)
      .def("gravity", &EaselHandle::gravity)
      .def("fork", &EaselHandle::fork)
      .def("picture", &EaselHandle::picture)
      .def("save", &EaselHandle::save)
      .def("planes", [](const py::object& self) { return planes_of(self); })
      .def_property_readonly("channels", &EaselHandle::channels)
      .def_property_readonly("steps", [](const EaselHandle& e) { return e.state().step; })
      .def_property_readonly("time_s", &EaselHandle::time_s)
      .def("state_sha256", [](const EaselHandle& e) { return state_sha256(e.state()); });
}
