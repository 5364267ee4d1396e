#include "core/shading/area_filter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pentimento {
namespace {

constexpr int kRowsAtOnce = 128;  // handed on at once: sinks work on rows in parallel

/// Length that source pixel s has in output pixel i, in units of 1 / to of a source pixel.
std::int64_t common(const AreaAxis& axis, int i, int s) {
  const std::int64_t from = axis.from, to = axis.to;
  const std::int64_t begin = std::max(s * to, i * from);
  const std::int64_t end = std::min((s + std::int64_t{1}) * to, (i + std::int64_t{1}) * from);
  return std::max<std::int64_t>(0, end - begin);
}

float weight(const AreaAxis& axis, int i, int s) {
  return static_cast<float>(static_cast<double>(common(axis, i, s)) / axis.from);
}

/// Of the planes of a vector, X, Y and Z in a row.
void make_unit(std::vector<Field<float>>& planes, std::size_t x, int row) {
  float *a = planes[x].row(row), *b = planes[x + 1].row(row), *c = planes[x + 2].row(row);
  for (int i = 0; i < planes[x].width(); ++i) {
    const float length = std::sqrt(a[i] * a[i] + b[i] * b[i] + c[i] * c[i]);
    a[i] /= length;
    b[i] /= length;
    c[i] /= length;
  }
}

}  // namespace

int AreaAxis::first_source(int begin) const {
  return static_cast<int>(std::int64_t{begin} * from / to);
}

int AreaAxis::last_source(int begin, int count) const {
  const std::int64_t end = (std::int64_t{begin} + count) * from;
  return static_cast<int>((end + to - 1) / to) - 1;
}

AreaFilter::AreaFilter(const AreaAxis& x, int x0, int columns, const AreaAxis& y, int y0, int rows,
                       std::vector<PictureSink*> sinks)
    : y_(y), y0_(y0), rows_(rows), sinks_(std::move(sinks)) {
  const int left = x.first_source(x0);
  for (int i = x0; i < x0 + columns; ++i) {
    begin_.push_back(shares_.size());
    for (int s = x.first_source(i); s <= x.last_source(i, 1); ++s)
      shares_.push_back({static_cast<std::size_t>(s - left), weight(x, i, s)});
  }
  begin_.push_back(shares_.size());
}

void AreaFilter::reduce_row(const PictureStrip& strip, int row) {
  const std::size_t columns = begin_.size() - 1;
  if (line_.empty()) {
    line_.assign(strip.plane.size(), std::vector<float>(columns));
    sum_ = line_;
    for (std::size_t p = 0; p < strip.plane.size(); ++p)
      batch_.emplace_back(static_cast<int>(columns), std::min(kRowsAtOnce, rows_));
  }
  for (std::size_t p = 0; p < strip.plane.size(); ++p) {
    const float* in = strip.plane[p].row(row);
    for (std::size_t i = 0; i < columns; ++i) {
      float sum = 0;
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
        sum += shares_[k].weight * in[shares_[k].source];
      line_[p][i] = sum;
    }
  }
}

void AreaFilter::add_line(float weight) {
  for (std::size_t p = 0; p < line_.size(); ++p)
    for (std::size_t i = 0; i < line_[p].size(); ++i) sum_[p][i] += weight * line_[p][i];
}

Result<void> AreaFilter::write(const PictureStrip& strip) {
  const int top = y_.first_source(y0_);
  for (int row = 0; row < strip.rows; ++row) {
    const int source = top + strip.y0 + row;
    reduce_row(strip, row);
    // A row of the larger picture lies on one or two of the smaller.
    while (done_ < rows_ && common(y_, y0_ + done_, source) > 0) {
      add_line(weight(y_, y0_ + done_, source));
      if (source < y_.last_source(y0_ + done_, 1)) break;
      if (Result<void> finished = finish_row(strip); !finished) return finished;
    }
  }
  return {};
}

Result<void> AreaFilter::finish_row(const PictureStrip& strip) {
  for (std::size_t p = 0; p < sum_.size(); ++p) {
    std::copy(sum_[p].begin(), sum_[p].end(), batch_[p].row(waiting_));
    std::fill(sum_[p].begin(), sum_[p].end(), 0.0f);
  }
  for (std::size_t p = 0; p < strip.name.size(); ++p)
    if (strip.name[p] == "normal.X") make_unit(batch_, p, waiting_);
  ++waiting_;
  ++done_;
  if (waiting_ < kRowsAtOnce && done_ < rows_) return {};
  return hand_on(strip);
}

Result<void> AreaFilter::hand_on(const PictureStrip& strip) {
  PictureStrip out{done_ - waiting_, waiting_, strip.name, {}};
  for (const Field<float>& plane : batch_)
    out.plane.push_back(plane.view().window(0, 0, plane.width(), waiting_));
  waiting_ = 0;
  for (PictureSink* sink : sinks_)
    if (Result<void> written = sink->write(out); !written) return written;
  return {};
}

}  // namespace pentimento
