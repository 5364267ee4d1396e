#include "formats/exr/exr_writer.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfThreading.h>
#include <ImfTileDescription.h>
#include <ImfTiledOutputFile.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/base/thread_count.h"
#include "core/base/threads.h"
#include "formats/color/converted_file.h"
#include "formats/exr/chromaticities.h"
#include "formats/exr/stream.h"
#include "formats/exr/typed_attribute.h"
#include "formats/io/output_file.h"

namespace pentimento {

namespace {

constexpr int kTile = 256;  // pixels a side; also the rows that are compressed at once
constexpr float kLargestHalf = 65504.0f;

/// Rows of all channels as they are stored: [channel][y][x], half or float.
class StoredRows {
 public:
  StoredRows(int channels, int width, bool full_float)
      : channels_(channels), width_(width), sample_(full_float ? 4 : 2) {}

  void resize(int rows) {
    rows_ = rows;
    bytes_.resize(static_cast<std::size_t>(channels_) * static_cast<std::size_t>(rows) * pitch());
  }
  std::size_t pitch() const { return static_cast<std::size_t>(width_ * sample_); }
  char* row(int channel, int y) {
    return bytes_.data() + (static_cast<std::size_t>(channel) * static_cast<std::size_t>(rows_) +
                            static_cast<std::size_t>(y)) *
                               pitch();
  }
  /// Describes the rows, the first of them at `y0` of the picture.
  Imf::FrameBuffer frame(const std::vector<std::string>& names, int y0) {
    Imf::FrameBuffer buffer;
    for (int c = 0; c < channels_; ++c) {
      // OpenEXR addresses from row 0 of the picture, which may lie before our memory.
      char* origin =
          row(c, 0) - static_cast<std::ptrdiff_t>(y0) * static_cast<std::ptrdiff_t>(pitch());
      buffer.insert(names[static_cast<std::size_t>(c)],
                    Imf::Slice(sample_ == 4 ? Imf::FLOAT : Imf::HALF, origin,
                               static_cast<std::size_t>(sample_), pitch()));
    }
    return buffer;
  }
  /// Row by row, channel by channel: the same whatever the strips' heights.
  void hash_into(Sha256& hash, int rows) {
    for (int y = 0; y < rows; ++y)
      for (int c = 0; c < channels_; ++c) hash.update(row(c, y), pitch());
  }

 private:
  int channels_, width_, sample_;
  int rows_ = 0;
  std::vector<char> bytes_;
};

/// False if a value is not a number. Values beyond the range of half become its largest.
bool store_row(const float* in, int width, bool full_float, char* out) {
  bool numbers = true;
  auto* floats = reinterpret_cast<float*>(out);
  auto* halves = reinterpret_cast<half*>(out);
  for (int x = 0; x < width; ++x) {
    numbers = numbers && !std::isnan(in[x]);
    if (full_float)
      floats[x] = in[x];
    else
      halves[x] = half(std::clamp(in[x], -kLargestHalf, kLargestHalf));
  }
  return numbers;
}

bool is_tiled(const ExrOptions& options) {
  return std::max(options.width, options.height) > kLongestScanlineSide;
}

Imf::Header make_header(const ExrOptions& options) {
  Imf::Header header(options.width, options.height);
  // The last bits of a rendered float are noise: wavelet compression takes eight times as long and
  // saves a tenth. Empty layers compress well as runs.
  header.compression() = options.full_float ? Imf::RLE_COMPRESSION : Imf::PIZ_COMPRESSION;
  if (is_tiled(options)) header.setTileDescription(Imf::TileDescription(kTile, kTile));
  for (const std::string& name : options.channels)
    header.channels().insert(name, Imf::Channel(options.full_float ? Imf::FLOAT : Imf::HALF));
  Imf::addChromaticities(header, exr::chromaticities_of(options.profile));
  if (options.dpi > 0) Imf::addXDensity(header, static_cast<float>(options.dpi));
  for (const auto& [key, value] : options.provenance) {
    // A key that names one of OpenEXR's own attributes must not change it.
    const std::string name = header.find(key) == header.end() ? key : "pentimento." + key;
    header.insert(name, *exr::typed_attribute(value));
  }
  return header;
}

/// Writes bands of kTile rows as lines or tiles.
class ExrOutput {
 public:
  ExrOutput(Imf::OStream& stream, const ExrOptions& options, int threads) {
    const Imf::Header header = make_header(options);
    if (is_tiled(options)) {
      tiles_ = std::make_unique<Imf::TiledOutputFile>(stream, header, threads);
    } else {
      lines_ = std::make_unique<Imf::OutputFile>(stream, header, threads);
    }
  }
  /// Rows [y0, y0 + rows); y0 is a multiple of kTile.
  void write(const Imf::FrameBuffer& buffer, int y0, int rows) {
    if (lines_) {
      lines_->setFrameBuffer(buffer);
      lines_->writePixels(rows);
    } else {
      tiles_->setFrameBuffer(buffer);
      tiles_->writeTiles(0, tiles_->numXTiles() - 1, y0 / kTile, y0 / kTile);
    }
  }

 private:
  std::unique_ptr<Imf::OutputFile> lines_;  // one of the two
  std::unique_ptr<Imf::TiledOutputFile> tiles_;
};

class ExrFile final : public PictureFile {
 public:
  ExrFile(std::string path, std::unique_ptr<OutputFile> file, const ExrOptions& options)
      : path_(std::move(path)),
        file_(std::move(file)),
        stream_(*file_, path_),
        names_(options.channels),
        width_(options.width),
        height_(options.height),
        full_float_(options.full_float),
        threads_(options.threads),
        output_(std::make_unique<ExrOutput>(stream_, options,
                                            threads_.count() > 1 ? threads_.count() : 0)),
        band_(static_cast<int>(names_.size()), width_, full_float_) {
    band_.resize(std::min(kTile, height_));
  }

