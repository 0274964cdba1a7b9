// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/guarded_files.h"

#include <algorithm>
#include <cstring>

namespace candelabra {

namespace {

/// Bytes in memory as a file that can be read.
class BytesFile : public Assimp::IOStream {
public:
    explicit BytesFile(std::string_view bytes) : bytes_(bytes) {}

    std::size_t Read(void* to, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t read = std::min(count, (bytes_.size() - place_) / size);
        std::memcpy(to, bytes_.data() + place_, read * size);
        place_ += read * size;
        return read;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t from = origin == aiOrigin_SET   ? 0
                                 : origin == aiOrigin_CUR ? place_
                                                          : bytes_.size();
        // Offsets are unsigned and wrap around where they lead back.
        const std::size_t place = from + offset;
        if (place > bytes_.size()) return aiReturn_FAILURE;
        place_ = place;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return place_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

private:
    std::string_view bytes_;
    std::size_t place_ = 0;
};

}  // namespace

const std::string_view* GuardedFiles::find(const char* name) const {
    const auto [found, added] = files_.try_emplace(name);
    File& file = found->second;
    if (added && name == name_) {
        file.is_there = true;
        file.bytes = bytes_;
    } else if (added) {
        file.is_there = beside_.read(beside_.context, name, file.text);
        file.bytes = file.text;
    }
    return file.is_there ? &file.bytes : nullptr;
}

bool GuardedFiles::Exists(const char* name) const { return find(name) != nullptr; }

Assimp::IOStream* GuardedFiles::Open(const char* name, const char* mode) {
    if (std::strpbrk(mode, "wa+")) return nullptr;
    const std::string_view* const bytes = find(name);
    return bytes ? new BytesFile(*bytes) : nullptr;
}

bool GuardedFiles::ComparePaths(const char* one, const char* second) const {
    return std::strcmp(one, second) == 0;
}

}  // namespace candelabra
