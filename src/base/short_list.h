// SPDX-License-Identifier: GPL-3.0-or-later
// A list that is short nearly always, and then needs no memory from the heap: what one ray is in or
// passes. Of plain values only, which are copied byte by byte.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

template <class T, std::size_t room>
class ShortList {
public:
    static_assert(std::is_trivially_copyable_v<T>);

    // What is not counted is not initialised.
    ShortList() {}
    ShortList(const ShortList& other) { *this = other; }
    ShortList& operator=(const ShortList& other) {
        if (this != &other) assign(other);
        return *this;
    }
    ~ShortList() {}

    void push_back(const T& value) {
        if (count_ < room) {
            own_[count_++] = value;
            return;
        }
        const T kept = value;  // which may be one of the own
        if (many_.empty()) many_.assign(own_.begin(), own_.end());
        many_.resize(count_);
        many_.push_back(kept);
        ++count_;
    }
    void erase(T* first, T* last) {
        T* to = first;
        for (T *from = last, *stop = end(); from != stop; ++from) *to++ = *from;
        shrink(count_ - static_cast<std::size_t>(last - first));
    }
    void erase(T* at) { erase(at, at + 1); }
    void clear() { shrink(0); }
    /// Its values are those of any range.
    template <class Range>
    void assign(const Range& values) {
        clear();
        for (const T& each : values) push_back(each);
    }

    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    T* begin() { return count_ > room ? many_.data() : own_.data(); }
    T* end() { return begin() + count_; }
    const T* begin() const { return count_ > room ? many_.data() : own_.data(); }
    const T* end() const { return begin() + count_; }
    T* data() { return begin(); }
    const T* data() const { return begin(); }
    const T& operator[](std::size_t i) const { return begin()[i]; }
    const T& back() const { return end()[-1]; }

private:
    /// What fits into the own room again goes back to it.
    void shrink(std::size_t count) {
        if (count_ > room && count <= room)
            for (std::size_t i = 0; i < count; ++i) own_[i] = many_[i];
        if (count <= room) many_.clear();
        count_ = count;
    }

    union {
        std::array<T, room> own_;
    };
    std::vector<T> many_;  ///< all of them when there are more than have room; otherwise empty
    std::size_t count_ = 0;
};
