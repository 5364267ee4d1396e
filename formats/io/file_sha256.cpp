#include "formats/io/file_sha256.h"

#include <array>
#include <fstream>

#include "formats/io/sha256.h"

namespace pentimento {

Result<std::string> file_sha256(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Sha256 hash;
  std::array<char, 1 << 16> bytes{};
  while (file) {
    file.read(bytes.data(), bytes.size());
    hash.update(bytes.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof()) return Error{ErrorCode::kIo, path + ": cannot be read"};
  return hash.hex();
}

}  // namespace pentimento
