#include "formats/png/png_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/threads.h"
#include "formats/io/deflate.h"
#include "formats/io/output_file.h"
#include "formats/png/chunks.h"
#include "formats/png/filter.h"

namespace pentimento {

namespace {

using png::PngBytes;

constexpr int kLargestSide = 1'000'000;  // libpng, and so most programs, read no more
// A block of rows is deflated alone, so its size decides the bytes: it must not depend on the
// number of threads or on how the strips come.
constexpr std::size_t kBlockBytes = std::size_t{1} << 20;
constexpr int kDeflateLevel = 1;

/// One block: its rows filtered and deflated.
struct DeflateBlock {
  PngBytes deflated;
  std::uint32_t adler = 1;
  std::size_t bytes = 0;  // before deflating
};

/// Row `y` of the strip's first planes as 16-bit codes, high byte first.
bool encode_numbers(const NumberScale& scale, const PictureStrip& strip, int y, std::uint8_t* out) {
  constexpr double kLargestCode = 65535;
  bool numbers = true;
  for (int x = 0; x < strip.plane[0].width(); ++x) {
    for (int c = 0; c < scale.channels; ++c) {
      const auto value = static_cast<double>(strip.plane[static_cast<std::size_t>(c)](x, y));
      if (std::isnan(value)) numbers = false;
      // fmin and fmax return the number if the other argument is NaN.
      const double code =
          std::fmin(std::fmax((value - scale.offset) / scale.per_code + 0.5, 0), kLargestCode);
      const auto whole = static_cast<unsigned>(code);
      *out++ = static_cast<std::uint8_t>(whole >> 8);
      *out++ = static_cast<std::uint8_t>(whole);
    }
  }
  return numbers;
}

class PngFile final : public PictureFile {
 public:
  PngFile(std::string path, std::unique_ptr<OutputFile> file, const PngOptions& options)
      : path_(std::move(path)),
        file_(std::move(file)),
        width_(options.width),
        height_(options.height),
        channels_(options.numbers ? options.numbers->channels : 3),
        sample_bytes_(options.bit_depth / 8),
        row_bytes_(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(channels_) *
                   static_cast<std::size_t>(sample_bytes_)),
        rows_per_block_(std::max(1, static_cast<int>(kBlockBytes / row_bytes_))),
        encoder_(options.color, options.bit_depth),
        numbers_(options.numbers),
        threads_(options.threads),
        pending_(row_bytes_, 0) {}

  Result<void> begin(const PngOptions& options);
  Result<void> write(const PictureStrip& strip) override;
  Result<Published> complete() override;
  Result<void> publish() override {
    if (const Result<Published> published = file_->publish(); !published) return published.error();
    return {};
  }

 private:
  bool encode_row(const PictureStrip& strip, int y, std::uint8_t* out) const;
  DeflateBlock deflate_rows(int begin, int end, bool last) const;
  void write_block(DeflateBlock& block, bool last);
  void deflate_whole_blocks();
  const std::uint8_t* pending_row(int y) const {
    return pending_.data() + static_cast<std::size_t>(y + 1) * row_bytes_;
  }

