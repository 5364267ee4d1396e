#pragma once
// A finer canvas's picture takes the light of the guide's: in every cell of the guide the mean
// light becomes what the tablet shows, and the finer canvas says how it is shared out inside the
// cell. As core/detail/lock does with the paint (ADR 19).

#include <array>
#include <deque>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/threads.h"
#include "core/shading/light_gain.h"
#include "core/shading/picture.h"
#include "core/shading/shader.h"

namespace pentimento {

/// Red, green and blue of a picture, whole.
using LightPlanes = std::array<Field<float>, 3>;

/// The picture that is asked for, and the one that must be shaded for it: crops have a border of
/// cells, on which the gain depends. `x.cells` <= `x.pixels`, and so for y.
struct LightLockFrame {
  GainAxis x, y;
  PixelRun columns, rows;            // what is asked for
  PixelRun cell_columns, cell_rows;  // what it depends on
};
/// `cells_x`, `cells_y`: size of the guide's picture.
LightLockFrame light_lock_frame(const ShadeRequest& request, int cells_x, int cells_y);
/// The request for the picture that the lock takes.
ShadeRequest with_border(const ShadeRequest& request, const LightLockFrame& frame);

/// Takes the strips of with_border(), hands on the strips of the request. Per colour:
///   P <- P G,  G: the spline of g (light_gain.h)
///   g = 1; four times: g <- g ratio(T, mean(P G)), within [0.6, 1/0.6]; then once with means of 3
///   x 3 cells;  T: the guide's light, mean: over the pixels of a cell
/// Scheme: multiplicative deconvolution (Richardson, J. Opt. Soc. Am. 62 (1972) 55-59; Lucy 1974),
/// cut short. Stable: gains are bounded, light stays >= 0. Departs from it: without the second
/// blur; the last round corrects the mean light of a neighbourhood, which the limits of the others
/// bias. AOVs pass as they are. A pixel depends on the cells within kReach of its own, and not on
/// the crop.
class LightLock : public PictureSink {
 public:
  static constexpr int kRounds = 4;           // of one cell each
  static constexpr int kReach = kRounds + 2;  // cells
  /// `light`: of the whole canvas, a value per cell. All references must outlive the lock.
  LightLock(const LightLockFrame& frame, const LightPlanes& light, const Threads& threads,
            std::vector<PictureSink*> sinks);
  Result<void> write(const PictureStrip& strip) override;

 private:
  /// Three colours beside each other in a row; row y is row y % kKept.
  using CellRows = Field<float>;
  static constexpr int kKept = 4;

  float* row(CellRows& rows, int y) const { return rows.row(y % kKept); }
  GainRows gains(CellRows& rows, int y, int colour) const;
  void take(const PictureStrip& strip, int row);
  Result<void> tick(int t);
  float* moments(int y, int colour) {
    return moments_.row(y % moments_.height()) +
           std::ptrdiff_t{colour} * kGainMoments * across_.cells();
  }
  void find_moments(int y);
  void find_means(int y, CellRows& gain, float* mean);
  void refine(int y, int round);
  void refine_around(int y);
  Result<void> finish_cells(int y);
  void apply_gain(int pixel_row, int cell_row);
  void add_to_batch(const std::vector<float>& line);
  Result<void> hand_on();

  const LightLockFrame frame_;
  const LightPlanes& light_;
  const Threads& threads_;
  const std::vector<PictureSink*> sinks_;
  const GainLine across_, down_;
  std::vector<std::string> names_;
  std::deque<std::vector<float>> pixels_;  // rows that arrived and are not finished, plane by plane
  int arrived_ = 0, dropped_ = 0;          // rows of pixels
  int ticks_ = 0;
  Field<float> moments_;                    // a ring of rows of cells, for all rounds
  std::array<CellRows, kRounds + 2> gain_;  // 1 everywhere; after each round
  CellRows mean_;                           // before the last round
  std::vector<Field<float>> batch_;         // per plane: rows not yet handed on
  int waiting_ = 0, done_ = 0;              // of them; of the rows asked for
};

}  // namespace pentimento
