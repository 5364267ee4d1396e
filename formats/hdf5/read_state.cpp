#include "formats/hdf5/read_state.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "formats/hdf5/detail_checkpoint.h"
#include "formats/hdf5/dump_source.h"
#include "formats/hdf5/handle.h"
#include "formats/hdf5/layout.h"
#include "formats/hdf5/lighting_parts.h"
#include "formats/hdf5/read_canvas.h"
#include "formats/hdf5/read_small.h"
#include "formats/hdf5/rehearsal.h"
#include "formats/hdf5/sleep.h"
#include "formats/hdf5/state_dump.h"
#include "formats/log/tables/model_fields.h"

namespace pentimento {

namespace {

using hdf5::Handle;

constexpr std::size_t kMostNames = 65536;
constexpr std::int64_t kMostDetail = 32;
constexpr std::size_t kCacheBytes = std::size_t{256} << 20;
// The detail canvas is never held whole.
constexpr hdf5::ShapeLimits kFineLimits = {1 << 20, std::uint64_t{1} << 38, std::uint64_t{1} << 44};
constexpr std::string_view kSignature = "\x89HDF\r\n\x1A\n";

/// Reads a dump; the first thing that is wrong ends it.
class StateReader {
 public:
  StateReader(const std::string& path, hid_t file)
      : path_(path), file_(file), root_(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose) {}

  Result<StateDump> read();
  /// Checks that the detail canvas has the hash that the dump names.
  Result<void> check_fine(const StateDump& dump) const;

 private:
  Error bad(const std::string& what) const { return {ErrorCode::kBadInput, path_ + ": " + what}; }
  Error missing(const std::string& what) const { return bad(what + " is missing or malformed"); }
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

