#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <utility>

#include "core/optics/srgb.h"
#include "formats/image/decode.h"
#include "formats/image/orientation.h"
#include "formats/image/tiff_file.h"

namespace pentimento::image {

namespace {

/// The planes of `channels` samples a pixel, without values yet.
void add_planes(Image& image, int channels) {
  static constexpr std::array<const char*, 2> kGrey = {"Y", "A"};
  static constexpr std::array<const char*, 4> kColour = {"R", "G", "B", "A"};
  for (int c = 0; c < channels; ++c) {
    const auto at = static_cast<std::size_t>(c);
    image.name.emplace_back(channels < 3 ? kGrey[at] : kColour[at]);
    image.plane.emplace_back(image.width, image.height);
  }
}

/// Stored samples, one after another, as values: whole numbers become 0..1.
template <typename Sample>
void take_samples(const std::uint8_t* bytes, std::size_t stride, double scale, bool inverted, int n,
                  float* out) {
  for (int i = 0; i < n; ++i) {
    Sample sample;
    std::memcpy(&sample, bytes + static_cast<std::size_t>(i) * stride * sizeof(Sample),
                sizeof(Sample));
    const double value = static_cast<double>(sample) * scale;
    out[i] = static_cast<float>(inverted ? 1 - value : value);
  }
}

void take_run(const TiffLayout& layout, const std::uint8_t* bytes, std::size_t stride, int n,
              float* out) {
  const bool inverted = layout.is_inverted();
  if (layout.bits == 8)
    return take_samples<std::uint8_t>(bytes, stride, 1.0 / 255, inverted, n, out);
  if (layout.bits == 16)
    return take_samples<std::uint16_t>(bytes, stride, 1.0 / 65535, inverted, n, out);
  if (layout.bits == 32) return take_samples<float>(bytes, stride, 1, inverted, n, out);
  take_samples<double>(bytes, stride, 1, inverted, n, out);
}

/// The pieces a TIFF is stored in: strips of whole rows, or tiles.
struct Pieces {
  bool tiled = false;
  std::uint32_t width = 0, height = 0;  // of one, pixels
  tmsize_t row_bytes = 0, bytes = 0;    // of one of its rows, of all
};

Result<Pieces> pieces_of(const TiffFile& file, const TiffLayout& layout) {
  TIFF* const tiff = file.handle();
  Pieces out;
  out.tiled = TIFFIsTiled(tiff) != 0;
  if (out.tiled) {
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &out.width);
    TIFFGetField(tiff, TIFFTAG_TILELENGTH, &out.height);
    out.row_bytes = TIFFTileRowSize(tiff);
    out.bytes = TIFFTileSize(tiff);
  } else {
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &out.height);
    out.width = layout.width;
    out.height = std::min(out.height, layout.height);
    out.row_bytes = TIFFScanlineSize(tiff);
    out.bytes = TIFFStripSize(tiff);
  }
  const tmsize_t samples = layout.is_separate() ? 1 : layout.samples;
  const tmsize_t row = tmsize_t{out.width} * samples * (layout.bits / 8);
  if (row == 0 || out.height == 0 || out.row_bytes != row ||
      out.bytes / row != tmsize_t{out.height})
    return file.problem("strips or tiles of no sensible size");
  if (out.bytes > TiffFile::kMostAtOnce)
    return Error{ErrorCode::kLimit, "strips or tiles of over 4 GB"};
  return out;
}

/// Unpacks the piece at (x0, y0) of the sample that comes first in it.
Result<void> read_piece(const TiffFile& file, const Pieces& pieces, std::uint32_t x0,
                        std::uint32_t y0, std::uint16_t sample, std::uint32_t rows,
                        std::vector<std::uint8_t>& piece) {
  TIFF* const tiff = file.handle();
  const tmsize_t needed = pieces.tiled ? pieces.bytes : tmsize_t{rows} * pieces.row_bytes;
  const tmsize_t got =
      pieces.tiled
          ? TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, x0, y0, 0, sample), piece.data(),
                                needed)
          : TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, y0, sample), piece.data(), needed);
  if (got < needed || file.has_problem()) return file.problem("cut short");
  return {};
}