  Result<void> write(const PictureStrip& strip) override;
  Result<Published> complete() override;
  Result<void> publish() override {
    if (const Result<Published> published = file_->publish(); !published) return published.error();
    return {};
  }

 private:
  /// Stores `rows` rows of the strip, from its row `from` on, below what the band has.
  Result<void> fill_band(const PictureStrip& strip, int from, int rows);
  Result<void> write_band();
  Result<void> check(const std::string& temporary) const;

  std::string path_;
  std::unique_ptr<OutputFile> file_;
  exr::FileStream stream_;
  std::vector<std::string> names_;
  int width_, height_;
  bool full_float_;
  Threads threads_;
  std::unique_ptr<ExrOutput> output_;
  StoredRows band_;
  int band_rows_ = 0;  // of it, filled
  Sha256 values_;      // of all that was handed over, as stored
  int rows_ = 0;       // taken so far
};

Result<void> ExrFile::fill_band(const PictureStrip& strip, int from, int rows) {
  const int channels = static_cast<int>(names_.size());
  std::vector<std::uint8_t> bad(static_cast<std::size_t>(rows), 0);
  threads_.for_rows(rows, [&](int y) {
    for (int c = 0; c < channels; ++c)
      if (!store_row(strip.plane[static_cast<std::size_t>(c)].row(from + y), width_, full_float_,
                     band_.row(c, band_rows_ + y)))
        bad[static_cast<std::size_t>(y)] = 1;
  });
  band_rows_ += rows;
  rows_ += rows;
  const auto first_bad = std::find(bad.begin(), bad.end(), 1);
  if (first_bad == bad.end()) return {};
  return Error{ErrorCode::kNonFinite,
               fmt::format("{}: the picture has a value that is not a number in row {}", path_,
                           strip.y0 + from + (first_bad - bad.begin()))};
}

Result<void> ExrFile::write_band() {
  const int y0 = rows_ - band_rows_;
  band_.hash_into(values_, band_rows_);
  try {
    output_->write(band_.frame(names_, y0), y0, band_rows_);
  } catch (const std::exception& error) {
    return Error{ErrorCode::kIo, path_ + ": " + error.what()};
  }
  band_rows_ = 0;
  return file_->status();
}

Result<void> ExrFile::write(const PictureStrip& strip) {
  PENTIMENTO_CHECK(strip.y0 == rows_ && strip.plane.size() == names_.size());
  PENTIMENTO_CHECK(strip.y0 + strip.rows <= height_);
  for (int from = 0; from < strip.rows;) {
    const int rows = std::min(strip.rows - from, kTile - band_rows_);
    if (Result<void> filled = fill_band(strip, from, rows); !filled) return filled;
    from += rows;
    if (band_rows_ < kTile && rows_ < height_) continue;
    if (Result<void> written = write_band(); !written) return written;
  }
  return {};
}

/// Decodes the whole file and compares it with what was handed over.
Result<void> ExrFile::check(const std::string& temporary) const {
  Sha256 decoded;
  try {
    Imf::InputFile input(temporary.c_str(), threads_.count() > 1 ? threads_.count() : 0);
    StoredRows rows(static_cast<int>(names_.size()), width_, full_float_);
    for (int y = 0; y < height_; y += kTile) {
      const int last = std::min(y + kTile, height_) - 1;
      rows.resize(last - y + 1);
      input.setFrameBuffer(rows.frame(names_, y));
      input.readPixels(y, last);
      rows.hash_into(decoded, last - y + 1);
    }
  } catch (const std::exception& error) {
    return Error{ErrorCode::kIo, path_ + ": reading back: " + error.what()};
  }
  if (decoded.hex() != values_.hex())
    return Error{ErrorCode::kIo, path_ + ": what was read back differs from what was written"};
  return {};
}

Result<Published> ExrFile::complete() {
  PENTIMENTO_CHECK(rows_ == height_);
  output_.reset();  // writes the table of offsets
  return file_->complete([this](const std::string& temporary) { return check(temporary); });
}

}  // namespace

namespace {
/// OpenEXR's pool serves the whole process; with none of its threads the caller compresses.
void share_compression(int threads) {
  if (threads <= 1 || threads <= Imf::globalThreadCount()) return;
  try {
    Imf::setGlobalThreadCount(threads);
  } catch (const std::exception&) {
    Imf::setGlobalThreadCount(0);  // the machine gives no more threads
  }
}
}  // namespace

Result<std::unique_ptr<PictureFile>> create_exr(const std::string& path,
                                                const ExrOptions& options) {
  PENTIMENTO_CHECK(options.width > 0 && options.height > 0 && !options.channels.empty());
  Result<std::unique_ptr<OutputFile>> file = OutputFile::create(path, options.no_clobber);
  if (!file) return file.error();
  if ((*file)->is_stream())
    return Error{ErrorCode::kUsage, path + ": an EXR cannot be written to a pipe or a device"};
  share_compression(wanted_threads(options.threads));
  try {
    return convert_light(std::make_unique<ExrFile>(path, std::move(*file), options),
                         options.profile, options.channels, options.threads);
  } catch (const std::exception& error) {
    return Error{ErrorCode::kIo, path + ": " + error.what()};
  }
}

}  // namespace pentimento
