#pragma once
// The bytes of a fuzzer's input as a row of choices. After the last byte every choice is the first.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pentimento::test {

class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  bool made() const { return at_ >= bytes_.size(); }
  std::uint8_t byte() { return made() ? 0 : static_cast<std::uint8_t>(bytes_[at_++]); }
  /// One of 0 .. count - 1; count is at most 256.
  std::size_t below(std::size_t count) { return byte() % count; }
  bool flag() { return byte() % 2 != 0; }
  /// From `least` to `most`, both among 256 values.
  double between(double least, double most) { return least + (most - least) * byte() / 255.0; }
  template <typename List>
  const auto& of(const List& list) {
    return list[below(std::size(list))];
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace pentimento::test
