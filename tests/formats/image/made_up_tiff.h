#pragma once
// TIFFs as libtiff writes them.

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace pentimento::test {

struct TiffShape {
  int width = 20, height = 13, samples = 3;
  int bits = 8;
  int format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_RGB;
  int planar = PLANARCONFIG_CONTIG, compression = COMPRESSION_NONE;
  int orientation = ORIENTATION_TOPLEFT;
  int tile = 0;  // pixels a side, 0: strips of five rows
  bool big_endian = false;
};

/// The stored number of the sample c of the pixel (x, y).
using TiffSample = std::function<double(int x, int y, int c)>;

/// Numbers that differ from one another, over the whole range of the format.
inline double made_up_sample(const TiffShape& shape, int x, int y, int c) {
  const int number = (x * 31 + y * 17 + c * 101) % 251;
  if (shape.format == SAMPLEFORMAT_IEEEFP) return number * 0.37 - 20;
  return shape.bits == 16 ? number * 257 + 3 : number;
}

inline void put_number(const TiffShape& shape, double number, std::uint8_t* to) {
  const auto put = [to](auto value) { std::memcpy(to, &value, sizeof(value)); };
  if (shape.bits == 8) return put(static_cast<std::uint8_t>(number));
  if (shape.bits == 16) return put(static_cast<std::uint16_t>(std::max(0.0, number)));
  if (shape.bits == 32) return put(static_cast<float>(number));
  put(number);
}

inline void write_tiff(const std::string& path, const TiffShape& s, const TiffSample& sample) {
  TIFF* tiff = TIFFOpen(path.c_str(), s.big_endian ? "wb" : "wl");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, s.width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, s.height);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, s.samples);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, s.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, s.format);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, s.photometric);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, s.planar);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, s.compression);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, s.orientation);
  const std::uint16_t extra = EXTRASAMPLE_UNASSALPHA;
  if (s.samples == 2 || s.samples == 4) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &extra);
  const int side = s.tile > 0 ? s.tile : s.width, rows = s.tile > 0 ? s.tile : 5;
  if (s.tile > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, s.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, s.tile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rows);
  }
  const int planes = s.planar == PLANARCONFIG_SEPARATE ? s.samples : 1;
  const int together = s.samples / planes, bytes = s.bits / 8;
  std::vector<std::uint8_t> piece;
  for (int plane = 0; plane < planes; ++plane)
    for (int y0 = 0; y0 < s.height; y0 += rows)
      for (int x0 = 0; x0 < s.width; x0 += side) {
        const int high = s.tile > 0 ? rows : std::min(rows, s.height - y0);
        piece.assign(static_cast<std::size_t>(side * high * together * bytes), 0);
        for (int y = 0; y < std::min(high, s.height - y0); ++y)
          for (int x = 0; x < std::min(side, s.width - x0); ++x)
            for (int c = 0; c < together; ++c)
              put_number(s, sample(x0 + x, y0 + y, plane + c),
                         piece.data() + ((y * side + x) * together + c) * bytes);
        const auto size = static_cast<tmsize_t>(piece.size());
        const auto at = [&](int v) { return static_cast<std::uint32_t>(v); };
        const auto number = static_cast<std::uint16_t>(plane);
        if (s.tile > 0)
          TIFFWriteEncodedTile(tiff, TIFFComputeTile(tiff, at(x0), at(y0), 0, number), piece.data(),
                               size);
        else
          TIFFWriteEncodedStrip(tiff, TIFFComputeStrip(tiff, at(y0), number), piece.data(), size);
      }
  TIFFClose(tiff);
}

}  // namespace pentimento::test
