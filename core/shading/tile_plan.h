#pragma once
// How a picture is cut into tiles so that no texture, target or strip grows beyond its budget.

#include <vector>

#include "core/shading/sampling.h"

namespace pentimento {

struct PixelRun {
  int first = 0;  // pixel in the whole picture
  int count = 0;
};

struct TilePlan {
  std::vector<PixelRun> columns;
  std::vector<PixelRun> rows;
  int width = 0;  // of the largest tile
  int height = 0;
};

/// Side of a tile, pixels. Its textures and targets are a few megabytes, so they stay in the
/// caches, and the system gives their pages once; with half of it, borders cost more than that
/// saves.
inline constexpr int kPictureTile = 256;

struct TileDemand {
  SampleAxis x;
  SampleAxis y;
  PixelRun crop_x;
  PixelRun crop_y;
  int tile = kPictureTile;  // side wanted, pixels
  int input_texels = 1;     // RGBA texels uploaded per cell
  int border = 0;           // cells of relief around the window
  int targets = 1;          // RGBA targets drawn
  int planes = 3;           // float planes of a strip
};

/// Tiles of the wanted side, smaller where the state's window would exceed 4096 cells a side or
/// 512 MiB (Mesa refuses textures over 1 GiB), the targets 1 GiB, or a strip 256 MiB.
TilePlan plan_tiles(const TileDemand& demand);

}  // namespace pentimento
