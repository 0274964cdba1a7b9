// SPDX-License-Identifier: GPL-3.0-or-later
// All blocks lie in memory, which is used whole.
#include "base/zeroed_pages.h"

#include <cstdlib>
#include <new>
#include <utility>

namespace candelabra {

namespace {

void* zeroed(std::size_t bytes) {
    if (bytes == 0) return nullptr;
    void* const found = std::calloc(bytes, 1);
    if (!found) throw std::bad_alloc();
    return found;
}

}  // namespace

ZeroedPages::ZeroedPages(std::size_t bytes) : begin_(zeroed(bytes)), bytes_(bytes) {}

ZeroedPages ZeroedPages::sparse(std::size_t bytes) { return {zeroed(bytes), bytes, false}; }

std::optional<ZeroedPages> ZeroedPages::in_file(const std::string&, std::size_t bytes) {
    return bytes == 0 ? std::optional(ZeroedPages()) : std::nullopt;
}

ZeroedPages::~ZeroedPages() { std::free(begin_); }

ZeroedPages::ZeroedPages(ZeroedPages&& other) noexcept
    : begin_(std::exchange(other.begin_, nullptr)),
      bytes_(std::exchange(other.bytes_, 0)),
      in_file_(other.in_file_) {}

ZeroedPages& ZeroedPages::operator=(ZeroedPages&& other) noexcept {
    std::swap(begin_, other.begin_);
    std::swap(bytes_, other.bytes_);
    std::swap(in_file_, other.in_file_);
    return *this;
}

void ZeroedPages::let_go() const {}

}  // namespace candelabra
