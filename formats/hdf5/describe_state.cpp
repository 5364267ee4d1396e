#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>

#include "formats/hdf5/handle.h"
#include "formats/hdf5/input_driver.h"
#include "formats/hdf5/objects.h"
#include "formats/hdf5/read_small.h"
#include "formats/hdf5/rehearsal.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/describe.h"

namespace pentimento {

namespace {

std::string number_text(double value) {
  return fmt::format("{}", value);
}

/// The attributes of the root, then those of /provenance that the root does not have.
Provenance whole_checkpoint(hid_t file, hid_t root) {
  Provenance checkpoint = hdf5::text_attributes(root);
  for (const char* name : {"step", "format_version", "detail"})
    if (const auto value = hdf5::whole_attribute(root, name))
      checkpoint.emplace_back(name, std::to_string(*value));
  for (const char* name : {"canvas_width_m", "canvas_height_m", "time_s", "steps_per_second"})
    if (const auto value = hdf5::number_attribute(root, name))
      checkpoint.emplace_back(name, number_text(*value));
  const hdf5::Handle group = hdf5::open_group(file, "/provenance");
  if (!group.ok()) return checkpoint;
  for (const auto& [key, value] : hdf5::text_attributes(group.id()))
    if (provenance_value(checkpoint, key).empty()) checkpoint.emplace_back(key, value);
  return checkpoint;
}

Result<FileDescription> describe_here(const std::string& path) {
  const hdf5::Silence silence;
  const hdf5::Handle file = hdf5::open_to_read(path);
  if (!file.ok()) return Error{ErrorCode::kBadInput, path + ": a damaged or cut short HDF5 file"};
  const hdf5::Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
  if (const std::string problem = hdf5::format_problem(root.id()); !problem.empty())
    return Error{ErrorCode::kBadInput, path + ": " + problem};
  const auto shape = hdf5::dataset_shape(file.id(), "/layers/pigment");
  constexpr std::uint64_t kMost = std::uint64_t{1} << 30;
  if (!shape || shape->size() != 4 || *std::max_element(shape->begin(), shape->end()) > kMost)
    return Error{ErrorCode::kBadInput, path + ": /layers/pigment is missing or malformed"};
  FileDescription out;
  out.format = "hdf5";
  out.height = static_cast<int>((*shape)[2]);
  out.width = static_cast<int>((*shape)[3]);
  out.samples = fmt::format("{} layers x {} channels", (*shape)[0], (*shape)[1]);
  out.provenance = whole_checkpoint(file.id(), root.id());
  return out;
}

}  // namespace

Result<FileDescription> describe_state(const std::string& path) {
  const Result<void> survived =
      hdf5::rehearse(path, nullptr, [&](const hdf5::Rehearsal&) -> Result<void> {
        hdf5::load_no_filters();
        const Result<FileDescription> described = describe_here(path);
        if (!described) return described.error();
        return {};
      });
  if (!survived) return survived.error();
  return describe_here(path);
}

}  // namespace pentimento
