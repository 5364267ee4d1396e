#include "formats/io/read_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace pentimento {

namespace {
constexpr std::size_t kPiece = 1 << 20;

struct CloseUnlessInput {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};
}  // namespace

Result<std::string> read_file(const std::string& path, std::int64_t most_bytes) {
  const auto failed = [&](int number) {
    return Error{ErrorCode::kIo, path + ": " + std::strerror(number)};
  };
  const std::unique_ptr<std::FILE, CloseUnlessInput> file(
      path == "-" ? stdin : std::fopen(path.c_str(), "rb"));
  if (!file) return failed(errno);
  std::string bytes;
  while (true) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kPiece);
    errno = 0;
    const std::size_t count = std::fread(bytes.data() + before, 1, kPiece, file.get());
    bytes.resize(before + count);
    if (static_cast<std::int64_t>(bytes.size()) > most_bytes)
      return Error{ErrorCode::kLimit, fmt::format("{}: larger than {} bytes", path, most_bytes)};
    if (count < kPiece) break;
  }
  if (std::ferror(file.get()) != 0) return failed(errno);
  return bytes;
}

}  // namespace pentimento
