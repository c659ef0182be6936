// A vector that never allocates, for counts with a proven bound.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <source_location>

#include "geometry/capacity.h"

namespace tyndall {

/// Throws CapacityExceeded, unchanged, if it would hold more than `capacity` entries.
template <class T, std::size_t capacity>
class InlineVector {
public:
    InlineVector() = default;
    InlineVector(const InlineVector& other) : size_(other.size_) { std::copy_n(other.begin(), size_, begin()); }
    InlineVector& operator=(const InlineVector& other) {
        size_ = other.size_;
        std::copy_n(other.begin(), size_, begin());
        return *this;
    }

    void push_back(const T& value, const std::source_location& where = std::source_location::current()) {
        if (size_ >= capacity) throwCapacityExceeded(capacity, where);
        items_[size_++] = value;
    }
    void resize(std::size_t size, const std::source_location& where = std::source_location::current()) {
        if (size > capacity) throwCapacityExceeded(capacity, where);
        size_ = size;
    }
    void clear() { size_ = 0; }
    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    T* data() { return items_.data(); }
    const T* data() const { return items_.data(); }
    T& operator[](std::size_t i) { return items_[i]; }
    const T& operator[](std::size_t i) const { return items_[i]; }
    T* begin() { return items_.data(); }
    T* end() { return items_.data() + size_; }
    const T* begin() const { return items_.data(); }
    const T* end() const { return items_.data() + size_; }
    const T& front() const { return items_[0]; }

private:
    std::array<T, capacity> items_;
    std::size_t size_ = 0;
};

}  // namespace tyndall