  const std::string& path_;
  hid_t file_;
  Handle root_;
};

Result<void> StateReader::check_format() const {
  if (hdf5::text_attribute(root_.id(), "format") != kStateFormat)
    return bad("an HDF5 file, but not a state dump");
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
  if (!width || !(*width > 0)) return missing("canvas_width_m");
  if (!height || !(*height > 0)) return missing("canvas_height_m");
  if (!step || *step < 0) return missing("step");
  if (!time) return missing("time_s");
  if (!rate || !(*rate > 0)) return missing("steps_per_second");
  if (!hash) return missing("state_sha256");
  if (!guide && dump.detail > 1) return missing("guide_sha256");
  dump.state.geometry.width_m = *width;
  dump.state.geometry.height_m = *height;
  dump.state.step = *step;
  dump.time_s = *time;
  dump.steps_per_second = *rate;
  dump.state_sha256 = *hash;
  dump.guide_sha256 = dump.detail > 1 ? *guide : *hash;
  dump.log_sha256 = hdf5::text_attribute(root_.id(), "log_sha256").value_or("");
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
    if (!value) continue;
    const std::string problem = log::value_problem(field, *value);
    if (!problem.empty()) return bad(problem);
    log::set_model_value(field, model, *value);
  }
  return {};
}

Result<void> StateReader::read_basis(StateDump& dump) const {
  const auto names = hdf5::read_strings(file_, "/layers/channel", kMostNames);
  const auto channels = static_cast<std::uint64_t>(dump.state.channels);
  const auto bands = static_cast<std::uint64_t>(dump.state.bands);
  if (!names || names->size() != channels) return missing("/layers/channel");
  const auto K = hdf5::read_doubles(file_, "/layers/K", {bands, channels});
  const auto S = hdf5::read_doubles(file_, "/layers/S", {bands, channels});
  const auto amount = hdf5::read_doubles(file_, "/layers/amount", {channels});
  const auto load = hdf5::read_doubles(file_, "/layers/load", {channels, dump.palette.size()});
  if (!K) return missing("/layers/K");
  if (!S) return missing("/layers/S");
  if (!amount) return missing("/layers/amount");
  if (!load) return missing("/layers/load");
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
  if (!spectral) return {};
  double before_nm = 0;
  for (const double m : wavelength_m) {
    const double nm = std::round(m * 1e9 * kDigits) / kDigits;
    if (!(nm > before_nm && nm < 1e6))
      return bad(fmt::format("/palette/wavelength {} m does not rise from band to band", m));
    dump.basis.wavelength_nm.push_back(before_nm = nm);
  }
  if (dump.state.bands == dump.model.bands) return {};
  return bad(fmt::format("/canvas/reflectance has {} bands, the model {}", dump.state.bands,
                         dump.model.bands));
}

Result<void> StateReader::read_palette(StateDump& dump) const {
  const auto names = hdf5::read_strings(file_, "/palette/name", kMostNames);
  if (!names) return missing("/palette/name");
  const auto bands = static_cast<std::uint64_t>(dump.state.bands);
  const auto K = hdf5::read_doubles(file_, "/palette/K", {names->size(), bands});
  const auto S = hdf5::read_doubles(file_, "/palette/S", {names->size(), bands});
  const auto wavelength = hdf5::read_doubles(file_, "/palette/wavelength", {bands});
  if (!K) return missing("/palette/K");
  if (!S) return missing("/palette/S");
  if (!wavelength) return missing("/palette/wavelength");
  const auto n = static_cast<Eigen::Index>(bands);
  for (std::size_t i = 0; i < names->size(); ++i)
    dump.palette.push_back({(*names)[i], Eigen::Map<const Eigen::VectorXd>(&(*K)[i * bands], n),
                            Eigen::Map<const Eigen::VectorXd>(&(*S)[i * bands], n)});
  return read_wavelengths(*wavelength, dump);
}

Result<void> StateReader::read_lamp(Lamp& lamp, hid_t group) const {
  const auto direction = hdf5::read_doubles(file_, "/lighting/lamp_direction", {3});
  const auto color = hdf5::read_doubles(file_, "/lighting/lamp_color", {3});
  const auto intensity = hdf5::number_attribute(group, "lamp_intensity");
  const auto follows = hdf5::whole_attribute(group, "lamp_follows_gravity");
  if (!direction) return missing("/lighting/lamp_direction");
  if (!color) return missing("/lighting/lamp_color");
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
  if (H5Lexists(file_, "/lighting", H5P_DEFAULT) <= 0) return missing("/lighting");
  const Handle group(H5Gopen2(file_, "/lighting", H5P_DEFAULT), H5Gclose);
  if (const Result<void> lamp = read_lamp(light.lamps.front(), group.id()); !lamp) return lamp;
  if (!hdf5::read_lamps(file_, light.lamps)) return bad("/lighting: lamps of a wrong shape");
  if (!hdf5::read_development(group.id(), light))
    return bad("/lighting: an attribute out of range");
  const auto sh = hdf5::read_doubles(file_, "/lighting/sh", {9, 3});
  if (!sh) return missing("/lighting/sh");
  for (std::size_t i = 0; i < sh->size(); ++i)
    light.environment.L[i / 3][i % 3] = static_cast<float>((*sh)[i]);
  const std::pair<const char*, float*> numbers[] = {
      {"reflection_fov_deg", &light.reflection.fov_deg},
      {"roughness_wet", &light.roughness_wet},
      {"roughness_dry", &light.roughness_dry},
      {"refractive_index", &light.refractive_index},
      {"relief_scale", &light.relief_scale},
      {"exposure_ev", &light.exposure_ev}};
  for (const auto& [name, member] : numbers) {
    const auto value = hdf5::number_attribute(group.id(), name);
    if (!value) return missing(std::string("/lighting attribute ") + name);
    *member = static_cast<float>(*value);
  }
  const auto mirror = hdf5::whole_attribute(group.id(), "reflection_mirror");
  if (!mirror) return missing("/lighting attribute reflection_mirror");
  light.reflection.mirror = *mirror != 0;
  const std::pair<const char*, std::array<Field<float>, 3>*> pictures[] = {
      {"/lighting/reflection", &light.reflection.rgb}, {"/lighting/probe", &light.probe}};
  for (const auto& [name, planes] : pictures) {
    if (!hdf5::has_dataset(file_, name)) continue;
    auto rgb = hdf5::read_rgb_planes(file_, path_, name);
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
  const std::string hash = state_sha256(dump.state);
  if (hash == dump.guide_sha256) return {};
  return bad("its values have the hash " + hash + ", it says " + dump.guide_sha256);
}

Result<void> StateReader::open_fine(StateDump& dump) const {
  const Result<hdf5::CanvasShape> shape = hdf5::canvas_shape({file_, path_, ""}, kFineLimits);
  if (!shape) return shape.error();
  const CanvasState& guide = dump.state;
  const std::int64_t k = dump.detail;
  if (shape->width != k * guide.geometry.width || shape->height != k * guide.geometry.height ||
      shape->layers != guide.layers || shape->channels != guide.channels ||
      shape->bands != guide.bands)
    return bad(fmt::format("its canvas is not {} times its guide", k));
  const CanvasGeometry fine = {shape->width, shape->height, guide.geometry.width_m,
                               guide.geometry.height_m};
  auto source = hdf5::DumpSource::open(path_, *shape, fine, guide.step, kCacheBytes);
  if (!source) return source.error();
  dump.fine = std::move(*source);
  Result<std::optional<DetailCheckpoint>> checkpoint =
      hdf5::read_checkpoint({file_, path_, ""}, {guide, dump.detail});
  if (!checkpoint) return checkpoint.error();
  dump.checkpoint = std::move(*checkpoint);
  return {};
}

Result<void> StateReader::check_fine(const StateDump& dump) const {
  if (!dump.fine) return {};
  const std::string hash = state_sha256(*dump.fine);
  if (const Result<void> read = dump.fine->status(); !read) return read;
  if (hash == dump.state_sha256) return {};
  return bad("its values have the hash " + hash + ", it says " + dump.state_sha256);
}

Result<StateDump> StateReader::read() {
  if (const Result<void> fine = check_format(); !fine) return fine.error();
  StateDump dump;
  const std::int64_t detail = hdf5::whole_attribute(root_.id(), "detail").value_or(1);
  if (detail < 1 || detail > kMostDetail)
    return bad(fmt::format("detail is {}, must be 1 to {}", detail, kMostDetail));
  dump.detail = static_cast<int>(detail);
  const hdf5::CanvasGroup from = {file_, path_, detail > 1 ? "/guide" : ""};
  Result<CanvasState> canvas = hdf5::empty_canvas(from);
  if (!canvas) return canvas.error();
  dump.state = std::move(*canvas);
  if (const Result<void> root = read_root(dump); !root) return root.error();
  if (const Result<void> model = read_model(dump.model); !model) return model.error();
  if (const Result<void> palette = read_palette(dump); !palette) return palette.error();
  if (const Result<void> basis = read_basis(dump); !basis) return basis.error();
  if (const Result<void> light = read_lighting(dump.lighting); !light) return light.error();
  if (H5Lexists(file_, "/provenance", H5P_DEFAULT) > 0) {
    const Handle checkpoint(H5Gopen2(file_, "/provenance", H5P_DEFAULT), H5Gclose);
    dump.provenance = hdf5::text_attributes(checkpoint.id());
  }
  if (const Result<void> guide = read_guide(dump, from); !guide) return guide.error();
  if (detail > 1) {
    if (const Result<void> fine = open_fine(dump); !fine) return fine.error();
  }
  return dump;
}

/// Error if the file cannot be opened or is not HDF5 by its first bytes.
Result<void> check_signature(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(errno))};
  char head[kSignature.size()];
  const std::size_t n = std::fread(head, 1, sizeof head, file);
  const int problem = std::ferror(file) != 0 ? errno : 0;
  std::fclose(file);
  if (problem != 0)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(problem))};
  if (std::string_view(head, n) != kSignature)
    return Error{ErrorCode::kBadInput, path + ": not an HDF5 file"};
  return {};
}

/// `whole`: the values of the detail canvas too, which are read when they are needed.
Result<StateDump> read_here(const std::string& path, bool whole) {
  const hdf5::Silence silence;
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.ok()) return Error{ErrorCode::kBadInput, path + ": a damaged or cut short HDF5 file"};
  StateReader reader(path, file.id());
  Result<StateDump> dump = reader.read();
  if (!dump || !whole) return dump;
  if (const Result<void> right = reader.check_fine(*dump); !right) return right.error();
  return dump;
}

}  // namespace

Result<StateDump> read_state(const std::string& path) {
  if (const Result<void> signed_file = check_signature(path); !signed_file)
    return signed_file.error();
  const Result<bool> right = hdf5::rehearse(path, [&] { return read_here(path, true).ok(); });
  if (!right) return right.error();
  // A file that was found right need not be checked again.
  return read_here(path, !*right);
}

Result<void> hdf5::check_dump_file(const std::string& file, const std::string& name) {
  const Result<bool> right = rehearse(file, [&] { return read_here(file, true).ok(); });
  if (right && *right) return {};
  return Error{ErrorCode::kIo, name + ": what was read back differs from what was written"};
}

}  // namespace pentimento
