// SPDX-License-Identifier: GPL-3.0-or-later
// A value that is made once and shared by all who hold a handle to it. Eight bytes and one
// allocation, because scenes hold millions. Nobody changes what others hold, so any number of
// threads may keep handles to one value; edit() copies when it has to. T may be incomplete where
// handles are only held and passed on.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace handle_detail {

/// In front of every shared value.
struct Header {
    mutable std::atomic<std::uint32_t> holders;
    void (*destroy)(const Header*);
};

template <class T>
struct Holder : Header {
    static_assert(alignof(T) <= sizeof(Header), "the value follows the header at once");

    template <class... Arguments>
    explicit Holder(Arguments&&... arguments)
        : Header{1, [](const Header* header) { delete static_cast<const Holder*>(header); }},
          value(std::forward<Arguments>(arguments)...) {}

    T value;
};

}  // namespace handle_detail

template <class T>
class Handle {
public:
    using Content = T;

    Handle() = default;
    Handle(std::nullptr_t) {}
    Handle(const Handle& other) : content_(other.content_) {
        if (content_) header()->holders.fetch_add(1, std::memory_order_relaxed);
    }
    Handle(Handle&& other) noexcept : content_(std::exchange(other.content_, nullptr)) {}
    Handle& operator=(Handle other) noexcept {
        std::swap(content_, other.content_);
        return *this;
    }
    ~Handle() {
        if (content_ && header()->holders.fetch_sub(1, std::memory_order_acq_rel) == 1)
            header()->destroy(header());
    }

    const T* get() const { return content_; }
    const T& operator*() const { return *content_; }
    const T* operator->() const { return content_; }
    explicit operator bool() const { return content_ != nullptr; }
    /// Whether both are the same value, not merely equal ones.
    friend bool operator==(const Handle&, const Handle&) = default;

    /// Whether nobody else holds the value. Precondition: not null.
    bool alone() const { return header()->holders.load(std::memory_order_acquire) == 1; }
    /// The value for writing, which no other handle sees. Precondition: not null.
    T& edit() {
        if (!alone()) *this = make(*content_);
        return *content_;
    }

    template <class... Arguments>
    static Handle make(Arguments&&... arguments) {
        Handle made;
        made.content_ =
            &(new handle_detail::Holder<T>(std::forward<Arguments>(arguments)...))->value;
        return made;
    }

private:
    const handle_detail::Header* header() const {
        return reinterpret_cast<const handle_detail::Header*>(content_) - 1;
    }

    T* content_ = nullptr;
};

/// A handle to a new value.
template <class T, class... Arguments>
Handle<T> make_handle(Arguments&&... arguments) {
    return Handle<T>::make(std::forward<Arguments>(arguments)...);
}
