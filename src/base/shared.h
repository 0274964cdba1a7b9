// SPDX-License-Identifier: GPL-3.0-or-later
// A value that is stored once and shared by its copies; editing a copy unshares it.
#pragma once

#include "base/handle.h"

namespace candelabra {

/// Copy-on-write handle. Never empty. Used where a value is big and declared objects are copied
/// often.
template <class T>
class Shared {
public:
    using Content = T;
    Shared() : value_(make_handle<T>()) {}
    Shared(T value) : value_(make_handle<T>(std::move(value))) {}
    /// Precondition: not null.
    explicit Shared(Handle<T> value) : value_(std::move(value)) {}

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }
    /// The value for writing, unshared.
    T& edit() { return value_.edit(); }

private:
    Handle<T> value_;
};

}  // namespace candelabra
