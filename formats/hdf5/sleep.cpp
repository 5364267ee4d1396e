#include "formats/hdf5/sleep.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/fluid/conservative/tiles/sleep_tiles.h"
#include "formats/hdf5/objects.h"
#include "formats/hdf5/read_small.h"
#include "formats/hdf5/write_small.h"
#include "formats/log/tables/ranges.h"

namespace pentimento::hdf5 {

namespace {

using conservative::kGravityY;
using conservative::kSleepValues;

/// From y down to y up, or back.
void flip(std::vector<float>& sleep) {
  for (std::size_t i = kGravityY; i < sleep.size(); i += kSleepValues) sleep[i] = -sleep[i];
}

}  // namespace

std::vector<std::uint64_t> sleep_shape(std::size_t values) {
  return {values / kSleepValues, kSleepValues};
}

std::vector<float> sleep_to_dump(const CanvasState& state) {
  std::vector<float> sleep = state.sleep;
  flip(sleep);
  return sleep;
}

bool write_sleep(hid_t file, const std::string& group, const CanvasState& state) {
  if (state.sleep.empty()) return true;
  const std::vector<std::uint64_t> shape = sleep_shape(state.sleep.size());
  const std::string name = group + kSleepName;
  return write_small(file,
                     {name.c_str(),
                      "1, m/s^2 (3), 1",
                      "per tile: 1 = asleep; gravity right, up, out when it fell asleep; "
                      "1 = its paint feels gravity",
                      {shape.begin(), shape.end()}},
                     sleep_to_dump(state));
}

Result<void> read_sleep(const CanvasGroup& from, const Model& model, CanvasState& state) {
  state.sleep.clear();
  const std::string name = from.group + kSleepName;
  if (const std::string problem = dataset_problem(from.file, name); !problem.empty())
    return Error{ErrorCode::kBadInput, from.path + ": " + problem};
  if (lacks(from.file, name)) return {};
  const conservative::SleepTiles tiles(state.geometry, model.sleep_tile_m);
  const auto needed = sleep_shape(static_cast<std::size_t>(tiles.count()) * kSleepValues);
  const auto found = dataset_shape(from.file, name);
  const auto bad = [&](const std::string& what) {
    return Error{ErrorCode::kBadInput, fmt::format("{}: {} {}", from.path, name, what)};
  };
  if (found && *found != needed)
    return bad(
        fmt::format("is {}, must be {}", fmt::join(*found, " x "), fmt::join(needed, " x ")));
  const auto values = read_doubles(from.file, name, needed);
  if (!values) return bad("cannot be read");
  if (!std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); }))
    return bad("has a value that is not finite");
  for (std::size_t i = 0; i < values->size(); ++i) {
    const std::size_t column = i % kSleepValues;
    const bool flag = column == conservative::kAsleep || column == conservative::kFeelsGravity;
    const log::Range range = flag ? log::kUnitRange : log::kAccelerationRange;
    const double value = (*values)[i];
    if (value < range.min || value > range.max)
      return bad(fmt::format("has the value {}, outside {}..{}", value, range.min, range.max));
    state.sleep.push_back(static_cast<float>(value));
  }
  flip(state.sleep);
  return {};
}

}  // namespace pentimento::hdf5
