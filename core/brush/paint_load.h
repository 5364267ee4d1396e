#pragma once
// The load: the paint that a brush is dipped into (U of R22), in the form in which the reservoir
// holds it. It is one paint, or several side by side across the tip.

#include <span>
#include <vector>

namespace pentimento {

/// Texels of a reservoir over the tip's square: columns along the stroke, rows across it. There are
/// more rows, for across the stroke streaks differ.
inline constexpr int kReservoirColumns = 16;
inline constexpr int kReservoirRows = 32;
inline constexpr int kReservoirTexels = kReservoirColumns * kReservoirRows;

/// Reservoir height of a load, in films of one pass: with half the medium, 2 mm.
inline constexpr float kFilmsHeld = 2;

/// Rows [begin, end) of a reservoir: a part of the tip's width.
struct ReservoirRows {
  int begin = 0, end = 0;
};
inline constexpr ReservoirRows kAllRows = {0, kReservoirRows};
/// Those of the part [from, to] of the width, 0 the left side of a stroke and 1 the right; one row
/// at least. Needs 0 <= from <= to <= 1.
ReservoirRows rows_across(float from, float to);

struct PaintLoad {
  PaintLoad() = default;
  /// `paint`: height (m), then the amount of each channel. `amount`: share of each channel in the
  /// total amount (A26). `height_per_amount_m`: the height that an amount of 1 counts for in the
  /// volume.
  PaintLoad(std::span<const float> paint, std::span<const float> amount, float height_per_amount_m);

  std::vector<float> paint;   // height (m), amounts; padded with zeros to whole fours
  std::vector<float> weight;  // of each value of `paint` in the volume
  float volume_m = 0;         // of `paint`
  std::vector<float> rows;    // paint of each reservoir row; empty: all rows hold `paint`

  const float* row(int index) const {
    return rows.empty() ? paint.data()
                        : rows.data() + static_cast<std::size_t>(index) * paint.size();
  }
  /// Gives the rows [begin, end) the paint of `other`, which has as many channels and as much
  /// volume.
  void set_rows(const PaintLoad& other, int begin, int end);

  /// Volume of some paint: its height and its amounts counted as height, m. `paint_at` is padded
  /// like `paint`.
  float volume_of(const float* paint_at) const {
    float lane[4] = {0, 0, 0, 0};
    for (std::size_t k = 0; k < weight.size(); k += 4)
      for (std::size_t i = 0; i < 4; ++i) lane[i] += weight[k + i] * paint_at[k + i];
    return (lane[0] + lane[1]) + (lane[2] + lane[3]);
  }
  bool operator==(const PaintLoad&) const = default;
};

}  // namespace pentimento
