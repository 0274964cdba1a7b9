// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/zeroed_pages.h"

#include <new>
#include <utility>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

namespace candelabra {

namespace {

void* mapped(std::size_t bytes, int flags) {
    if (bytes == 0) return nullptr;
    void* const found = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_ANONYMOUS | flags, -1, 0);
    if (found == MAP_FAILED) throw std::bad_alloc();
    return found;
}

}  // namespace

ZeroedPages::ZeroedPages(std::size_t bytes) : begin_(mapped(bytes, MAP_PRIVATE)), bytes_(bytes) {}

ZeroedPages ZeroedPages::sparse(std::size_t bytes) {
    return {mapped(bytes, MAP_SHARED | MAP_NORESERVE), bytes, false};
}

std::optional<ZeroedPages> ZeroedPages::in_file(const std::string& folder, std::size_t bytes) {
    if (bytes == 0) return ZeroedPages();
    std::string name = (folder.empty() ? "." : folder) + "/.candelabra-XXXXXX";
    const int file = mkostemp(name.data(), O_CLOEXEC);
    if (file < 0) return std::nullopt;
    unlink(name.c_str());
    // With all its room reserved: a full disk would end the program at any later write.
    void* found = MAP_FAILED;
    if (posix_fallocate(file, 0, static_cast<off_t>(bytes)) == 0)
        found = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    if (found == MAP_FAILED) return std::nullopt;
    return ZeroedPages(found, bytes, true);
}

ZeroedPages::~ZeroedPages() {
    if (begin_) munmap(begin_, bytes_);
}

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

void ZeroedPages::let_go() const {
    // Of pages that are shared with a file, this only ends the mapping.
    if (in_file_) madvise(begin_, bytes_, MADV_DONTNEED);
}

}  // namespace candelabra
