#include <fmt/format.h>
#include <hdf5.h>

#include <string_view>

#include "core/base/interruption.h"
#include "core/base/threads.h"
#include "core/optics/tone.h"
#include "formats/hdf5/chunked.h"
#include "formats/hdf5/detail_checkpoint.h"
#include "formats/hdf5/handle.h"
#include "formats/hdf5/lighting_parts.h"
#include "formats/hdf5/output_driver.h"
#include "formats/hdf5/read_state.h"
#include "formats/hdf5/sleep.h"
#include "formats/hdf5/state_dump.h"
#include "formats/hdf5/write_canvas.h"
#include "formats/hdf5/write_small.h"
#include "formats/hdf5/xdmf.h"
#include "formats/io/provenance.h"
#include "formats/io/publish.h"
#include "formats/log/tables/model_fields.h"

namespace pentimento {

namespace {

using hdf5::Handle;
using hdf5::set_attribute;
using hdf5::write_small;

constexpr std::size_t kImageGrowth = std::size_t{4} << 20;
constexpr const char* kGroups[] = {"/fluid",   "/canvas",   "/layers",
                                   "/palette", "/lighting", "/provenance"};
constexpr const char* kGuideGroups[] = {"/guide", "/guide/fluid", "/guide/canvas", "/guide/layers"};

struct Hashes {
  std::string state, guide;
};

template <typename Matrix>
auto row_major(const Matrix& m) {
  std::vector<typename Matrix::Scalar> values;
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j) values.push_back(m(i, j));
  return values;
}

template <typename Matrix>
std::vector<hsize_t> shape_of(const Matrix& m) {
  return {static_cast<hsize_t>(m.rows()), static_cast<hsize_t>(m.cols())};
}

bool write_basis(hid_t file, const ChannelBasis& basis) {
  return write_small(file, {"/layers/channel", "", "name of each channel", {}}, basis.name) &&
         write_small(file, {"/layers/K", "1", "absorption per band and channel", shape_of(basis.K)},
                     row_major(basis.K)) &&
         write_small(file, {"/layers/S", "1", "scattering per band and channel", shape_of(basis.S)},
                     row_major(basis.S)) &&
         write_small(file,
                     {"/layers/amount",
                      "1",
                      "share of each channel in the amount of pigment",
                      {static_cast<hsize_t>(basis.amount.size())}},
                     row_major(basis.amount)) &&
         write_small(file,
                     {"/layers/load", "1", "channels of amount 1 of each palette pigment",
                      shape_of(basis.load)},
                     row_major(basis.load));
}

bool write_palette(hid_t file, const StateDump& dump) {
  const std::size_t bands = static_cast<std::size_t>(dump.state.bands);
  std::vector<std::string> names;
  std::vector<double> K, S;
  for (const Pigment& pigment : dump.palette) {
    names.push_back(pigment.name);
    K.insert(K.end(), pigment.K.begin(), pigment.K.end());
    S.insert(S.end(), pigment.S.begin(), pigment.S.end());
  }
  std::vector<double> wavelength_m(bands, 0.0);
  for (std::size_t b = 0; b < dump.basis.wavelength_nm.size() && b < bands; ++b)
    wavelength_m[b] = dump.basis.wavelength_nm[b] * 1e-9;
  const std::vector<hsize_t> shape = {names.size(), bands};
  return write_small(file, {"/palette/name", "", "name of each pigment", {}}, names) &&
         write_small(file, {"/palette/K", "1", "absorption at optical thickness 1", shape}, K) &&
         write_small(file, {"/palette/S", "1", "scattering at optical thickness 1", shape}, S) &&
         write_small(file,
                     {"/palette/wavelength",
                      "m",
                      "centre of each band; 0 where the bands are red, green and blue",
                      {bands}},
                     wavelength_m);
}

/// Writes a picture of linear light as rows x columns x 3. Does nothing if there is no picture.
bool write_light(hid_t file, const char* name, const char* what,
                 const std::array<Field<float>, 3>& rgb, int level, const Threads& threads) {
  const Field<float>& red = rgb[0];
  if (red.empty()) return true;
  const hdf5::RowSource source = {
      {static_cast<std::uint64_t>(red.height()), static_cast<std::uint64_t>(red.width()), 3},
      [&](std::int64_t row, int, std::span<std::uint32_t> out) {
        for (std::size_t i = 0; i < out.size(); ++i)
          out[i] = std::bit_cast<std::uint32_t>(rgb[i % 3].row(static_cast<int>(row))[i / 3]);
      },
      0,
      {}};
  const Handle dataset(hdf5::write_chunked(file, name, H5T_NATIVE_FLOAT, source, level, threads),
                       H5Dclose);
  return dataset.ok() && hdf5::describe(dataset.id(), "1", what);
}

bool write_lighting(hid_t file, const Lighting& light, int level, const Threads& threads) {
  std::vector<float> sh;
  for (const auto& rgb : light.environment.L) sh.insert(sh.end(), rgb.begin(), rgb.end());
  const Lamp& lamp = light.lamps.front();
  const Handle group(H5Gopen2(file, "/lighting", H5P_DEFAULT), H5Gclose);
  const hid_t id = group.id();
  return write_small(file,
                     {"/lighting/lamp_direction", "1", "towards the lamp: right, up, out", {3}},
                     std::vector<float>(lamp.direction.begin(), lamp.direction.end())) &&
         write_small(file, {"/lighting/lamp_color", "1", "linear red, green, blue", {3}},
                     std::vector<float>(lamp.color.begin(), lamp.color.end())) &&
         write_small(
             file, {"/lighting/sh", "1", "radiance, spherical harmonics L00 to L22", {9, 3}}, sh) &&
         set_attribute(id, "lamp_intensity", lamp.intensity) &&
         set_attribute(id, "lamp_follows_gravity", std::int64_t{lamp.follows_gravity}) &&
         set_attribute(id, "reflection_fov_deg", light.reflection.fov_deg) &&
         set_attribute(id, "reflection_mirror", std::int64_t{light.reflection.mirror}) &&
         set_attribute(id, "roughness_wet", light.roughness_wet) &&
         set_attribute(id, "roughness_dry", light.roughness_dry) &&
         set_attribute(id, "refractive_index", light.refractive_index) &&
         set_attribute(id, "relief_scale", light.relief_scale) &&
         set_attribute(id, "exposure_ev", light.exposure_ev) &&
         set_attribute(id, "varnish", light.varnish) &&
         set_attribute(id, "occlusion", light.occlusion) &&
         set_attribute(id, "white_x", light.white_xy[0]) &&
         set_attribute(id, "white_y", light.white_xy[1]) &&
         set_attribute(id, "tone_curve", tone_curve_name(light.tone)) &&
         hdf5::write_lamps(file, light.lamps) &&
         write_light(file, "/lighting/reflection", "reflected picture, linear red, green, blue",
                     light.reflection.rgb, level, threads) &&
         write_light(file, "/lighting/probe",
                     "light probe that the gloss shows: a panorama, linear red, green, blue",
                     light.probe, level, threads);
}

bool write_model(hid_t root, const Model& model) {
  for (const log::ModelField& field : log::model_fields()) {
    const std::string name(field.name);
    const std::string text = log::model_value_json(field, model);
    // Words as text without quotes, numbers and switches as numbers.
    const bool written = text.front() == '"'
                             ? set_attribute(root, name, text.substr(1, text.size() - 2))
                             : set_attribute(root, name, log::get_model_value(field, model));
    if (!written) return false;
  }
  return true;
}

bool write_root(hid_t file, const StateDump& dump, const Hashes& hashes,
                const Provenance& provenance) {
  const Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose);
  const Handle checkpoint(H5Gopen2(file, "/provenance", H5P_DEFAULT), H5Gclose);
  const hid_t id = root.id();
  const std::string software = provenance_value(provenance, "software");
  bool ok = set_attribute(id, "format", std::string_view(kStateFormat)) &&
            set_attribute(id, "format_version",
                          std::int64_t{dump.fine ? kStateVersion : kPlainVersion}) &&
            set_attribute(id, "canvas_width_m", dump.state.geometry.width_m) &&
            set_attribute(id, "canvas_height_m", dump.state.geometry.height_m) &&
            set_attribute(id, "step", dump.state.step) &&
            set_attribute(id, "time_s", dump.time_s) &&
            set_attribute(id, "steps_per_second", dump.steps_per_second) &&
            set_attribute(id, "state_sha256", hashes.state) &&
            set_attribute(id, "guide_sha256", hashes.guide) &&
            (!dump.fine || set_attribute(id, "detail", std::int64_t{dump.detail})) &&
            set_attribute(id, "log_sha256", dump.log_sha256) &&
            set_attribute(id, "software", software.empty() ? "pentimento" : software) &&
            write_model(id, dump.model);
  for (const auto& [key, value] : provenance) ok = ok && set_attribute(checkpoint.id(), key, value);
  return ok;
}

