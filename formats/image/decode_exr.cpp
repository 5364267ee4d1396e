#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <fmt/format.h>

#include <exception>
#include <new>

#include "formats/exr/chromaticities.h"
#include "formats/exr/exr_header.h"
#include "formats/image/decode.h"
#include "formats/io/utf8.h"

namespace pentimento::image {

namespace {

/// The library quotes the file in its messages, which may be anything.
constexpr std::size_t kMostMessageBytes = 200;

/// Of all channels of a picture: 16 GiB, a poster of 16384 x 16384 cells with 16 channels. Few
/// bytes of a file can stand for many equal samples, so that its length says nothing.
constexpr std::int64_t kMostSamples = std::int64_t{1} << 32;

Result<void> check_samples(const std::string& path, const Imf::ChannelList& channels,
                           std::int64_t pixels) {
  std::int64_t count = 0;
  for (auto it = channels.begin(); it != channels.end(); ++it) ++count;
  if (count <= kMostSamples / pixels) return {};
  return Error{ErrorCode::kLimit,
               fmt::format("{}: {} channels of {} pixels, the limit is {} in all", path, count,
                           pixels, kMostSamples)};
}

/// Adds a plane for each channel to `image`.
Result<void> add_planes(const std::string& path, const Imf::ChannelList& channels, Image& image) {
  for (auto it = channels.begin(); it != channels.end(); ++it) {
    if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
      return Error{ErrorCode::kBadInput, path + ": channel " +
                                             brief_line(valid_utf8(it.name()), kMostMessageBytes) +
                                             " is subsampled, which is not supported"};
    image.name.push_back(it.name());
    image.plane.emplace_back(image.width, image.height);
    if (it.channel().type != Imf::HALF) image.bits = 32;
  }
  return {};
}

/// A slice that puts row y of the data window at row y - y0 of `plane`.
Imf::Slice slice_of(Field<float>& plane, std::ptrdiff_t x0, std::ptrdiff_t y0) {
  const std::ptrdiff_t stride = plane.view().stride();
  char* origin = reinterpret_cast<char*>(plane.row(0)) -
                 (y0 * stride + x0) * static_cast<std::ptrdiff_t>(sizeof(float));
  return {Imf::FLOAT, origin, sizeof(float), static_cast<std::size_t>(stride) * sizeof(float)};
}

Result<Image> decode(const std::string& path, const ImageReadOptions& options) {
  Imf::InputFile file(path.c_str(), 0);
  const Imath::Box2i window = file.header().dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  if (const Result<void> fits = check_size(path, width, height, options.limits); !fits)
    return fits.error();
  Image image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.format = "exr";
  image.bits = 16;
  image.stored_float = true;
  if (const auto profile = exr::profile_in(file.header())) {
    image.profile = *profile;
    image.profile_title = std::string(profile_title(*profile)) + " primaries";
  }
  if (const Result<void> fits = check_samples(path, file.header().channels(), width * height);
      !fits)
    return fits.error();
  if (const Result<void> added = add_planes(path, file.header().channels(), image); !added)
    return added.error();
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < image.plane.size(); ++c)
    buffer.insert(image.name[c], slice_of(image.plane[c], window.min.x, window.min.y));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return image;
}

}  // namespace

Result<Image> decode_exr(const std::string& path, const ImageReadOptions& options) {
  if (const Result<void> sound = exr::check_header(path); !sound) return sound.error();
  try {
    return decode(path, options);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::kLimit, path + ": no memory to read it"};
  } catch (const std::exception& error) {
    return Error{ErrorCode::kBadInput,
                 path + ": " + brief_line(valid_utf8(error.what()), kMostMessageBytes)};
  }
}

}  // namespace pentimento::image
