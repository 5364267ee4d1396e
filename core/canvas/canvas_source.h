#pragma once
// A canvas of any size, for reading, run by run of cells. Shading, dumps and comparisons use this
// interface, whether the planes are dense (StateSource), in tiles, or in a file. Every function may
// be called from several threads at once.

#include <cstdint>
#include <span>

#include "core/base/result.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

enum class PlaneKind {
  kDepth,        // m
  kVelocityX,    // m/s, x right
  kVelocityY,    // m/s, y down
  kBase,         // m
  kPaper,        // m
  kReflectance,  // of band `index`
  kPigment       // of channel `index` in `layer`
};

struct PlaneId {
  PlaneKind kind = PlaneKind::kDepth;
  int index = 0;
  int layer = 0;
  friend bool operator==(const PlaneId&, const PlaneId&) = default;
};

inline PlaneId reflectance_plane(int band) {
  return {PlaneKind::kReflectance, band, 0};
}
inline PlaneId pigment_plane(int layer, int channel) {
  return {PlaneKind::kPigment, channel, layer};
}

/// A part of the grid, in cells. It may reach beyond the grid's edges.
struct CellWindow {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

class CanvasSource {
 public:
  virtual ~CanvasSource() = default;
  virtual const CanvasGeometry& geometry() const = 0;
  virtual int layers() const = 0;
  virtual int channels() const = 0;
  virtual int bands() const = 0;
  virtual std::int64_t step() const = 0;
  /// Reads the cells x .. x + out.size() - 1 of row y, all of them on the grid. Units: those of
  /// PlaneKind.
  virtual void read(PlaneId plane, int x, int y, std::span<float> out) const = 0;
  virtual void read_strokes(int x, int y, std::span<std::uint32_t> out) const = 0;
  /// True only if depth, velocity and all pigments are 0 in the whole of `window`, which lies on
  /// the grid. A reader may then leave these cells out. False promises nothing.
  virtual bool empty(const CellWindow& window) const {
    static_cast<void>(window);
    return false;
  }
  /// Says that these planes will be read in `window`, which lies on the grid. A source that must
  /// fetch them may use `threads` for that.
  virtual void expect(const CellWindow& window, std::span<const PlaneId> planes,
                      const Threads& threads) const {
    static_cast<void>(window);
    static_cast<void>(planes);
    static_cast<void>(threads);
  }
  /// Ok, or the reason why a read() failed. A read() that failed gave zeros.
  virtual Result<void> status() const { return {}; }
};

/// The plane of `state` that `plane` names, neither paper nor reflectance, which are kept in other
/// ways. Its layer and channel must exist.
Field<float>& plane_of(CanvasState& state, PlaneId plane);
const Field<float>& plane_of(const CanvasState& state, PlaneId plane);

/// The dense planes of a state. `state` must outlive the source and must not change while it is
/// read.
class StateSource final : public CanvasSource {
 public:
  explicit StateSource(const CanvasState& state) : state_(state) {}
  const CanvasGeometry& geometry() const override { return state_.geometry; }
  int layers() const override { return state_.layers; }
  int channels() const override { return state_.channels; }
  int bands() const override { return state_.bands; }
  std::int64_t step() const override { return state_.step; }
  void read(PlaneId plane, int x, int y, std::span<float> out) const override;
  void read_strokes(int x, int y, std::span<std::uint32_t> out) const override;

 private:
  const CanvasState& state_;
};

}  // namespace pentimento
