#pragma once
// A picture reduced by area means, strip by strip: every output pixel is the mean of the light that
// falls on its area, cells at its border counted by their share. Linear light, so a mean of light.

#include <vector>

#include "core/shading/picture.h"

namespace pentimento {

/// One axis: `from` pixels become `to`, to <= from, both from edge to edge.
struct AreaAxis {
  int from = 1;
  int to = 1;
  /// Whole source pixels [first, last] that output pixels [begin, begin + count) lie on.
  int first_source(int begin) const;
  int last_source(int begin, int count) const;
};

/// Takes strips of rows of the larger picture, beginning with the row in which the first output row
/// begins, and hands on strips of the smaller picture.
///   out_i = sum_s |[s, s+1) n [i r, (i+1) r)| in_s / r,   r = from / to
/// Scheme: exact for piecewise constant pixels. Stable: a mean with weights in [0,1].
/// Source: box filter. Departs from it: means of "normal" planes are made unit vectors again.
class AreaFilter : public PictureSink {
 public:
  /// Output rows [y0, y0 + rows) and columns [x0, x0 + columns); the strips that come have the
  /// source columns from x.first_source(x0) to x.last_source(x0, columns). `sinks` outlive it.
  AreaFilter(const AreaAxis& x, int x0, int columns, const AreaAxis& y, int y0, int rows,
             std::vector<PictureSink*> sinks);
  Result<void> write(const PictureStrip& strip) override;

 private:
  struct Share {
    std::size_t source = 0;  // column of the strips that come
    float weight = 0;
  };
  void reduce_row(const PictureStrip& strip, int row);
  void add_line(float weight);
  Result<void> finish_row(const PictureStrip& strip);
  Result<void> hand_on(const PictureStrip& strip);

  AreaAxis y_;
  int y0_, rows_;
  std::vector<PictureSink*> sinks_;
  std::vector<std::size_t> begin_;  // of each output column's shares; one more at the end
  std::vector<Share> shares_;
  std::vector<std::vector<float>> line_;  // per plane: a source row, reduced across
  std::vector<std::vector<float>> sum_;   // per plane: of the output row in progress
  std::vector<Field<float>> batch_;       // per plane: rows not yet handed on
  int waiting_ = 0;                       // of them
  int done_ = 0;                          // output rows finished
};

}  // namespace pentimento
