#include "formats/color/converted_file.h"

#include <algorithm>

#include "core/base/threads.h"

namespace pentimento {

namespace {

using Triple = std::array<std::size_t, 3>;

class ConvertedFile final : public PictureFile {
 public:
  ConvertedFile(std::unique_ptr<PictureFile> file, ColorProfile profile,
                std::vector<Triple> triples, int threads)
      : file_(std::move(file)),
        triples_(std::move(triples)),
        matrix_(between(ColorProfile::kSrgb, profile)),
        threads_(threads) {}

  Result<void> write(const PictureStrip& strip) override;
  Result<Published> complete() override { return file_->complete(); }
  Result<void> publish() override { return file_->publish(); }

 private:
  std::unique_ptr<PictureFile> file_;
  std::vector<Triple> triples_;
  ColorMatrix matrix_;
  Threads threads_;
};

Result<void> ConvertedFile::write(const PictureStrip& strip) {
  PictureStrip converted = strip;
  std::vector<Field<float>> planes;
  planes.reserve(3 * triples_.size());
  const int width = strip.plane.front().width();
  for (const Triple& triple : triples_) {
    std::array<Field<float>*, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = &planes.emplace_back(width, strip.rows);
    threads_.for_rows(strip.rows, [&](int y) {
      for (int x = 0; x < width; ++x) {
        std::array<double, 3> in{};
        for (std::size_t i = 0; i < 3; ++i)
          in[i] = static_cast<double>(strip.plane[triple[i]].row(y)[x]);
        for (std::size_t i = 0; i < 3; ++i)
          (*out[i])(x, y) = static_cast<float>((matrix_[i][0] * in[0] + matrix_[i][1] * in[1]) +
                                               matrix_[i][2] * in[2]);
      }
    });
    for (std::size_t i = 0; i < 3; ++i)
      converted.plane[triple[i]] = static_cast<const Field<float>&>(*out[i]).view();
  }
  return file_->write(converted);
}

}  // namespace

std::vector<Triple> light_channels(const std::vector<std::string>& names) {
  const auto index_of = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  std::vector<Triple> triples;
  for (const std::string& name : names) {
    if (name != "R" && !name.ends_with(".R")) continue;
    const std::string layer = name.substr(0, name.size() - 1);
    const Triple triple = {index_of(name), index_of(layer + "G"), index_of(layer + "B")};
    if (std::max({triple[0], triple[1], triple[2]}) < names.size()) triples.push_back(triple);
  }
  return triples;
}

std::unique_ptr<PictureFile> convert_light(std::unique_ptr<PictureFile> file, ColorProfile profile,
                                           const std::vector<std::string>& channels, int threads) {
  if (profile == ColorProfile::kSrgb) return file;
  return std::make_unique<ConvertedFile>(std::move(file), profile, light_channels(channels),
                                         threads);
}

}  // namespace pentimento
