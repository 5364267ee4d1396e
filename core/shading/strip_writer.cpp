#include "core/shading/strip_writer.h"

#include <utility>

namespace pentimento {

StripWriter::StripWriter(const StripPlanes& source, int width, int rows,
                         std::vector<PictureSink*> sinks, bool beside)
    : source_(source), sinks_(std::move(sinks)), buffers_(beside ? 2 : 1) {
  for (StripRows& buffer : buffers_)
    for (std::size_t i = 0; i < source_.planes.size(); ++i) buffer.emplace_back(width, rows);
}

void StripWriter::take(int index, const PixelRun& columns, int rows,
                       std::span<const float> texels) {
  StripRows& buffer = buffers_[filling_];
  for (std::size_t i = 0; i < buffer.size(); ++i) {
    const PlaneSource& plane = source_.planes[i];
    const int target = source_.variant.target[static_cast<std::size_t>(plane.kind)];
    if (target + plane.part != index) continue;
    const float* in = texels.data() + plane.component;
    for (int y = 0; y < rows; ++y) {
      float* out = buffer[i].row(y) + columns.first;
      for (int x = 0; x < columns.count; ++x, in += 4) out[x] = *in;
    }
  }
}

PictureStrip StripWriter::strip(const StripRows& buffer, int y0, int rows) const {
  PictureStrip strip{y0, rows, {}, {}};
  for (std::size_t i = 0; i < buffer.size(); ++i) {
    strip.name.push_back(source_.planes[i].name);
    strip.plane.push_back(buffer[i].view().window(0, 0, buffer[i].width(), rows));
  }
  return strip;
}

Result<void> StripWriter::write(const PictureStrip& strip) const {
  for (PictureSink* sink : sinks_)
    if (auto written = sink->write(strip); !written) return written;
  return {};
}

Result<void> StripWriter::hand_on(int y0, int rows) {
  if (auto before = finish(); !before) return before;
  const StripRows& filled = buffers_[filling_];
  if (buffers_.size() == 1) return written_ = write(strip(filled, y0, rows));
  filling_ = 1 - filling_;
  work_.begin([this, &filled, y0, rows] { written_ = write(strip(filled, y0, rows)); });
  return {};
}

Result<void> StripWriter::finish() {
  work_.wait();
  return written_;
}

}  // namespace pentimento
