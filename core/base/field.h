#pragma once
// One plane of values on the canvas grid: Field owns it, FieldView is a window on it. x is the
// fastest index, rows start at 64-byte boundaries, row 0 is the top of the canvas. This file has no
// arithmetic.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "core/base/check.h"
#include "core/base/plane_memory.h"

namespace pentimento {

/// A window on a plane: pointer, width, height, stride (in elements). A copy shows the same values.
template <typename T>
class FieldView {
 public:
  FieldView() = default;
  FieldView(T* data, int width, int height, std::ptrdiff_t stride)
      : data_(data), width_(width), height_(height), stride_(stride) {}
  /// Turns a view for writing into a view for reading.
  operator FieldView<const T>() const { return {data_, width_, height_, stride_}; }

  int width() const { return width_; }
  int height() const { return height_; }
  std::ptrdiff_t stride() const { return stride_; }
  bool empty() const { return width_ == 0 || height_ == 0; }
  T* row(int y) const { return data_ + static_cast<std::ptrdiff_t>(y) * stride_; }
  std::span<T> row_span(int y) const { return {row(y), static_cast<std::size_t>(width_)}; }
  T& operator()(int x, int y) const { return row(y)[x]; }
  /// The part of `width` x `height` values from (x0, y0) on. It must lie inside the view.
  FieldView window(int x0, int y0, int width, int height) const {
    PENTIMENTO_CHECK(x0 >= 0 && y0 >= 0 && x0 + width <= width_ && y0 + height <= height_);
    return {row(y0) + x0, width, height, stride_};
  }

 private:
  T* data_ = nullptr;
  int width_ = 0;
  int height_ = 0;
  std::ptrdiff_t stride_ = 0;
};

/// Owns one plane of plain values, which are zero at first. Move-only; clone() copies.
template <typename T>
class Field {
 public:
  Field() = default;
  Field(int width, int height, T value = T{}) {
    shape(width, height);
    data_ = zeros(count() * sizeof(T));
    const T zero{};
    if (std::memcmp(&value, &zero, sizeof(T)) != 0) fill(value);
  }
  /// Zeros in memory that the planes around it share, while there is any.
  Field(int width, int height, PlaneMemory& memory) {
    shape(width, height);
    const std::size_t bytes = count() * sizeof(T);
    void* const shared = bytes > 0 ? memory.take(bytes) : nullptr;
    data_ = shared != nullptr ? Plane(static_cast<T*>(shared), Free{nullptr, memory.mapping()})
                              : zeros(bytes);
  }

  /// A copy, which takes memory only where there are values other than zero.
  Field clone() const {
    Field copy(width_, height_);
    const std::size_t bytes = count() * sizeof(T);
    const auto* from = reinterpret_cast<const unsigned char*>(data_.get());
    auto* to = reinterpret_cast<unsigned char*>(copy.data_.get());
    for (std::size_t at = 0; at < bytes; at += kPage_bytes) {
      const std::size_t length = std::min(kPage_bytes, bytes - at);
      if (!is_zero(from + at, length)) std::memcpy(to + at, from + at, length);
    }
    return copy;
  }
  void fill(T value) {
    for (std::size_t i = 0; i < count(); ++i) data_.get()[i] = value;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return width_ == 0 || height_ == 0; }
  T* row(int y) { return data_.get() + static_cast<std::ptrdiff_t>(y) * stride_; }
  const T* row(int y) const { return data_.get() + static_cast<std::ptrdiff_t>(y) * stride_; }
  T& operator()(int x, int y) { return row(y)[x]; }
  const T& operator()(int x, int y) const { return row(y)[x]; }
  FieldView<T> view() { return {data_.get(), width_, height_, stride_}; }
  FieldView<const T> view() const { return {data_.get(), width_, height_, stride_}; }
  friend void swap(Field& a, Field& b) noexcept {
    std::swap(a.data_, b.data_);
    std::swap(a.width_, b.width_);
    std::swap(a.height_, b.height_);
    std::swap(a.stride_, b.stride_);
  }

 private:
  static constexpr std::size_t kAlignment = 64;
  static constexpr std::size_t kPage_bytes = 4096;  // what the system gives a process at a time
  static_assert(std::is_trivially_copyable_v<T>, "a plane is copied, and made, as bytes");
  struct Free {
    void* allocated = nullptr;  // by calloc; the plane begins at the first multiple of kAlignment
    std::shared_ptr<void> shared = {};  // or what the plane is part of
    void operator()(T*) const { std::free(allocated); }
  };
  using Plane = std::unique_ptr<T[], Free>;

  void shape(int width, int height) {
    PENTIMENTO_CHECK(width >= 0 && height >= 0);
    constexpr std::size_t kPerLine = kAlignment / sizeof(T);
    width_ = width;
    height_ = height;
    stride_ = static_cast<std::ptrdiff_t>((static_cast<std::size_t>(width) + kPerLine - 1) /
                                          kPerLine * kPerLine);
  }

  /// Zeros. A large plane gets its pages from the system, which are zero and take no memory until
  /// they are written to.
  static Plane zeros(std::size_t bytes) {
    if (bytes == 0) return {};
    std::size_t space = bytes + kAlignment;
    void* const allocated = std::calloc(space, 1);
    if (allocated == nullptr) throw std::bad_alloc();
    void* begin = allocated;
    return Plane(static_cast<T*>(std::align(kAlignment, bytes, begin, space)), Free{allocated, {}});
  }

  static bool is_zero(const unsigned char* bytes, std::size_t length) {
    unsigned char any = 0;
    for (std::size_t i = 0; i < length; ++i) any |= bytes[i];
    return any == 0;
  }

  std::size_t count() const {
    return static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_);
  }
  Plane data_;
  int width_ = 0;
  int height_ = 0;
  std::ptrdiff_t stride_ = 0;
};

}  // namespace pentimento
