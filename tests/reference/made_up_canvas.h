#pragma once
// A canvas of any size that is nowhere stored: every value is a function of where it is. Paint lies
// in some squares of 64 cells; the rest is bare. For tests of what streams canvases.

#include <algorithm>
#include <cmath>

#include "core/canvas/canvas_source.h"

namespace pentimento::reference {

class MadeUpCanvas : public CanvasSource {
 public:
  MadeUpCanvas(const CanvasGeometry& geometry, int layers, int channels)
      : geometry_(geometry), layers_(layers), channels_(channels) {}
  const CanvasGeometry& geometry() const override { return geometry_; }
  int layers() const override { return layers_; }
  int channels() const override { return channels_; }
  int bands() const override { return 3; }
  std::int64_t step() const override { return 5692; }

  static constexpr int kSquare = 64;
  static bool painted(int x, int y) { return (x / kSquare * 7 + y / kSquare * 3) % 5 < 2; }
  static std::uint32_t noise(int x, int y, std::uint32_t salt) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^
                      static_cast<std::uint32_t>(y) * 0x85EBCA77u ^ salt * 0xC2B2AE3Du;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    return h ^ h >> 12;
  }
  static float unit(int x, int y, std::uint32_t salt) {
    return static_cast<float>(noise(x, y, salt) % 4096) / 4095.0f;
  }
  /// Strokes with bristle marks: soft along x, fine along y.
  float value(PlaneId plane, int x, int y) const {
    const auto salt = static_cast<std::uint32_t>(plane.kind) * 100 +
                      static_cast<std::uint32_t>(plane.layer * 10 + plane.index);
    const float grain = unit(x / 8, y, salt);
    switch (plane.kind) {
      case PlaneKind::kReflectance:
        return 0.9f - 0.05f * unit(x, y, 7);
      case PlaneKind::kPaper:
        return 1e-4f * unit(x / 3, y / 3, 1);
      case PlaneKind::kBase:
        return 1e-4f * unit(x / 3, y / 3, 1) + (y % 3 == 0 ? 2e-5f * grain : 0.0f);
      case PlaneKind::kDepth:
        return painted(x, y) ? 5e-4f * (0.5f + grain) : 0.0f;
      case PlaneKind::kPigment:
        return painted(x, y) ? 0.02f * grain : 0.0f;
      default:
        return painted(x, y) ? 0.1f * (grain - 0.5f) : 0.0f;
    }
  }
  void read(PlaneId plane, int x, int y, std::span<float> out) const override {
    for (float& v : out) v = value(plane, x++, y);
  }
  void read_strokes(int x, int y, std::span<std::uint32_t> out) const override {
    for (std::uint32_t& v : out) {
      v = painted(x, y) ? 1 + noise(x / kSquare, y / kSquare, 3) % 9 : 0;
      ++x;
    }
  }
  bool empty(const CellWindow& w) const override {
    for (int y = w.y; y < w.y + w.height; y = (y / kSquare + 1) * kSquare)
      for (int x = w.x; x < w.x + w.width; x = (x / kSquare + 1) * kSquare)
        if (painted(x, y)) return false;
    return true;
  }

 private:
  CanvasGeometry geometry_;
  int layers_, channels_;
};

}  // namespace pentimento::reference