/// Reads plane after plane, piece after piece.
Result<void> read_plain(const TiffFile& file, const TiffLayout& layout, Image& image) {
  const Result<Pieces> pieces = pieces_of(file, layout);
  if (!pieces) return pieces.error();
  add_planes(image, layout.samples);
  const std::size_t together = layout.is_separate() ? 1 : layout.samples;
  const std::size_t sample_bytes = layout.bits / 8;
  std::vector<std::uint8_t> piece(static_cast<std::size_t>(pieces->bytes));
  for (std::size_t first = 0; first < layout.samples; first += together)
    for (std::uint32_t y0 = 0; y0 < layout.height; y0 += pieces->height)
      for (std::uint32_t x0 = 0; x0 < layout.width; x0 += pieces->width) {
        const std::uint32_t rows = std::min(pieces->height, layout.height - y0);
        const int columns = static_cast<int>(std::min(pieces->width, layout.width - x0));
        const Result<void> read =
            read_piece(file, *pieces, x0, y0, static_cast<std::uint16_t>(first), rows, piece);
        if (!read) return read.error();
        for (std::uint32_t r = 0; r < rows; ++r) {
          const std::uint8_t* row = piece.data() + static_cast<tmsize_t>(r) * pieces->row_bytes;
          for (std::size_t c = 0; c < together; ++c)
            take_run(layout, row + c * sample_bytes, together, columns,
                     image.plane[first + c].row(static_cast<int>(y0 + r)) + x0);
        }
      }
  return {};
}

/// Palettes, inks, luminance with differences of colour, fewer than 8 bits: as libtiff converts
/// them.
Result<void> read_converted(const TiffFile& file, const TiffLayout& layout, Image& image) {
  struct Conversion {
    TIFFRGBAImage image = {};
    bool begun = false;
    ~Conversion() {
      if (begun) TIFFRGBAImageEnd(&image);
    }
  } conversion;
  std::array<char, 1024> why{};
  conversion.begun = TIFFRGBAImageBegin(&conversion.image, file.handle(), 1, why.data()) == 1;
  if (!conversion.begun) return file.problem(why.data());
  conversion.image.req_orientation = conversion.image.orientation;  // rows as they are stored
  add_planes(image, layout.is_grey() ? 1 : conversion.image.alpha != 0 ? 4 : 3);
  std::vector<std::uint32_t> codes(std::size_t{layout.width} * layout.height);
  if (TIFFRGBAImageGet(&conversion.image, codes.data(), layout.width, layout.height) != 1 ||
      file.has_problem())
    return file.problem("cut short");
  for (std::size_t c = 0; c < image.plane.size(); ++c)
    for (int y = 0; y < image.height; ++y) {
      const std::uint32_t* row = codes.data() + static_cast<std::size_t>(y) * layout.width;
      for (int x = 0; x < image.width; ++x)
        image.plane[c](x, y) = static_cast<float>((row[x] >> (8 * c) & 255) * (1.0 / 255));
    }
  return {};
}

void xyz_to_rgb(Image& image) {
  const ColorMatrix m = from_xyz(ColorProfile::kSrgb);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::array<double, 3> xyz{};
      for (std::size_t i = 0; i < 3; ++i) xyz[i] = static_cast<double>(image.plane[i](x, y));
      for (std::size_t i = 0; i < 3; ++i)
        image.plane[i](x, y) =
            static_cast<float>((m[i][0] * xyz[0] + m[i][1] * xyz[1]) + m[i][2] * xyz[2]);
    }
}

void decode_light(Image& image) {
  for (std::size_t c = 0; c < image.plane.size(); ++c) {
    if (image.name[c] == "A") continue;
    for (int y = 0; y < image.height; ++y)
      for (float& value : std::span(image.plane[c].row(y), static_cast<std::size_t>(image.width)))
        value = static_cast<float>(srgb_to_linear(static_cast<double>(value)));
  }
}

}  // namespace

Result<Image> decode_tiff(const std::string& path, const ImageReadOptions& options) {
  const auto named = [&path](const Error& error) {
    return Error{error.code, path + ": " + error.message};
  };
  Result<TiffFile> file = TiffFile::open(path);
  if (!file) return named(file.error());
  const Result<TiffLayout> layout = file->layout();
  if (!layout) return named(layout.error());
  const Result<void> fits = check_size(path, layout->width, layout->height, options.limits);
  if (!fits) return fits.error();
  Image image;
  image.format = "tiff";
  image.width = static_cast<int>(layout->width);
  image.height = static_cast<int>(layout->height);
  image.bits = layout->is_plain() ? layout->bits : 8;
  image.stored_float = layout->is_float();
  file->begin_unpacking();
  const Result<void> read = layout->is_plain() ? read_plain(*file, *layout, image)
                                               : read_converted(*file, *layout, image);
  if (!read) return named(read.error());
  if (layout->is_xyz()) xyz_to_rgb(image);
  for (Field<float>& plane : image.plane) plane = upright(std::move(plane), layout->orientation);
  image.width = image.plane[0].width();
  image.height = image.plane[0].height();
  if (!image.stored_float && options.meaning == SampleMeaning::kLight) decode_light(image);
  return image;
}

}  // namespace pentimento::image
