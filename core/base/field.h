#pragma once
// One plane of values on the canvas grid: Field owns it, FieldView is a window on it. x is the
// fastest index, rows start at 64-byte boundaries, row 0 is the top of the canvas. This file has no
// arithmetic.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <utility>

#include "core/base/check.h"

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
  Field(int width, int height, T value = T{}) : width_(width), height_(height) {
    PENTIMENTO_CHECK(width >= 0 && height >= 0);
    constexpr std::size_t kPerLine = kAlignment / sizeof(T);
    stride_ = static_cast<std::ptrdiff_t>((static_cast<std::size_t>(width) + kPerLine - 1) /
                                          kPerLine * kPerLine);
    data_.reset(
        static_cast<T*>(::operator new[](count() * sizeof(T), std::align_val_t{kAlignment})));
    fill(value);
  }

  Field clone() const {
    Field copy(width_, height_);
    if (count() != 0) std::memcpy(copy.data_.get(), data_.get(), count() * sizeof(T));
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
  struct Free {
    void operator()(T* p) const { ::operator delete[](p, std::align_val_t{kAlignment}); }
  };
  std::size_t count() const {
    return static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_);
  }
  std::unique_ptr<T[], Free> data_;
  int width_ = 0;
  int height_ = 0;
  std::ptrdiff_t stride_ = 0;
};

}  // namespace pentimento
