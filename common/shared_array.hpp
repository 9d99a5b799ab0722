// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace dem {

/// A read-only array together with whatever keeps it alive: a vector it took over, or the memory
/// map of the template file it lies in. Copies share the data.
template <class T>
class SharedArray {
  public:
    SharedArray() = default;

    /// Takes the vector over.
    SharedArray(std::vector<T> values) {  // NOLINT(google-explicit-constructor): a vector is one
        auto owned = std::make_shared<const std::vector<T>>(std::move(values));
        view_ = *owned;
        owner_ = std::move(owned);
    }

    /// A view into memory that lives as long as `owner`.
    SharedArray(std::shared_ptr<const void> owner, std::span<const T> view)
        : owner_(std::move(owner)), view_(view) {}

    const T* data() const { return view_.data(); }
    std::size_t size() const { return view_.size(); }
    bool empty() const { return view_.empty(); }
    const T& operator[](std::size_t i) const { return view_[i]; }
    const T& back() const { return view_.back(); }
    auto begin() const { return view_.begin(); }
    auto end() const { return view_.end(); }
    std::span<const T> span() const { return view_; }

  private:
    std::shared_ptr<const void> owner_;
    std::span<const T> view_;
};

}  // namespace dem
