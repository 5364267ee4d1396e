#include "formats/hdf5/read_dump.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "formats/hdf5/detail_checkpoint.h"
#include "formats/hdf5/dump_source.h"
#include "formats/hdf5/handle.h"
#include "formats/hdf5/layout.h"
#include "formats/hdf5/lighting_parts.h"
#include "formats/hdf5/objects.h"
#include "formats/hdf5/read_small.h"
#include "formats/hdf5/sleep.h"
#include "formats/io/utf8.h"
#include "formats/log/tables/model_fields.h"
#include "formats/log/tables/ranges.h"

namespace pentimento {

namespace {

using hdf5::Handle;

constexpr std::size_t kMostNames = 65536;
constexpr std::int64_t kMostDetail = 32;
constexpr std::size_t kCacheBytes = std::size_t{256} << 20;
// The detail canvas is never held whole.
constexpr hdf5::ShapeLimits kFineLimits = {1 << 20, std::uint64_t{1} << 38, std::uint64_t{1} << 44};

// Beyond these, numbers of a run or of a picture are not finite in single precision.
constexpr log::Range kStepRange = {0, log::kMaxExactInteger};
constexpr log::Range kTimeRange = {0, log::kMaxExactInteger, "s"};
constexpr log::Range kCoefficientRange = {0, 1e9};
constexpr log::Range kLightRange = {-1e12, 1e12};
// Microfacets of roughness 0 reflect nothing but the mirror's ray.
constexpr log::Range kRoughnessRange = {1e-3, 1};
constexpr log::Range kIndexRange = {1, 10};
constexpr log::Range kReliefScaleRange = {0, 1e3};

// A camera's picture is one that read_image() would read; a probe is made no larger.
constexpr hdf5::LightPicture kReflection = {"/lighting/reflection", 65536, 65536, 1 << 27};
constexpr hdf5::LightPicture kProbe = {"/lighting/probe", 256, 512, 256 * 512};

/// All values of a detail canvas.
std::uint64_t fine_bytes(const hdf5::CanvasShape& shape) {
  std::uint64_t bytes = 0;
  for (const hdf5::CanvasDataset& dataset : hdf5::kCanvasDatasets) {
    std::uint64_t values = sizeof(float);
    for (const std::uint64_t n : hdf5::shape_of(shape, dataset)) values *= n;
    bytes += values;
  }
  return bytes;
}

/// Reads a dump; the first thing that is wrong ends it.
class StateReader {
 public:
  explicit StateReader(const hdf5::DumpFile& from)
      : from_(from),
        path_(from.path),
        file_(from.file),
        root_(H5Gopen2(from.file, "/", H5P_DEFAULT), H5Gclose) {}

  Result<StateDump> read();
  /// Checks that the detail canvas has the hash that the dump names.
  Result<void> check_fine(const StateDump& dump) const;

 private:
  /// `what` may quote the dump.
  Error bad(const std::string& what) const {
    constexpr std::size_t kMostBytes = 300;  // a line that can still be read
    return {ErrorCode::kBadInput, path_ + ": " + brief_line(valid_utf8(what), kMostBytes)};
  }
  Error missing(const std::string& what) const { return bad(what + " is missing or malformed"); }
  /// Of a dataset that was not got: why.
  Error no_dataset(const std::string& name) const;
  Error outside(const std::string& name, double value, const log::Range& range) const;
  /// The values of a dataset of this shape, all in the range.
  Result<std::vector<double>> numbers(const std::string& name,
                                      const std::vector<std::uint64_t>& shape,
                                      const log::Range& range) const;
  Result<std::vector<std::string>> names(const std::string& name) const;
  Result<void> check_format() const;
  Result<void> read_root(StateDump& dump) const;
  Result<void> read_model(Model& model) const;
  Result<void> read_basis(StateDump& dump) const;
  Result<void> read_palette(StateDump& dump) const;
  Result<void> read_wavelengths(const std::vector<double>& wavelength_m, StateDump& dump) const;
  Result<void> read_lighting(Lighting& light) const;
  Result<void> read_lamp(Lamp& lamp, hid_t group) const;
  Result<void> read_guide(StateDump& dump, const hdf5::CanvasGroup& from) const;
  Result<void> open_fine(StateDump& dump) const;

