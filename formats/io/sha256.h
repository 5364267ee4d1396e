#pragma once
// SHA-256 of bytes given piece by piece (FIPS 180-4). Not for passwords or signatures.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace pentimento {

using Sha256Bytes = std::array<std::uint8_t, 32>;

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void update(const void* bytes, std::size_t count);
  void update(std::string_view bytes) { update(bytes.data(), bytes.size()); }
  /// The hash of all bytes so far, as 64 lower-case hex digits. More bytes may follow.
  std::string hex() const;
  /// The same as bytes.
  Sha256Bytes bytes() const;

 private:
  struct Digest;
  std::unique_ptr<Digest> digest_;
};

Sha256Bytes sha256(const void* bytes, std::size_t count);
/// SHA-256 of `bytes`, 64 lower-case hex digits.
std::string sha256_hex(std::string_view bytes);

}  // namespace pentimento
