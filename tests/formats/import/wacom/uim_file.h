#pragma once
// Files of Wacom's ink as tests write them.

#include <cstdint>
#include <string>

#include "formats/import/wacom/uim.pb.h"

namespace pentimento::sketch {

inline std::string u32_bytes(std::size_t value) {
  std::string out;
  for (int i = 0; i < 4; ++i) out += static_cast<char>((value >> (8 * i)) & 255);
  return out;
}
inline std::string chunk_of(const std::string& name, const std::string& bytes) {
  return name + u32_bytes(bytes.size()) + bytes + std::string(bytes.size() % 2, '\0');
}
inline std::string riff_of(const std::string& chunks) {
  return "RIFF" + u32_bytes(chunks.size() + 4) + "UINK" + chunks;
}
/// What HEAD of 3.1 says of one chunk.
inline std::string about_chunk(char content = 1, char compression = 0) {
  return {3, 1, 0, content, compression, 0, 0, 0};
}
/// A file of version 3.1.
inline std::string uim_31(const uim::InputData& input, const uim::InkData& ink) {
  const std::string head = std::string({3, 1, 0, 0}) + about_chunk() + about_chunk();
  return riff_of(chunk_of("HEAD", head) + chunk_of("INPT", input.SerializeAsString()) +
                 chunk_of("INKD", ink.SerializeAsString()));
}

}  // namespace pentimento::sketch