/// The canvas that the dump is of; at detail 1 that is the guide.
bool write_canvases(hid_t file, const StateDump& dump, const DumpOptions& options,
                    const Threads& threads) {
  const int level = options.deflate_level;
  const StateSource guide(dump.state);
  if (!dump.fine)
    return hdf5::write_canvas(file, guide, {"", 0, level, options.cancelled}, threads) &&
           hdf5::write_sleep(file, "", dump.state);
  bool ok = hdf5::write_canvas(file, *dump.fine, {"", hdf5::kChunkSide, level, options.cancelled},
                               threads);
  for (const char* group : kGuideGroups) ok = ok && hdf5::make_group(file, group);
  return ok && hdf5::write_canvas(file, guide, {"/guide", 0, level, options.cancelled}, threads) &&
         hdf5::write_sleep(file, "/guide", dump.state) &&
         (!dump.checkpoint || hdf5::write_checkpoint(file, *dump.checkpoint,
                                                     {dump.state, dump.detail}, level, threads));
}

bool write_content(hid_t file, const StateDump& dump, const Hashes& hashes,
                   const DumpOptions& options) {
  const Threads threads(options.threads);
  const int level = options.deflate_level;
  bool ok = file >= 0;
  for (const char* group : kGroups) ok = ok && hdf5::make_group(file, group);
  return ok && write_canvases(file, dump, options, threads) && write_basis(file, dump.basis) &&
         write_palette(file, dump) && write_lighting(file, dump.lighting, level, threads) &&
         write_root(file, dump, hashes, options.provenance) &&
         H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0;
}

