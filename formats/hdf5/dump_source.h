#pragma once
// The detail canvas of a dump, read from the file part by part, so that shading and comparing large
// pictures never hold all of it. For this folder only.

#include <hdf5.h>

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/canvas/canvas_source.h"
#include "formats/hdf5/handle.h"
#include "formats/hdf5/layout.h"
#include "formats/hdf5/read_canvas.h"

namespace pentimento::hdf5 {

class DumpSource final : public CanvasSource {
 public:
  /// `shape` is what canvas_shape() found in the file. Holds the file open, also when `from` is
  /// closed; keeps up to `cache_bytes` of it in memory. Errors: kBadInput.
  static Result<std::shared_ptr<const DumpSource>> open(const DumpFile& from,
                                                        const CanvasShape& shape,
                                                        const CanvasGeometry& geometry,
                                                        std::int64_t step, std::size_t cache_bytes);

  const CanvasGeometry& geometry() const override { return geometry_; }
  int layers() const override { return shape_.layers; }
  int channels() const override { return shape_.channels; }
  int bands() const override { return shape_.bands; }
  std::int64_t step() const override { return step_; }
  void read(PlaneId plane, int x, int y, std::span<float> out) const override;
  void read_strokes(int x, int y, std::span<std::uint32_t> out) const override;
  /// Error for the first part that could not be read or that has a value that is not finite or out
  /// of range.
  Result<void> status() const override;

 private:
  /// Dataset (index in kCanvasDatasets), plane within it, row and column of tiles.
  using Key = std::tuple<std::size_t, int, int, int>;
  struct ReadTile {
    std::vector<std::uint32_t> values;
    std::list<Key>::iterator age;
  };
  DumpSource(std::string path, const CanvasShape& shape, const CanvasGeometry& geometry,
             std::int64_t step, std::size_t cache_bytes)
      : path_(std::move(path)),
        shape_(shape),
        geometry_(geometry),
        step_(step),
        cache_bytes_(cache_bytes) {}
  const ReadTile& tile(const Key& key) const;
  bool load(const Key& key, std::vector<std::uint32_t>& values) const;
  void make_room() const;
  /// Values `value`, `value` + n, ... of the n that each cell has.
  void read_run(std::size_t dataset, int plane, int value, int x, int y,
                std::span<std::uint32_t> out) const;

  std::string path_;
  CanvasShape shape_;
  CanvasGeometry geometry_;
  std::int64_t step_;
  std::size_t cache_bytes_;
  Handle file_;
  std::vector<Handle> datasets_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::map<Key, ReadTile> tiles_;
  mutable std::list<Key> ages_;  // the latest used first
  mutable std::size_t held_bytes_ = 0;
  mutable std::optional<Error> problem_;
};

}  // namespace pentimento::hdf5
