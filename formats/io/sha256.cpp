#include "formats/io/sha256.h"

#include <openssl/evp.h>

#include "core/base/check.h"
#include "core/base/require_memory.h"

namespace pentimento {

struct Sha256::Digest {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  Digest() { require_memory(context != nullptr); }
  ~Digest() { EVP_MD_CTX_free(context); }
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;
};

Sha256::Sha256() : digest_(std::make_unique<Digest>()) {
  require_memory(EVP_DigestInit_ex(digest_->context, EVP_sha256(), nullptr) == 1);
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::update(const void* bytes, std::size_t count) {
  require_memory(EVP_DigestUpdate(digest_->context, bytes, count) == 1);
}

Sha256Bytes Sha256::bytes() const {
  // Finishes a copy, so that the original can take more bytes.
  Digest copy;
  Sha256Bytes bytes{};
  unsigned int count = 0;
  require_memory(EVP_MD_CTX_copy_ex(copy.context, digest_->context) == 1);
  require_memory(EVP_DigestFinal_ex(copy.context, bytes.data(), &count) == 1);
  PENTIMENTO_CHECK(count == bytes.size());
  return bytes;
}

std::string Sha256::hex() const {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes()) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

Sha256Bytes sha256(const void* bytes, std::size_t count) {
  Sha256 sha;
  sha.update(bytes, count);
  return sha.bytes();
}

std::string sha256_hex(std::string_view bytes) {
  Sha256 sha;
  sha.update(bytes);
  return sha.hex();
}

}  // namespace pentimento
