#include "core/shading/light_lock.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace pentimento {
namespace {
// Enough for 32 dB in every sample. Wider limits come nearer to the tablet's picture, and draw the
// staircase of its cells into ridges that the finer canvas has smooth.
constexpr float kLeastGain = 0.6f, kMostGain = 1 / 0.6f;
constexpr int kCellsPerTask = 64;
constexpr int kBatchRows = 128;  // handed on at once: sinks work on rows in parallel

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Cells that the pixels depend on.
PixelRun widened(const GainAxis& axis, const PixelRun& pixels) {
  const int first = std::max(0, axis.cell_of(pixels.first) - LightLock::kReach);
  const int last =
      std::min(axis.cells - 1, axis.cell_of(pixels.first + pixels.count - 1) + LightLock::kReach);
  return {first, last + 1 - first};
}
}  // namespace

LightLockFrame light_lock_frame(const ShadeRequest& request, int cells_x, int cells_y) {
  LightLockFrame frame;
  frame.x = {cells_x, request.width};
  frame.y = {cells_y, request.height};
  const bool crop = request.crop_width > 0;
  frame.columns = crop ? PixelRun{request.crop_x, request.crop_width} : PixelRun{0, request.width};
  frame.rows = crop ? PixelRun{request.crop_y, request.crop_height} : PixelRun{0, request.height};
  frame.cell_columns = widened(frame.x, frame.columns);
  frame.cell_rows = widened(frame.y, frame.rows);
  return frame;
}

ShadeRequest with_border(const ShadeRequest& request, const LightLockFrame& frame) {
  const PixelRun x = GainLine(frame.x, frame.cell_columns).pixel_run;
  const PixelRun y = GainLine(frame.y, frame.cell_rows).pixel_run;
  ShadeRequest wider = request;
  wider.crop_x = x.first;
  wider.crop_y = y.first;
  wider.crop_width = x.count;
  wider.crop_height = y.count;
  return wider;
}

LightLock::LightLock(const LightLockFrame& frame, const LightPlanes& light, const Threads& threads,
                     std::vector<PictureSink*> sinks)
    : frame_(frame),
      light_(light),
      threads_(threads),
      sinks_(std::move(sinks)),
      across_(frame.x, frame.cell_columns),
      down_(frame.y, frame.cell_rows),
      moments_(3 * kGainMoments * across_.cells(), kRounds + 1),
      mean_(3 * across_.cells(), kKept) {
  for (CellRows& gain : gain_) gain = CellRows(3 * across_.cells(), kKept, 1.0f);
}

Result<void> LightLock::write(const PictureStrip& strip) {
  if (names_.empty()) {
    names_ = strip.name;
    for (std::size_t p = 0; p < names_.size(); ++p)
      batch_.emplace_back(frame_.columns.count, std::min(kBatchRows, frame_.rows.count));
  }
  for (int y = 0; y < strip.rows; ++y) {
    take(strip, y);
    // A row of cells is complete: every round goes on by one row of cells.
    if (arrived_ < down_.begin[at(std::min(ticks_, down_.cells() - 1) + 1)]) continue;
    if (auto done = tick(ticks_++); !done) return done;
  }
  if (arrived_ < down_.pixel_run.count) return {};
  while (ticks_ < down_.cells() + kReach)
    if (auto done = tick(ticks_++); !done) return done;
  return {};
}

void LightLock::take(const PictureStrip& strip, int row) {
  std::vector<float>& line = pixels_.emplace_back();
  line.reserve(at(strip.plane.front().width()) * strip.plane.size());
  for (const FieldView<const float>& plane : strip.plane)
    line.insert(line.end(), plane.row(row), plane.row(row) + plane.width());
  ++arrived_;
}

/// Each round follows the one before at a distance of one row of cells, for it looks at the rows
/// above and below.
Result<void> LightLock::tick(int t) {
  const auto there = [&](int y) { return y >= 0 && y < down_.cells(); };
  if (there(t)) find_moments(t);
  for (int round = 0; round < kRounds; ++round)
    if (there(t - round)) refine(t - round, round);
  if (const int y = t - kRounds; there(y)) find_means(y, gain_[kRounds], row(mean_, y));
  if (const int y = t - kRounds - 1; there(y)) refine_around(y);
  if (const int y = t - kReach; there(y)) return finish_cells(y);
  return {};
}

GainRows LightLock::gains(CellRows& rows, int y, int colour) const {
  GainRows out{};
  for (int n = 0; n < 3; ++n)
    out[at(n)] = row(rows, std::clamp(y + n - 1, 0, down_.cells() - 1)) + colour * across_.cells();
  return out;
}