  const hdf5::DumpFile& from_;
  const std::string& path_;
  hid_t file_;
  Handle root_;
};

Error StateReader::no_dataset(const std::string& name) const {
  const std::string problem = hdf5::dataset_problem(file_, name);
  return problem.empty() ? missing(name) : bad(problem);
}

Error StateReader::outside(const std::string& name, double value, const log::Range& range) const {
  if (!std::isfinite(value)) return bad(name + " has a value that is not finite");
  return bad(fmt::format("{} has the value {}, outside {}..{}", name, value, range.min, range.max));
}

Result<std::vector<double>> StateReader::numbers(const std::string& name,
                                                 const std::vector<std::uint64_t>& shape,
                                                 const log::Range& range) const {
  auto values = hdf5::read_doubles(file_, name, shape);
  if (!values) return no_dataset(name);
  for (const double value : *values)
    if (!(value >= range.min && value <= range.max)) return outside(name, value, range);
  return std::move(*values);
}

/// No two are alike.
Result<std::vector<std::string>> StateReader::names(const std::string& name) const {
  auto names = hdf5::read_strings(file_, name, kMostNames);
  if (!names) return no_dataset(name);
  std::vector<std::string> sorted = *names;
  std::sort(sorted.begin(), sorted.end());
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  if (twin != sorted.end()) return bad(fmt::format("{} has \"{}\" twice", name, *twin));
  return std::move(*names);
}

Result<void> StateReader::check_format() const {
  if (const std::string problem = hdf5::format_problem(root_.id()); !problem.empty())
    return bad(problem);
  const std::optional<std::int64_t> version = hdf5::whole_attribute(root_.id(), "format_version");
  if (!version || *version < 1) return missing("format_version");
  if (*version > kStateVersion)
    return bad(
        fmt::format("format version {} is newer than the {} known here", *version, kStateVersion));
  return {};
}

Result<void> StateReader::read_root(StateDump& dump) const {
  const auto width = hdf5::number_attribute(root_.id(), "canvas_width_m");
  const auto height = hdf5::number_attribute(root_.id(), "canvas_height_m");
  const auto step = hdf5::whole_attribute(root_.id(), "step");
  const auto time = hdf5::number_attribute(root_.id(), "time_s");
  const auto rate = hdf5::number_attribute(root_.id(), "steps_per_second");
  const auto hash = hdf5::text_attribute(root_.id(), "state_sha256");
  const auto guide = hdf5::text_attribute(root_.id(), "guide_sha256");
  const std::pair<const char*, std::pair<std::optional<double>, log::Range>> numbers[] = {
      {"canvas_width_m", {width, log::kCanvasRange}},
      {"canvas_height_m", {height, log::kCanvasRange}},
      {"step", {step, kStepRange}},
      {"time_s", {time, kTimeRange}},
      {"steps_per_second", {rate, log::kStepsPerSecondRange}}};
  for (const auto& [name, number] : numbers) {
    const auto& [value, range] = number;
    if (!value) return missing(name);
    if (!(*value >= range.min && *value <= range.max)) return outside(name, *value, range);
  }
  if (!hash) return missing("state_sha256");
  if (!guide && dump.detail > 1) return missing("guide_sha256");
  dump.state.geometry.width_m = *width;
  dump.state.geometry.height_m = *height;
  dump.state.step = *step;
  dump.time_s = *time;
  dump.steps_per_second = *rate;
  dump.state_sha256 = *hash;
  dump.guide_sha256 = dump.detail > 1 ? *guide : *hash;
  const auto log_hash = hdf5::text_attribute(root_.id(), "log_sha256");
  if (!log_hash && hdf5::has_attribute(root_.id(), "log_sha256")) return missing("log_sha256");
  dump.log_sha256 = log_hash.value_or("");
  return {};
}

/// A parameter that the dump does not have is newer than the dump, and keeps its default.
Result<void> StateReader::read_model(Model& model) const {
  for (const log::ModelField& field : log::model_fields()) {
    const std::string name(field.name);
    std::optional<double> value = hdf5::number_attribute(root_.id(), name);
    if (const auto text = hdf5::text_attribute(root_.id(), name)) {
      const auto choice = std::find(field.choices.begin(), field.choices.end(), *text);
      if (choice == field.choices.end()) return bad(fmt::format("{} is \"{}\"", name, *text));
      value = static_cast<double>(choice - field.choices.begin());
    }
    if (!value && hdf5::has_attribute(root_.id(), name)) return missing(name);
    if (!value) continue;
    const std::string problem = log::value_problem(field, *value);
    if (!problem.empty()) return bad(problem);
    log::set_model_value(field, model, *value);
  }
  const std::string problem = log::model_problem(model);
  if (!problem.empty()) return bad(problem);
  return {};
}

Result<void> StateReader::read_basis(StateDump& dump) const {
  const auto names = this->names("/layers/channel");
  if (!names) return names.error();
  const auto channels = static_cast<std::uint64_t>(dump.state.channels);
  const auto bands = static_cast<std::uint64_t>(dump.state.bands);
  if (names->size() != channels) return missing("/layers/channel");
  const auto K = numbers("/layers/K", {bands, channels}, kCoefficientRange);
  if (!K) return K.error();
  const auto S = numbers("/layers/S", {bands, channels}, kCoefficientRange);
  if (!S) return S.error();
  const auto amount = numbers("/layers/amount", {channels}, kCoefficientRange);
  if (!amount) return amount.error();
  const auto load = numbers("/layers/load", {channels, dump.palette.size()}, kCoefficientRange);
  if (!load) return load.error();
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto matrix = [](const std::vector<double>& values, std::uint64_t rows,
                         std::uint64_t columns) {
    return Eigen::Map<const RowMajor>(values.data(), static_cast<Eigen::Index>(rows),
                                      static_cast<Eigen::Index>(columns));
  };
  dump.basis.name = *names;
  dump.basis.K = matrix(*K, bands, channels);
  dump.basis.S = matrix(*S, bands, channels);
  dump.basis.amount = matrix(*amount, channels, 1).cast<float>();
  dump.basis.load = matrix(*load, channels, dump.palette.size()).cast<float>();
  return {};
}

/// If the bands are red, green and blue, no wavelength is positive.
Result<void> StateReader::read_wavelengths(const std::vector<double>& wavelength_m,
                                           StateDump& dump) const {
  constexpr double kDigits = 1e6;  // of a nm: the way to metres and back rounds
  const bool spectral = dump.model.optics == OpticsKind::kSpectral;
  const int bands = spectral ? dump.model.bands : 3;
  if (dump.state.bands != bands)
    return bad(
        fmt::format("/canvas/reflectance has {} bands, the model {}", dump.state.bands, bands));
  if (!spectral) return {};
  double before_nm = 0;
  for (const double m : wavelength_m) {
    const double nm = std::round(m * 1e9 * kDigits) / kDigits;
    if (!(nm > before_nm && nm <= log::kWavelengthRange.max))
      return bad(fmt::format("/palette/wavelength {} m does not rise from band to band", m));
    dump.basis.wavelength_nm.push_back(before_nm = nm);
  }
  return {};
}

Result<void> StateReader::read_palette(StateDump& dump) const {
  const auto names = this->names("/palette/name");
  if (!names) return names.error();
  const auto bands = static_cast<std::uint64_t>(dump.state.bands);
  const auto K = numbers("/palette/K", {names->size(), bands}, kCoefficientRange);
  if (!K) return K.error();
  const auto S = numbers("/palette/S", {names->size(), bands}, kCoefficientRange);
  if (!S) return S.error();
  const auto wavelength = hdf5::read_doubles(file_, "/palette/wavelength", {bands});
  if (!wavelength) return no_dataset("/palette/wavelength");
  const auto n = static_cast<Eigen::Index>(bands);
  for (std::size_t i = 0; i < names->size(); ++i)
    dump.palette.push_back({(*names)[i], Eigen::Map<const Eigen::VectorXd>(&(*K)[i * bands], n),
                            Eigen::Map<const Eigen::VectorXd>(&(*S)[i * bands], n)});
  return read_wavelengths(*wavelength, dump);
}

Result<void> StateReader::read_lamp(Lamp& lamp, hid_t group) const {
  const auto direction = numbers("/lighting/lamp_direction", {3}, log::kDirectionRange);
  if (!direction) return direction.error();
  const auto color = numbers("/lighting/lamp_color", {3}, kLightRange);
  if (!color) return color.error();
  const auto intensity = hdf5::number_attribute(group, "lamp_intensity");
  const auto follows = hdf5::whole_attribute(group, "lamp_follows_gravity");
  if (!intensity || !follows) return missing("an attribute of /lighting");
  for (std::size_t i = 0; i < 3; ++i) {
    lamp.direction[i] = static_cast<float>((*direction)[i]);
    lamp.color[i] = static_cast<float>((*color)[i]);
  }
  lamp.intensity = static_cast<float>(*intensity);
  lamp.follows_gravity = *follows != 0;
  return {};
}

Result<void> StateReader::read_lighting(Lighting& light) const {
  const Handle group = hdf5::open_group(file_, "/lighting");
  if (!group.ok()) return missing("/lighting");
  if (const Result<void> lamp = read_lamp(light.lamps.front(), group.id()); !lamp) return lamp;
  if (!hdf5::read_lamps(file_, light.lamps))
    return bad("/lighting: lamps of a wrong shape, or a value out of range");
  if (!hdf5::read_development(group.id(), light))
    return bad("/lighting: an attribute malformed or out of range");
  const auto sh = numbers("/lighting/sh", {9, 3}, kLightRange);
  if (!sh) return sh.error();
  for (std::size_t i = 0; i < sh->size(); ++i)
    light.environment.L[i / 3][i % 3] = static_cast<float>((*sh)[i]);
  const std::tuple<const char*, log::Range, float*> attributes[] = {
      {"reflection_fov_deg", log::kFovRange, &light.reflection.fov_deg},
      {"roughness_wet", kRoughnessRange, &light.roughness_wet},
      {"roughness_dry", kRoughnessRange, &light.roughness_dry},
      {"refractive_index", kIndexRange, &light.refractive_index},
      {"relief_scale", kReliefScaleRange, &light.relief_scale},
      {"exposure_ev", log::kExposureRange, &light.exposure_ev}};
  for (const auto& [name, range, member] : attributes) {
    const auto value = hdf5::number_attribute(group.id(), name);
    if (!value) return missing(std::string("/lighting attribute ") + name);
    if (!(*value >= range.min && *value <= range.max)) return outside(name, *value, range);
    *member = static_cast<float>(*value);
  }
  const auto mirror = hdf5::whole_attribute(group.id(), "reflection_mirror");
  if (!mirror) return missing("/lighting attribute reflection_mirror");
  light.reflection.mirror = *mirror != 0;
  for (const auto& [picture, planes] :
       {std::pair{kReflection, &light.reflection.rgb}, std::pair{kProbe, &light.probe}}) {
    if (hdf5::lacks(file_, picture.name)) continue;
    auto rgb = hdf5::read_rgb_planes(from_, picture);
    if (!rgb) return rgb.error();
    *planes = std::move(*rgb);
  }
  return {};
}

Result<void> StateReader::read_guide(StateDump& dump, const hdf5::CanvasGroup& from) const {
  for (const hdf5::CanvasDataset& dataset : hdf5::kCanvasDatasets) {
    if (dataset.is_derived) continue;
    if (const Result<void> filled = hdf5::read_canvas(from, dataset, dump.state); !filled)
      return filled;
  }
  if (const auto slept = hdf5::read_sleep(from, dump.model, dump.state); !slept) return slept;
  const std::string hash = state_sha256(dump.state, from_.cancelled);
  if (Result<void> go = from_.go_on(); !go) return go;
  if (hash == dump.guide_sha256) return {};
  return bad("its values have the hash " + hash + ", it says " + dump.guide_sha256);
}

Result<void> StateReader::open_fine(StateDump& dump) const {
  const Result<hdf5::CanvasShape> shape = hdf5::canvas_shape({from_, ""}, kFineLimits);
  if (!shape) return shape.error();
  const CanvasState& guide = dump.state;
  const std::int64_t k = dump.detail;
  if (shape->width != k * guide.geometry.width || shape->height != k * guide.geometry.height ||
      shape->layers != guide.layers || shape->channels != guide.channels ||
      shape->bands != guide.bands)
    return bad(fmt::format("its canvas is not {} times its guide", k));
  const CanvasGeometry fine = {shape->width, shape->height, guide.geometry.width_m,
                               guide.geometry.height_m};
  from_.rehearsal.expect(fine_bytes(*shape), 0);
  auto source = hdf5::DumpSource::open(from_, *shape, fine, guide.step, kCacheBytes);
  if (!source) return source.error();
  dump.fine = std::move(*source);
  Result<std::optional<DetailCheckpoint>> checkpoint =
      hdf5::read_checkpoint({from_, ""}, {guide, dump.detail});
  if (!checkpoint) return checkpoint.error();
  dump.checkpoint = std::move(*checkpoint);
  return {};
}

Result<void> StateReader::check_fine(const StateDump& dump) const {
  if (!dump.fine) return {};
  // More than two would take addresses, which a trial has few of.
  const Threads threads(from_.threads == 1 ? 1 : 2);
  const bool serial = hdf5::whole_attribute(root_.id(), "format_version") <= kSerialVersion;
  const std::string hash = serial ? serial_sha256(*dump.fine, from_.cancelled)
                                  : detail_sha256(*dump.fine, threads, from_.cancelled);
  if (Result<void> go = from_.go_on(); !go) return go;
  if (const Result<void> read = dump.fine->status(); !read) return read;
  if (hash == dump.state_sha256) return {};
  return bad("its values have the hash " + hash + ", it says " + dump.state_sha256);
}

Result<StateDump> StateReader::read() {
  if (const Result<void> fine = check_format(); !fine) return fine.error();
  StateDump dump;
  const auto said = hdf5::whole_attribute(root_.id(), "detail");
  if (!said && hdf5::has_attribute(root_.id(), "detail")) return missing("detail");
  const std::int64_t detail = said.value_or(1);
  if (detail < 1 || detail > kMostDetail)
    return bad(fmt::format("detail is {}, must be 1 to {}", detail, kMostDetail));
  dump.detail = static_cast<int>(detail);
  const hdf5::CanvasGroup from = {from_, detail > 1 ? "/guide" : ""};
  Result<CanvasState> canvas = hdf5::empty_canvas(from);
  if (!canvas) return canvas.error();
  dump.state = std::move(*canvas);
  if (const Result<void> root = read_root(dump); !root) return root.error();
  if (const Result<void> model = read_model(dump.model); !model) return model.error();
  if (const Result<void> palette = read_palette(dump); !palette) return palette.error();
  if (const Result<void> basis = read_basis(dump); !basis) return basis.error();
  if (const Result<void> light = read_lighting(dump.lighting); !light) return light.error();
  const Handle notes = hdf5::open_group(file_, "/provenance");
  if (!notes.ok() && !hdf5::lacks(file_, "/provenance")) return missing("/provenance");
  if (notes.ok()) dump.provenance = hdf5::text_attributes(notes.id());
  if (const Result<void> guide = read_guide(dump, from); !guide) return guide.error();
  if (detail > 1) {
    if (const Result<void> fine = open_fine(dump); !fine) return fine.error();
  }
  return dump;
}

}  // namespace

Result<StateDump> hdf5::read_dump(const DumpFile& from, bool whole) {
  const Silence silence;
  StateReader reader(from);
  Result<StateDump> dump = reader.read();
  if (!dump || !whole) return dump;
  if (const Result<void> right = reader.check_fine(*dump); !right) return right.error();
  return dump;
}

}  // namespace pentimento
