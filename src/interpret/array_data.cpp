// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/array_data.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

IndexNames::IndexNames(std::vector<std::string> names) : all_(std::move(names)) {
    for (std::size_t i = 0; i < all_.size(); ++i) places_.emplace(all_[i], static_cast<int>(i));
}

std::optional<int> IndexNames::find(std::string_view name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? std::nullopt : std::optional(found->second);
}

ArrayData::ArrayData(std::vector<int> sizes, Kinds kinds)
    : sizes_(std::move(sizes)), kinds_(kinds) {
    for (const int size : sizes_) size_ *= static_cast<std::size_t>(size);
    counts_.assign(size_, 0);
}

ArrayData::ArrayData(std::vector<int> sizes, std::vector<double> numbers)
    : sizes_(std::move(sizes)), size_(numbers.size()), stride_(1), numbers_(std::move(numbers)) {
    counts_.resize(size_);
    for (std::size_t i = 0; i < size_; ++i) counts_[i] = !std::isnan(numbers_[i]);
    set_ = static_cast<std::size_t>(std::ranges::count(counts_, 1));
}

ArrayData ArrayData::growing(Kinds kinds) {
    ArrayData result({0}, kinds);
    result.grows_ = true;
    return result;
}

void ArrayData::grow(int size) {
    sizes_[0] = size;
    size_ = static_cast<std::size_t>(size);
    if (!values_.empty()) {
        values_.resize(size_, Absence::uninitialised);
        return;
    }
    counts_.resize(size_);
    numbers_.resize(size_ * static_cast<std::size_t>(stride_));
}

Value ArrayData::at(std::size_t i) const {
    if (!values_.empty()) return values_[i];
    if (counts_[i] == broken) return Absence::broken;
    if (counts_[i] == 0) return Absence::uninitialised;
    Numbers result;
    result.count = counts_[i];
    std::copy_n(numbers(i), result.count, result.at.begin());
    return result;
}

bool ArrayData::fits(std::size_t i, const Value& value) const {
    if (kinds_ == Kinds::mixed || set_ <= (has(i) ? 1u : 0u)) return true;
    if (values_.empty()) return value.numbers() != nullptr;
    // Tables may have columns of several kinds.
    return other(i).same_kind(value) || values_[i].same_kind(value);
}

Value ArrayData::other(std::size_t i) const {
    // The neighbour nearly always is set: elements are set one after the other.
    if (i > 0 && has(i - 1)) return at(i - 1);
    for (std::size_t k = 0; k < size_; ++k)
        if (k != i && has(k)) return at(k);
    return Absence::uninitialised;
}

void ArrayData::widen(int stride) {
    std::vector<double> wider(size_ * static_cast<std::size_t>(stride));
    for (std::size_t i = 0; i < size_; ++i)
        std::copy_n(numbers(i), count(i), wider.data() + i * static_cast<std::size_t>(stride));
    numbers_ = std::move(wider);
    stride_ = stride;
}

void ArrayData::set(std::size_t i, const Numbers& numbers) {
    if (!values_.empty()) {
        if (set_ > (has(i) ? 1u : 0u)) return put(i, numbers);
        values_.clear();
        counts_.assign(size_, 0);
        set_ = 0;
    }
    if (numbers.count > stride_) widen(numbers.count);
    if (count(i) == 0) ++set_;
    counts_[i] = static_cast<std::uint8_t>(numbers.count);
    std::copy_n(numbers.at.begin(), numbers.count,
                numbers_.begin() + static_cast<std::ptrdiff_t>(i) * stride_);
}

void ArrayData::set(std::size_t i, Value value) {
    if (const Numbers* numbers = value.numbers()) return set(i, *numbers);
    if (values_.empty() && value.broken()) {
        clear(i);
        counts_[i] = broken;
        return;
    }
    if (values_.empty()) {
        std::vector<Value> values;
        values.reserve(size_);
        for (std::size_t k = 0; k < size_; ++k) values.push_back(at(k));
        values_ = std::move(values);
        counts_.clear();
        numbers_.clear();
        stride_ = 0;
    }
    put(i, std::move(value));
}

void ArrayData::put(std::size_t i, Value value) {
    set_ -= has(i);
    values_[i] = std::move(value);
    set_ += has(i);
}

void ArrayData::clear(std::size_t i) {
    if (has(i)) --set_;
    if (values_.empty())
        counts_[i] = 0;
    else
        values_[i] = Absence::uninitialised;
}

Value* ArrayData::inner(std::size_t i) {
    return !values_.empty() && values_[i].array() ? &values_[i] : nullptr;
}

}  // namespace candelabra
