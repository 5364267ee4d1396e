#pragma once
// The names in a state dump (docs/state-format.md), for writer and reader, and the planes of a
// canvas in the form that the dump has.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/canvas/canvas_source.h"

namespace pentimento::hdf5 {

/// A dataset of the canvas: rows of `row_values` values of 4 bytes, in the order of the dump.
struct CanvasDataset {
  const char* name;
  const char* units;
  const char* long_name;
  // Between which all values lie, whatever is painted. The bounds are generous: they keep out what
  // single precision and a finite run cannot hold.
  float least = 0, most = 0;
  bool is_integer = false;  // uint32, else float32; has no bounds
  bool is_derived = false;  // follows from others: not in the hash, not read
  bool is_paint = false;    // all bits are 0 where CanvasSource::empty() holds
};

/// In the order of the hash. (velocity_y, which is negated, is -0 where nothing moves.)
inline constexpr std::array<CanvasDataset, 9> kCanvasDatasets = {{
    {"/fluid/depth", "m", "depth of the wet paint", 0, 1e3f, false, false, true},
    {"/fluid/velocity_x", "m/s", "surface velocity to the right", -1e4f, 1e4f, false, false, true},
    {"/fluid/velocity_y", "m/s", "surface velocity upwards", -1e4f, 1e4f},
    {"/canvas/base", "m", "paper relief and dried paint", -1e3f, 1e3f},
    {"/canvas/paper", "m", "paper relief", -1e3f, 1e3f},
    {"/canvas/reflectance", "1", "reflectance of the dry layer, per band", 0, 1.001f},
    {"/layers/pigment", "1", "amount of each channel in each layer, bottom layer first", 0, 1e9f,
     false, false, true},
    {"/layers/stroke", "1", "the last stroke that touched the cell, 0 = none", 0, 0, true},
    {"/fluid/height", "m", "height of the surface: base + depth", -2e3f, 2e3f, false, true},
}};

/// Cells along a side of the chunks of a detail canvas. They are square, for it is read part by
/// part, and a part needs few of them.
inline constexpr int kChunkSide = 256;

/// The numbers from which all shapes follow.
struct CanvasShape {
  int width = 0, height = 0;  // cells
  int layers = 0, channels = 0, bands = 0;
};
CanvasShape shape_of(const CanvasSource& canvas);

/// Shape of a dataset of a canvas.
std::vector<std::uint64_t> shape_of(const CanvasShape& canvas, const CanvasDataset& dataset);

/// Values of 4 bytes that a cell has in each row.
int cell_values(const CanvasShape& canvas, const CanvasDataset& dataset);
/// Rows of the whole dataset: `row` counts through all planes, top to bottom, plane after plane.
std::int64_t row_count(const CanvasSource& canvas, const CanvasDataset& dataset);

/// Copies the cells x, x + 1, ... of one row in the dump's form (velocity_y negated, reflectance
/// interleaved). The size of `out` is a whole number of cells.
void copy_cells(const CanvasSource& canvas, const CanvasDataset& dataset, std::int64_t row, int x,
                std::span<std::uint32_t> out);
/// What is wrong with values in the dump's form, as "has the value 3e+38, outside 0..1000"; empty
/// if nothing.
std::string value_problem(const CanvasDataset& dataset, std::span<const std::uint32_t> values);

/// Copies a whole row from the dump's form into a state whose planes of paint are zeros so far. Not
/// for derived datasets.
void store_row(CanvasState& fresh, const CanvasDataset& dataset, std::int64_t row,
               std::span<const std::uint32_t> in);

}  // namespace pentimento::hdf5
