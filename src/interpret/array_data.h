// SPDX-License-Identifier: GPL-3.0-or-later
// The elements of an array, each set or not yet set; in the language all are of one kind. Arrays of
// numbers, the usual case, are stored contiguously, with as many numbers for each element as the
// largest needs. Other elements are stored as values.
#pragma once

#include "interpret/value.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace candelabra {

/// Names for the last index of an array: the columns of a table, the members of an object.
class IndexNames {
public:
    /// If names are equal, the first one counts.
    explicit IndexNames(std::vector<std::string> names);
    IndexNames(const IndexNames&) = delete;
    IndexNames& operator=(const IndexNames&) = delete;

    const std::vector<std::string>& all() const { return all_; }
    std::optional<int> find(std::string_view name) const;

private:
    std::vector<std::string> all_;
    std::unordered_map<std::string_view, int> places_;
};

class ArrayData {
public:
    enum class Kinds : std::uint8_t { one, mixed };
    /// One to five sizes of at least 1. No element is set.
    explicit ArrayData(std::vector<int> sizes, Kinds = Kinds::one);
    /// An array of one dimension and no elements, which grows.
    static ArrayData growing(Kinds);
    /// One number for each element. A NaN leaves its element unset.
    ArrayData(std::vector<int> sizes, std::vector<double> numbers);

    /// Names for the last index, or null.
    const std::shared_ptr<const IndexNames>& names() const { return names_; }
    void set_names(std::shared_ptr<const IndexNames> names) { names_ = std::move(names); }

    const std::vector<int>& sizes() const { return sizes_; }
    /// Whether an index beyond the last is an element as well.
    bool grows() const { return grows_; }
    /// Makes the only dimension this large. Precondition: grows(), and it is not smaller now.
    void grow(int size);
    /// The number of elements; the last index runs fastest.
    std::size_t size() const { return size_; }

    bool has(std::size_t i) const { return values_.empty() ? count(i) != 0 : !values_[i].absent(); }
    /// Absence::uninitialised if the element is not set, Absence::broken if set to a broken value.
    Value at(std::size_t i) const;
    /// The number of components of an element; 0 if it is not set or not numbers.
    int count(std::size_t i) const {
        return values_.empty() && counts_[i] != broken ? counts_[i] : 0;
    }
    /// The numbers of an element. Precondition: count(i) > 0.
    const double* numbers(std::size_t i) const {
        return numbers_.data() + i * static_cast<std::size_t>(stride_);
    }
    /// The largest number of components that an element has had; 0 for other kinds.
    int max_numbers() const { return values_.empty() ? stride_ : 0; }

    /// Whether the value is of the kind of element i, or of the kind of the other elements, or
    /// elements may be of any kind.
    bool fits(std::size_t i, const Value& value) const;
    /// A set element other than i, or Absence::uninitialised.
    Value other(std::size_t i) const;

    /// Sets an element, even to a value that does not fit: callers check fits() first.
    void set(std::size_t i, Value value);
    void set(std::size_t i, const Numbers& numbers);
    /// Makes an element unset.
    void clear(std::size_t i);
    /// The array in an element, for writing; null if the element is none.
    Value* inner(std::size_t i);

private:
    static constexpr std::uint8_t broken = 0xFF;  ///< in counts_: set to a broken value

    void widen(int stride);
    void put(std::size_t i, Value value);

    std::vector<int> sizes_;
    std::size_t size_ = 1;
    std::size_t set_ = 0;  ///< number of set elements
    int stride_ = 0;
    bool grows_ = false;
    Kinds kinds_ = Kinds::one;
    std::vector<std::uint8_t> counts_;  ///< numbers of each element, 0: not set
    std::vector<double> numbers_;
    std::vector<Value> values_;  ///< not empty: elements are not numbers
    std::shared_ptr<const IndexNames> names_;
};

}  // namespace candelabra