/// The bytes of the finished file; empty if HDF5 failed.
std::string file_image(const StateDump& dump, const Hashes& hashes, const DumpOptions& options) {
  const hdf5::Silence silence;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access.id(), kImageGrowth, false);
  const Handle file(H5Fcreate("state", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
  const bool ok = write_content(file.id(), dump, hashes, options);
  const ssize_t size = ok ? H5Fget_file_image(file.id(), nullptr, 0) : -1;
  if (size <= 0) return {};
  std::string image(static_cast<std::size_t>(size), '\0');
  return H5Fget_file_image(file.id(), image.data(), image.size()) == size ? image : std::string();
}

/// The finished file, never whole in memory. False if HDF5 failed.
bool stream_file(OutputFile& output, const StateDump& dump, const Hashes& hashes,
                 const DumpOptions& options) {
  const hdf5::Silence silence;
  hdf5::OutputDriver driver(output);
  Handle file = driver.create();
  const bool ok = write_content(file.id(), dump, hashes, options);
  return H5Fclose(file.release()) >= 0 && ok;
}

/// Finds out before anything is computed whether the target can be written at all.
Result<void> check_dump(const std::string& path, const StateDump& dump) {
  PENTIMENTO_CHECK(dump.basis.channels() == dump.state.channels);
  if (path == "-")
    return Error{ErrorCode::kUsage, "a state dump cannot be written to standard output"};
  return {};
}

}  // namespace

Result<std::unique_ptr<OutputFile>> complete_state(const std::string& path, const StateDump& dump,
                                                   const DumpOptions& options) {
  if (const Result<void> fine = check_dump(path, dump); !fine) return fine.error();
  Hashes hashes;
  hashes.guide = state_sha256(dump.state);
  hashes.state = !dump.fine ? hashes.guide
                 : dump.state_sha256.empty()
                     ? detail_sha256(*dump.fine, Threads(options.threads), options.cancelled)
                     : dump.state_sha256;
  std::string image;
  const Error no_memory = {ErrorCode::kLimit, path + ": no memory to build the state dump"};
  if (!dump.fine) image = file_image(dump, hashes, options);
  if (Result<void> go = unless_interrupted(options.cancelled); !go) return go.error();
  if (!dump.fine && image.empty()) return no_memory;
  Result<std::unique_ptr<OutputFile>> file = OutputFile::create(path, options.no_clobber);
  if (!file) return file.error();
  OutputFile& output = **file;
  if (!dump.fine) {
    output.write(image.data(), image.size());
    if (const Result<Published> whole = output.complete(); !whole) return whole.error();
    return file;
  }
  if (output.is_stream())
    return Error{ErrorCode::kUsage, path + ": a state dump of a detail canvas cannot go to a pipe"};
  const bool streamed = stream_file(output, dump, hashes, options);
  if (Result<void> go = unless_interrupted(options.cancelled); !go) return go.error();
  if (const Result<void> written = output.status(); !written) return written.error();
  if (const Result<void> read = dump.fine->status(); !read) return read.error();
  if (!streamed) return no_memory;
  const Result<Published> whole = output.complete([&](const std::string& temporary) {
    return hdf5::check_dump_file(temporary, path, {options.threads, options.cancelled});
  });
  if (!whole) return whole.error();
  return file;
}

Result<Published> write_state(const std::string& path, const StateDump& dump,
                              const DumpOptions& options) {
  Result<std::unique_ptr<OutputFile>> file = complete_state(path, dump, options);
  if (!file) return file.error();
  Result<Published> published = (*file)->publish();
  if (!published || !options.xdmf) return published;
  const Result<Published> sidecar =
      publish_bytes(path + ".xdmf", xdmf_text(path, dump), options.no_clobber);
  if (!sidecar) return sidecar.error();
  return published;
}

}  // namespace pentimento
