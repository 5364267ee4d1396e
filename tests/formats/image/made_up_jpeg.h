#pragma once
// JPEGs of a made-up picture, written by libjpeg, for tests.

#include <cstdio>
#include <cstdlib>
// libjpeg's header needs what stands above.
#include <jpeglib.h>

#include <string>
#include <vector>

namespace pentimento::test {

struct JpegKind {
  int width = 45, height = 34;  // no multiples of a block
  J_COLOR_SPACE given = JCS_RGB;
  J_COLOR_SPACE stored = JCS_YCbCr;
  bool by_adobe = false;                // the mark of Adobe's programs
  bool progressive = false;             // in about ten scans
  std::vector<jpeg_scan_info> scans{};  // or these
  int restart_rows = 0;                 // 0: no marks to begin again at
  std::string exif{};                   // of the marker APP1
  J_DCT_METHOD transform = JDCT_ISLOW;
};

inline int channels_of(J_COLOR_SPACE colors) {
  switch (colors) {
    case JCS_GRAYSCALE:
      return 1;
    case JCS_UNKNOWN:
      return 2;  // what nobody has a name for
    case JCS_CMYK:
      return 4;
    default:
      return 3;
  }
}

inline std::string jpeg_of(const JpegKind& kind) {
  jpeg_compress_struct jpeg = {};
  jpeg_error_mgr messages = {};
  jpeg.err = jpeg_std_error(&messages);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long count = 0;
  jpeg_mem_dest(&jpeg, &bytes, &count);
  const int channels = channels_of(kind.given);
  jpeg.image_width = static_cast<JDIMENSION>(kind.width);
  jpeg.image_height = static_cast<JDIMENSION>(kind.height);
  jpeg.input_components = channels;
  jpeg.in_color_space = kind.given;
  jpeg_set_defaults(&jpeg);
  jpeg_set_colorspace(&jpeg, kind.stored);
  jpeg.write_Adobe_marker = kind.by_adobe ? TRUE : FALSE;
  jpeg.restart_in_rows = kind.restart_rows;
  jpeg.dct_method = kind.transform;
  if (kind.progressive) jpeg_simple_progression(&jpeg);
  if (!kind.scans.empty()) {
    jpeg.scan_info = kind.scans.data();
    jpeg.num_scans = static_cast<int>(kind.scans.size());
  }
  jpeg_start_compress(&jpeg, TRUE);
  if (!kind.exif.empty())
    jpeg_write_marker(&jpeg, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(kind.exif.data()),
                      static_cast<unsigned>(kind.exif.size()));
  std::vector<JSAMPLE> row(static_cast<std::size_t>(kind.width * channels));
  for (int y = 0; y < kind.height; ++y) {
    for (int x = 0; x < kind.width; ++x)
      for (int c = 0; c < channels; ++c)
        row[static_cast<std::size_t>(x * channels + c)] =
            static_cast<JSAMPLE>(x * (5 + 3 * c) + y * (7 - 2 * c) + (x / 9 + y / 7) % 2 * 90);
    JSAMPROW rows = row.data();
    jpeg_write_scanlines(&jpeg, &rows, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string out(reinterpret_cast<const char*>(bytes), count);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return out;
}

/// Scans of a grey picture: each coefficient in a scan of its own, `passes` times.
inline std::vector<jpeg_scan_info> scans_of_each_coefficient(int passes) {
  std::vector<jpeg_scan_info> scans;
  for (int coefficient = 0; coefficient < 64; ++coefficient)
    for (int pass = 0; pass < passes; ++pass) {
      const int low = passes - 1 - pass;
      scans.push_back({1, {0, 0, 0, 0}, coefficient, coefficient, pass == 0 ? 0 : low + 1, low});
    }
  return scans;
}

}  // namespace pentimento::test
