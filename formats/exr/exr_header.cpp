#include "formats/exr/exr_header.h"

#include <fmt/format.h>
#include <openexr.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <system_error>

namespace pentimento::exr {

namespace {

/// An open file of the C core.
struct Parsed {
  exr_context_t context = nullptr;
  Parsed() = default;
  ~Parsed() { exr_finish(&context); }
  Parsed(const Parsed&) = delete;
  Parsed& operator=(const Parsed&) = delete;
};

/// The library prints what is wrong unless it is given another way to say it. Its result says so
/// too.
void say_nothing(exr_const_context_t, exr_result_t, const char*) {}

Error damaged(const std::string& path, exr_result_t why) {
  return {ErrorCode::kBadInput,
          fmt::format("{}: a damaged OpenEXR file: {}", path, exr_get_default_error_message(why))};
}

/// Channels, and the rows that are packed together, for which the C++ library takes memory when it
/// opens a file.
Result<void> check_sizes(const std::string& path, exr_const_context_t file, int part) {
  const exr_attr_chlist_t* channels = nullptr;
  std::uint64_t chunk_bytes = 0;
  exr_result_t done = exr_get_channels(file, part, &channels);
  if (done == EXR_ERR_SUCCESS) done = exr_get_chunk_unpacked_size(file, part, &chunk_bytes);
  if (done != EXR_ERR_SUCCESS) return damaged(path, done);
  if (channels->num_channels > kMostChannels)
    return Error{ErrorCode::kLimit, fmt::format("{}: {} channels, the limit is {}", path,
                                                channels->num_channels, kMostChannels)};
  if (chunk_bytes > kMostChunkBytes)
    return Error{ErrorCode::kLimit,
                 fmt::format("{}: rows that are packed together take {} bytes, the limit is {}",
                             path, chunk_bytes, kMostChunkBytes)};
  return {};
}

/// Whether a list of channels has its end, a channel without a name, as its last byte. The C++
/// library reads on until there is one. Behind a name: type, linearity and two rates of sampling.
bool has_its_end(const std::string& list) {
  constexpr std::size_t kBehindName_bytes = 17;  // with the name's own end
  std::size_t at = 0;
  while (at < list.size() && list[at] != 0) {
    const std::size_t end = list.find('\0', at);
    if (end == std::string::npos) return false;
    at = end + kBehindName_bytes;
  }
  return at + 1 == list.size();
}

/// Whether all lists of channels of the next header have their ends, and no value is longer than
/// the file. Leaves `file` behind that header.
bool next_lists_end(std::istream& file, std::uintmax_t file_bytes) {
  bool all = true;
  std::string name, type;
  while (all && std::getline(file, name, '\0') && !name.empty()) {
    std::array<unsigned char, 4> length{};
    std::getline(file, type, '\0');
    file.read(reinterpret_cast<char*>(length.data()), length.size());
    const std::size_t bytes =
        length[0] | length[1] << 8 | length[2] << 16 | std::size_t{length[3]} << 24;
    if (bytes > file_bytes) return false;
    std::string value(bytes, '\0');
    file.read(value.data(), static_cast<std::streamsize>(bytes));
    all = type != "chlist" || has_its_end(value);
  }
  return all;
}

Result<void> check_lists(const std::string& path, std::uintmax_t file_bytes, int parts) {
  constexpr std::streamoff kFirstHeader = 8;  // behind the magic number and the version
  std::ifstream file(path, std::ios::binary);
  file.seekg(kFirstHeader);
  for (int part = 0; part < parts; ++part)
    if (!next_lists_end(file, file_bytes)) return damaged(path, EXR_ERR_ATTR_SIZE_MISMATCH);
  return {};
}

/// Whether the file is long enough for its table of chunks, eight bytes each.
Result<void> check_table(const std::string& path, std::uintmax_t file_bytes,
                         exr_const_context_t file, int part) {
  std::int32_t chunks = 0;
  const exr_result_t done = exr_get_chunk_count(file, part, &chunks);
  if (done != EXR_ERR_SUCCESS) return damaged(path, done);
  if (static_cast<std::uintmax_t>(chunks) > file_bytes / 8)
    return damaged(path, EXR_ERR_BAD_CHUNK_LEADER);
  return {};
}

}  // namespace

Result<void> check_header(const std::string& path) {
  exr_context_initializer_t how = EXR_DEFAULT_CONTEXT_INITIALIZER;
  how.error_handler_fn = say_nothing;
  // Without the second flag, faults are mended that the C++ library stumbles over.
  how.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION | EXR_CONTEXT_FLAG_STRICT_HEADER;
  Parsed file;
  exr_result_t done = exr_start_read(&file.context, path.c_str(), &how);
  if (done != EXR_ERR_SUCCESS) return damaged(path, done);
  int parts = 0;
  done = exr_get_count(file.context, &parts);
  if (done != EXR_ERR_SUCCESS) return damaged(path, done);
  std::error_code failure;
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, failure);
  if (failure) return damaged(path, EXR_ERR_READ_IO);
  for (int part = 0; part < parts; ++part) {
    if (const Result<void> fits = check_sizes(path, file.context, part); !fits) return fits;
    if (const Result<void> fits = check_table(path, file_bytes, file.context, part); !fits)
      return fits;
  }
  return check_lists(path, file_bytes, parts);
}

}  // namespace pentimento::exr
