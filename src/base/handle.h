// SPDX-License-Identifier: GPL-3.0-or-later
// A value that is created once and shared by all handles to it. It takes eight bytes and one
// allocation, because scenes hold millions. Shared values are never modified, so any number of
// threads may hold handles to one value; edit() copies if necessary. T may be incomplete where
// handles are only held and passed on.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace candelabra {

namespace handle_detail {

/// Precedes every shared value.
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

// In the functions below, `content` is a shared value, or null unless stated otherwise.

inline const Header* header(const void* content) { return static_cast<const Header*>(content) - 1; }
inline void hold(const void* content) {
    if (content) header(content)->holders.fetch_add(1, std::memory_order_relaxed);
}
inline void let_go(const void* content) {
    if (content && header(content)->holders.fetch_sub(1, std::memory_order_acq_rel) == 1)
        header(content)->destroy(header(content));
}
/// Precondition: not null.
inline bool alone(const void* content) {
    return header(content)->holders.load(std::memory_order_acquire) == 1;
}

}  // namespace handle_detail

class AnyHandle;

template <class T>
class Handle {
public:
    using Content = T;

    Handle() = default;
    Handle(std::nullptr_t) {}
    Handle(const Handle& other) : content_(other.content_) { handle_detail::hold(content_); }
    Handle(Handle&& other) noexcept : content_(std::exchange(other.content_, nullptr)) {}
    Handle& operator=(Handle other) noexcept {
        std::swap(content_, other.content_);
        return *this;
    }
    ~Handle() { handle_detail::let_go(content_); }

    const T* get() const { return content_; }
    const T& operator*() const { return *content_; }
    const T* operator->() const { return content_; }
    explicit operator bool() const { return content_ != nullptr; }
    /// Whether both refer to the same value, not merely to equal ones.
    friend bool operator==(const Handle&, const Handle&) = default;

    /// Whether no other handle holds the value. Precondition: not null.
    bool alone() const { return handle_detail::alone(content_); }
    /// The value for writing, unshared. Precondition: not null.
    T& edit() {
        if (!alone()) copy();
        return *content_;
    }

    template <class... Arguments>
    static Handle make(Arguments&&... arguments) {
        return adopt(new handle_detail::Holder<T>(std::forward<Arguments>(arguments)...));
    }
    /// Takes over a new holder.
    static Handle adopt(handle_detail::Holder<T>* holder) { return Handle(&holder->value); }

private:
    friend AnyHandle;
    [[gnu::noinline]] void copy() { *this = make(*content_); }
    /// Takes over one count of the holders.
    explicit Handle(T* content) : content_(content) {}

    T* content_ = nullptr;
};

/// Returns a handle to a new value.
template <class T, class... Arguments>
Handle<T> make_handle(Arguments&&... arguments) {
    return Handle<T>::make(std::forward<Arguments>(arguments)...);
}

/// A handle whose type only its user knows.
class AnyHandle {
public:
    template <class T>
    explicit AnyHandle(Handle<T> handle) : content_(std::exchange(handle.content_, nullptr)) {}
    AnyHandle(const AnyHandle& other) : content_(other.content_) { handle_detail::hold(content_); }
    AnyHandle(AnyHandle&& other) noexcept : content_(std::exchange(other.content_, nullptr)) {}
    AnyHandle& operator=(AnyHandle other) noexcept {
        std::swap(content_, other.content_);
        return *this;
    }
    ~AnyHandle() { handle_detail::let_go(content_); }

    const void* get() const { return content_; }
    /// Precondition: not null.
    bool alone() const { return handle_detail::alone(content_); }

    // T must be the type of the original handle:
    template <class T>
    Handle<T> as() const {
        handle_detail::hold(content_);
        return Handle<T>(static_cast<T*>(content_));
    }
    /// See Handle::edit().
    template <class T>
    T& edit() {
        if (!alone()) *this = AnyHandle(make_handle<T>(*static_cast<const T*>(content_)));
        return *static_cast<T*>(content_);
    }

private:
    void* content_ = nullptr;
};

}  // namespace candelabra
