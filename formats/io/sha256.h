#pragma once
// SHA-256 of bytes given piece by piece (FIPS 180-4). Not for passwords or signatures.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace pentimento {

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

 private:
  struct Digest;
  std::unique_ptr<Digest> digest_;
};

/// SHA-256 of `bytes`, 64 lower-case hex digits.
std::string sha256_hex(std::string_view bytes);

}  // namespace pentimento
