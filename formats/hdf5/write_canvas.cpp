#include "formats/hdf5/write_canvas.h"

#include "formats/hdf5/chunked.h"
#include "formats/hdf5/handle.h"
#include "formats/hdf5/layout.h"
#include "formats/hdf5/write_small.h"

namespace pentimento::hdf5 {

bool write_canvas(hid_t file, const CanvasSource& canvas, const CanvasWriting& how,
                  const Threads& threads) {
  for (const CanvasDataset& what : kCanvasDatasets) {
    RowSource source;
    source.shape = shape_of(shape_of(canvas), what);
    source.copy = [&](std::int64_t row, int x, std::span<std::uint32_t> out) {
      copy_cells(canvas, what, row, x, out);
    };
    source.chunk_side = how.chunk_side;
    source.cancelled = how.cancelled;
    if (what.is_paint) source.zero = [&](const CellWindow& part) { return canvas.empty(part); };
    const hid_t type = what.is_integer ? H5T_NATIVE_UINT32 : H5T_NATIVE_FLOAT;
    const Handle dataset(
        write_chunked(file, how.group + what.name, type, source, how.deflate_level, threads),
        H5Dclose);
    if (!dataset.ok() || !describe(dataset.id(), what.units, what.long_name)) return false;
  }
  return true;
}

}  // namespace pentimento::hdf5
