#include "core/fluid/paper/pigment.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "core/base/kernel.h"
#include "core/fluid/paper/departure.h"
#include "core/fluid/paper/near_pigment.h"

namespace pentimento::paper {

namespace {

constexpr int kChunk = 256;  // cells summed at a time, in the first-level cache
using CellChunk = std::array<float, kChunk>;
using CellCounts = std::array<std::int32_t, kChunk>;

/// Adds share * plane to the sums of cells [begin, begin + count) of row y.
PENTIMENTO_KERNEL
void add_row(const Field<float>& plane, float share, int y, int begin, int count, CellChunk& sums) {
  const float* p = plane.row(y) + begin;
  for (int i = 0; i < count; ++i) sums[static_cast<std::size_t>(i)] += share * p[i];
}

/// Counts one layer more in cells whose amounts have a sum above 0.
PENTIMENTO_KERNEL
void count_occupied(const CellChunk& sums, int count, CellCounts& layers) {
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    layers[at] += sums[at] > 0.0f ? 1 : 0;
  }
}

PENTIMENTO_KERNEL
void store_counts(const CellCounts& layers, int count, std::uint8_t* __restrict occupied) {
  for (int i = 0; i < count; ++i)
    occupied[i] = static_cast<std::uint8_t>(layers[static_cast<std::size_t>(i)]);
}

PENTIMENTO_KERNEL
void find_free(const CellChunk& sums, float residue, int count, float* __restrict free_frac) {
  for (int i = 0; i < count; ++i) {
    const float sum = sums[static_cast<std::size_t>(i)];
    const float free = 1.0f - residue / (sum > residue ? sum : 1.0f);
    free_frac[i] = sum > residue ? free : 0.0f;
  }
}

/// The departure point of this layer's pigment in cell (x, y). u and v: velocity of the surface.
Departure depart_layer(const StepConstants& k, const GridShape& grid, float share, int x, int y,
                       float u, float v) {
  return depart(x, y, share * u * (k.dt_s / k.dx_m), share * v * (k.dt_s / k.dy_m), grid);
}

}  // namespace

void count_layers_row(const CanvasState& state, int y, Columns cells, Planes& planes) {
  std::uint8_t* occupied = planes.occupied.row(y);
  for (int begin = cells.begin; begin < cells.end; begin += kChunk) {
    const int count = std::min(kChunk, cells.end - begin);
    CellCounts layers{};
    for (int layer = 0; layer < state.layers; ++layer) {
      CellChunk sums{};
      for (int c = 0; c < state.channels; ++c)
        add_row(state.channel(layer, c), 1.0f, y, begin, count, sums);
      count_occupied(sums, count, layers);
    }
    store_counts(layers, count, occupied + begin);
  }
}

void find_free_row(const CanvasState& state, const std::vector<float>& amount, float residue, int y,
                   Columns cells, Planes& planes) {
  float* loose = planes.free_frac.row(y);
  for (int begin = cells.begin; begin < cells.end; begin += kChunk) {
    const int count = std::min(kChunk, cells.end - begin);
    CellChunk sums{};
    for (int c = 0; c < state.channels; ++c)
      add_row(state.channel(0, c), amount[static_cast<std::size_t>(c)], y, begin, count, sums);
    find_free(sums, residue, count, loose + begin);
  }
}

void advect_pigment_cells(const StepConstants& k, const CanvasState& state, int layer,
                          const float* u_m_s, const float* v_m_s, int y, Columns cells,
                          Planes& planes) {
  const GridShape grid = shape_of(state.depth_m);
  const std::uint8_t* occupied = planes.occupied.row(y);
  const float* loose = planes.free_frac.row(0);
  const std::ptrdiff_t row = y * grid.stride;
  for (int c = 0; c < state.channels; ++c)
    std::copy_n(state.channel(layer, c).row(y) + cells.begin, cells.count(),
                planes.pigment[static_cast<std::size_t>(c)].row(y) + cells.begin);
  for (int x = cells.begin; x < cells.end; ++x) {
    if (u_m_s[x] == 0.0f && v_m_s[x] == 0.0f) continue;
    const float share = layer_velocity_frac(layer, occupied[x]);
    const Departure from = depart_layer(k, grid, share, x, y, u_m_s[x], v_m_s[x]);
    for (int c = 0; c < state.channels; ++c) {
      const float* pigment = state.channel(layer, c).row(0);
      const float arrived = layer == 0 ? interpolate_product(pigment, loose, from) +
                                             (1.0f - loose[row + x]) * pigment[row + x]
                                       : interpolate(pigment, from);
      planes.pigment[static_cast<std::size_t>(c)].row(y)[x] = without_tail(arrived);
    }
  }
}

void advect_pigment_row(const StepConstants& k, const CanvasState& state, int layer,
                        const float* u_m_s, const float* v_m_s, int y, Columns cells,
                        Planes& planes) {
  const NearRow row{.y = y,
                    .grid = shape_of(state.depth_m),
                    .u_m_s = u_m_s,
                    .v_m_s = v_m_s,
                    .layer = layer,
                    .occupied = planes.occupied.row(y)};
  const auto near = [&](const NearDepartures& from) {
    for (int c = 0; c < state.channels; ++c) {
      const Field<float>& pigment = state.channel(layer, c);
      Field<float>& arrived = planes.pigment[static_cast<std::size_t>(c)];
      if (layer == 0)
        arrive_near_free(from, pigment, planes.free_frac, y, arrived);
      else
        arrive_near(from, pigment, y, arrived);
    }
  };
  for_near_cells(k, row, cells, near, [&](int begin, int end) {
    advect_pigment_cells(k, state, layer, u_m_s, v_m_s, y, {begin, end}, planes);
  });
}

bool store_pigment_row(const Planes& planes, int layer, int y, Columns cells, CanvasState& state) {
  bool changed = false;
  const std::size_t bytes = cells.count() * sizeof(float);
  for (int c = 0; c < state.channels; ++c) {
    const float* from = planes.pigment[static_cast<std::size_t>(c)].row(y) + cells.begin;
    float* to = state.channel(layer, c).row(y) + cells.begin;
    if (bytes == 0 || std::memcmp(from, to, bytes) == 0) continue;
    std::memcpy(to, from, bytes);
    changed = true;
  }
  return changed;
}

bool complete_pigment_row(const CanvasState& state, int layer, int y, Columns cells,
                          Planes& planes) {
  bool differs = false;
  for (int c = 0; c < state.channels; ++c) {
    const float* from = state.channel(layer, c).row(y);
    float* to = planes.pigment[static_cast<std::size_t>(c)].row(y);
    differs |= !cells.empty() && std::memcmp(from + cells.begin, to + cells.begin,
                                             cells.count() * sizeof(float)) != 0;
    for (const Columns& rest : around(cells, {0, state.geometry.width}))
      std::copy_n(from + rest.begin, rest.count(), to + rest.begin);
  }
  return differs;
}

void exchange_pigment(int layer, CanvasState& state, Planes& planes) {
  for (int c = 0; c < state.channels; ++c)
    swap(state.channel(layer, c), planes.pigment[static_cast<std::size_t>(c)]);
}

}  // namespace pentimento::paper
