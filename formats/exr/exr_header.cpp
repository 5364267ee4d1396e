#include "formats/exr/exr_header.h"

#include <fmt/format.h>
#include <openexr.h>

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

/// Keeps the first wrong length of an attribute: the library goes on after it as if nothing were.
/// Called instead of printing.
void keep_wrong_length(exr_const_context_t context, exr_result_t code, const char*) {
  void* kept = nullptr;
  if (code != EXR_ERR_ATTR_SIZE_MISMATCH || exr_get_user_data(context, &kept) != EXR_ERR_SUCCESS)
    return;
  *static_cast<exr_result_t*>(kept) = code;
}

Error damaged(const std::string& path, exr_result_t why) {
  return {ErrorCode::kBadInput,
          fmt::format("{}: a damaged OpenEXR file: {}", path, exr_get_default_error_message(why))};
}

}  // namespace

Result<void> check_header(const std::string& path) {
  exr_result_t length = EXR_ERR_SUCCESS;
  exr_context_initializer_t how = EXR_DEFAULT_CONTEXT_INITIALIZER;
  how.error_handler_fn = keep_wrong_length;
  how.user_data = &length;
  how.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
  Parsed file;
  exr_result_t done = exr_start_read(&file.context, path.c_str(), &how);
  if (done == EXR_ERR_SUCCESS) done = length;
  if (done != EXR_ERR_SUCCESS) return damaged(path, done);
  const exr_attr_chlist_t* channels = nullptr;
  done = exr_get_channels(file.context, 0, &channels);
  if (done != EXR_ERR_SUCCESS) return damaged(path, done);
  if (channels->num_channels > kMostChannels)
    return Error{ErrorCode::kLimit, fmt::format("{}: {} channels, the limit is {}", path,
                                                channels->num_channels, kMostChannels)};
  return {};
}

}  // namespace pentimento::exr