  std::string path_;
  std::unique_ptr<OutputFile> file_;
  int width_, height_;
  int channels_;
  int sample_bytes_;
  std::size_t row_bytes_;
  int rows_per_block_;
  RowEncoder encoder_;
  std::optional<NumberScale> numbers_;
  Threads threads_;
  PngBytes pending_;  // the row before (zeros at the start), then the rows not yet deflated
  int pending_rows_ = 0;
  int rows_ = 0;  // taken so far
  std::uint32_t adler_ = 1;
  bool first_block_ = true;
};

Result<void> PngFile::begin(const PngOptions& options) {
  png::Head facts = {options.width, options.height, options.bit_depth, channels_, {}, options.dpi};
  if (!options.numbers) facts.profile = options.color.profile;
  const Result<PngBytes> head = png::file_head(facts, options.provenance);
  if (!head) return head.error();
  file_->write(head->data(), head->size());
  return file_->status();
}

Result<void> PngFile::write(const PictureStrip& strip) {
  PENTIMENTO_CHECK(strip.y0 == rows_);
  PENTIMENTO_CHECK(strip.plane.size() >= static_cast<std::size_t>(channels_));
  PENTIMENTO_CHECK(strip.y0 + strip.rows <= height_ && strip.plane[0].width() == width_);
  const int before = pending_rows_;
  pending_rows_ += strip.rows;
  rows_ += strip.rows;
  pending_.resize(static_cast<std::size_t>(pending_rows_ + 1) * row_bytes_);
  std::vector<std::uint8_t> bad(static_cast<std::size_t>(strip.rows), 0);
  threads_.for_rows(strip.rows, [&](int y) {
    std::uint8_t* out = pending_.data() + static_cast<std::size_t>(before + y + 1) * row_bytes_;
    bad[static_cast<std::size_t>(y)] = encode_row(strip, y, out) ? 0 : 1;
  });
  const auto first_bad = std::find(bad.begin(), bad.end(), 1);
  if (first_bad != bad.end())
    return Error{ErrorCode::kNonFinite,
                 fmt::format("{}: the picture has a value that is not a number in row {}", path_,
                             strip.y0 + (first_bad - bad.begin()))};
  deflate_whole_blocks();
  return file_->status();
}

/// False if a value is not a number.
bool PngFile::encode_row(const PictureStrip& strip, int y, std::uint8_t* out) const {
  if (numbers_) return encode_numbers(*numbers_, strip, y, out);
  const RgbRow row = {strip.plane[0].row(y), strip.plane[1].row(y), strip.plane[2].row(y)};
  return encoder_.encode(row, width_, strip.y0 + y, out);
}

DeflateBlock PngFile::deflate_rows(int begin, int end, bool last) const {
  PngBytes filtered(static_cast<std::size_t>(end - begin) * (row_bytes_ + 1));
  PngBytes scratch(4 * row_bytes_);
  for (int y = begin; y < end; ++y)
    png::filter_row({pending_row(y), row_bytes_}, {pending_row(y - 1), row_bytes_},
                    channels_ * sample_bytes_, scratch,
                    filtered.data() + static_cast<std::size_t>(y - begin) * (row_bytes_ + 1));
  DeflateBlock block;
  block.bytes = filtered.size();
  block.adler = adler32_of(filtered);
  deflate_piece(filtered, last, kDeflateLevel, Repeats::kRuns, block.deflated);
  return block;
}

void PngFile::write_block(DeflateBlock& block, bool last) {
  PngBytes data;
  data.reserve(block.deflated.size() + 6);
  if (first_block_) data.insert(data.end(), {0x78, 0x01});  // zlib: deflate, 32 KiB, fastest
  first_block_ = false;
  data.insert(data.end(), block.deflated.begin(), block.deflated.end());
  adler_ = adler32_joined(adler_, block.adler, block.bytes);
  for (int shift = 24; last && shift >= 0; shift -= 8)
    data.push_back(static_cast<std::uint8_t>(adler_ >> shift));
  const PngBytes whole = png::chunk("IDAT", data);
  file_->write(whole.data(), whole.size());
}

void PngFile::deflate_whole_blocks() {
  const int count = pending_rows_ / rows_per_block_;
  if (count == 0) return;
  std::vector<DeflateBlock> blocks(static_cast<std::size_t>(count));
  threads_.for_ranges(0, count, 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      blocks[static_cast<std::size_t>(i)] =
          deflate_rows(i * rows_per_block_, (i + 1) * rows_per_block_, false);
  });
  for (DeflateBlock& block : blocks) write_block(block, false);
  // Keep the last deflated row: the next one is filtered against it.
  const std::size_t done = static_cast<std::size_t>(count * rows_per_block_) * row_bytes_;
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(done));
  pending_rows_ -= count * rows_per_block_;
}

Result<Published> PngFile::complete() {
  PENTIMENTO_CHECK(rows_ == height_);
  DeflateBlock rest = deflate_rows(0, pending_rows_, true);
  write_block(rest, true);
  const PngBytes end = png::chunk("IEND", {});
  file_->write(end.data(), end.size());
  return file_->complete();
}

}  // namespace

Result<std::unique_ptr<PictureFile>> create_png(const std::string& path,
                                                const PngOptions& options) {
  PENTIMENTO_CHECK(options.width > 0 && options.height > 0);
  PENTIMENTO_CHECK(options.bit_depth == 8 || options.bit_depth == 16);
  PENTIMENTO_CHECK(!options.numbers || options.bit_depth == 16);
  if (options.width > kLargestSide || options.height > kLargestSide)
    return Error{ErrorCode::kLimit, fmt::format("{}: {} x {} pixels, a PNG side ends at {}", path,
                                                options.width, options.height, kLargestSide)};
  Result<std::unique_ptr<OutputFile>> file = OutputFile::create(path, options.no_clobber);
  if (!file) return file.error();
  auto png_file = std::make_unique<PngFile>(path, std::move(*file), options);
  if (const Result<void> begun = png_file->begin(options); !begun) return begun.error();
  return std::unique_ptr<PictureFile>(std::move(png_file));
}

}  // namespace pentimento
