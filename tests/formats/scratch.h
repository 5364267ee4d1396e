#pragma once
// For tests that write files: a folder that goes away, other people's programs, made-up pictures.

#include <sys/wait.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/field.h"
#include "core/shading/picture.h"

namespace pentimento::test {

class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "pentimento-XXXXXX").string();
    PENTIMENTO_CHECK(::mkdtemp(name.data()) != nullptr);
    folder_ = name;
  }
  ~Scratch() { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Names of all files, sorted by nobody: for "nothing is left" tests count them.
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_),
                                                  std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path folder_;
};

/// Exit status and what it printed (both streams).
inline std::pair<int, std::string> run(const std::string& command) {
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  PENTIMENTO_CHECK(pipe != nullptr);
  std::string text;
  std::array<char, 4096> bytes;
  for (std::size_t n; (n = std::fread(bytes.data(), 1, bytes.size(), pipe)) > 0;)
    text.append(bytes.data(), n);
  const int status = ::pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

inline std::string slurp(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}
inline void spill(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Planes with gradients, edges and values beyond 0..1, a different one for each channel.
inline std::vector<Field<float>> made_up_planes(int width, int height, int count) {
  std::vector<Field<float>> planes;
  for (int c = 0; c < count; ++c) {
    Field<float>& plane = planes.emplace_back(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const float wave = 0.5f + 0.5f * std::sin(0.1f * static_cast<float>(x * (c + 1) + 3 * y));
        const bool square = (x / 7 + y / 5 + c) % 9 == 0;
        plane(x, y) = square ? 1.2f * wave - 0.1f : wave * wave;
      }
  }
  return planes;
}

/// Hands `planes` to `sink` in strips of `rows` rows.
inline Result<void> write_strips(PictureSink& sink, const std::vector<Field<float>>& planes,
                                 const std::vector<std::string>& names, int rows) {
  const int height = planes[0].height();
  for (int y = 0; y < height; y += rows) {
    PictureStrip strip;
    strip.y0 = y;
    strip.rows = y + rows < height ? rows : height - y;
    strip.name = names;
    for (const Field<float>& plane : planes)
      strip.plane.push_back(plane.view().window(0, y, plane.width(), strip.rows));
    if (Result<void> written = sink.write(strip); !written) return written;
  }
  return {};
}

}  // namespace pentimento::test
