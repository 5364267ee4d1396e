#include "formats/png/profile_chunk.h"

#include <zlib.h>

#include <algorithm>

#include "formats/io/deflate.h"

namespace pentimento::png {

namespace {
constexpr std::size_t kLongestProfile = std::size_t{4} << 20;
constexpr int kDeflateLevel = 1;

/// Empty where it is no zlib stream or too long.
std::vector<std::uint8_t> inflated(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> out(kLongestProfile);
  uLongf size = out.size();
  if (uncompress(out.data(), &size, bytes.data(), bytes.size()) != Z_OK) return {};
  out.resize(size);
  return out;
}
}  // namespace

std::vector<std::uint8_t> iccp_data(ColorProfile profile) {
  const std::string_view title = profile_title(profile);
  std::vector<std::uint8_t> data(title.begin(), title.end());
  data.insert(data.end(), {0, 0});  // end of the name, deflate
  const std::vector<std::uint8_t> packed = zlib_stream(icc_profile(profile), kDeflateLevel);
  data.insert(data.end(), packed.begin(), packed.end());
  return data;
}

IccDescription describe_iccp(std::span<const std::uint8_t> data) {
  const auto end = std::find(data.begin(), data.end(), std::uint8_t{0});
  IccDescription named{std::string(data.begin(), end), std::nullopt};
  if (data.end() - end < 2) return named;
  const auto name_bytes = static_cast<std::size_t>(end - data.begin());
  auto found = describe_icc(inflated(data.subspan(name_bytes + 2)));
  if (!found) return named;
  if (found->title.empty()) found->title = named.title;
  return *found;
}

}  // namespace pentimento::png