/// What the mean light of a row of cells depends on, for all rounds.
void LightLock::find_moments(int y) {
  const int begin = down_.begin[at(y)], end = down_.begin[at(y) + 1];
  threads_.for_ranges(0, across_.cells(), kCellsPerTask, [&](int first, int last) {
    std::vector<const float*> rows(at(end - begin));
    for (int colour = 0; colour < 3; ++colour) {
      for (int p = begin; p < end; ++p)
        rows[at(p - begin)] =
            pixels_[at(p - dropped_)].data() + std::ptrdiff_t{colour} * across_.pixel_run.count;
      find_gain_moments(across_, first, last, rows, &down_.weight[at(begin)], moments(y, colour));
    }
  });
}

/// Mean light of a row of cells under a gain.
void LightLock::find_means(int y, CellRows& gain, float* mean) {
  const int rows = down_.begin[at(y) + 1] - down_.begin[at(y)], cells = across_.cells();
  for (int colour = 0; colour < 3; ++colour, mean += cells) {
    sum_under_gain(moments(y, colour), cells, gains(gain, y, colour), mean);
    for (int i = 0; i < cells; ++i) {
      const int columns = across_.begin[at(i) + 1] - across_.begin[at(i)];
      mean[i] /= static_cast<float>(columns * rows);
    }
  }
}

void LightLock::refine(int y, int round) {
  const float* was = row(gain_[at(round)], y);
  float* gain = row(gain_[at(round) + 1], y);
  find_means(y, gain_[at(round)], gain);
  for (int colour = 0; colour < 3; ++colour) {
    const float* wanted =
        light_[at(colour)].row(frame_.cell_rows.first + y) + frame_.cell_columns.first;
    for (int i = 0; i < across_.cells(); ++i) {
      const int c = colour * across_.cells() + i;
      gain[c] = std::clamp(was[c] * light_ratio(wanted[i], gain[c]), kLeastGain, kMostGain);
    }
  }
}

/// The last round, with means of 3 x 3 cells.
void LightLock::refine_around(int y) {
  const int cells = across_.cells();
  float* gain = row(gain_[kRounds + 1], y);
  const float* was = row(gain_[kRounds], y);
  for (int colour = 0; colour < 3; ++colour) {
    for (int i = 0; i < cells; ++i) {
      float wanted = 0, found = 0;
      for (int n = -1; n <= 1; ++n) {
        const int v = std::clamp(y + n, 0, down_.cells() - 1);
        for (int m = -1; m <= 1; ++m) {
          const int u = std::clamp(i + m, 0, cells - 1);
          wanted += light_[at(colour)](frame_.cell_columns.first + u, frame_.cell_rows.first + v);
          found += row(mean_, v)[colour * cells + u];
        }
      }
      gain[colour * cells + i] = was[colour * cells + i] * light_ratio(wanted / 9, found / 9);
    }
  }
}

Result<void> LightLock::finish_cells(int y) {
  const int begin = down_.begin[at(y)], end = down_.begin[at(y) + 1];
  threads_.for_ranges(begin, end, 1, [&](int from, int to) {
    for (int p = from; p < to; ++p) apply_gain(p, y);
  });
  for (int p = begin; p < end; ++p) {
    const int picture_row = down_.pixel_run.first + p - frame_.rows.first;
    if (picture_row >= 0 && picture_row < frame_.rows.count) {
      add_to_batch(pixels_.front());
      if (waiting_ == batch_.front().height() || done_ == frame_.rows.count)
        if (auto done = hand_on(); !done) return done;
    }
    pixels_.pop_front();
    ++dropped_;
  }
  return {};
}

/// The gain on a row of pixels.
void LightLock::apply_gain(int pixel_row, int cell_row) {
  const int width = across_.pixel_run.count;
  float* light = pixels_[at(pixel_row - dropped_)].data();
  std::vector<float> factor(at(width));
  for (int colour = 0; colour < 3; ++colour, light += width) {
    const GainRows rows = gains(gain_[kRounds + 1], cell_row, colour);
    for (int i = 0; i < across_.cells(); ++i)
      gain_pixels(across_, i, down_.weight[at(pixel_row)], rows, &factor[at(across_.begin[at(i)])]);
    for (int x = 0; x < width; ++x) light[x] *= factor[at(x)];
  }
}

/// What is asked for of a finished row.
void LightLock::add_to_batch(const std::vector<float>& line) {
  const float* from = line.data() + (frame_.columns.first - across_.pixel_run.first);
  for (Field<float>& plane : batch_) {
    std::copy_n(from, frame_.columns.count, plane.row(waiting_));
    from += across_.pixel_run.count;
  }
  ++waiting_;
  ++done_;
}

Result<void> LightLock::hand_on() {
  PictureStrip out{done_ - waiting_, waiting_, names_, {}};
  for (const Field<float>& plane : batch_)
    out.plane.push_back(plane.view().window(0, 0, plane.width(), waiting_));
  waiting_ = 0;
  for (PictureSink* sink : sinks_)
    if (auto written = sink->write(out); !written) return written;
  return {};
}

}  // namespace pentimento
