// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/file.h"

#include "text/message.h"
#include "text/printable.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

std::string reason(int number) { return std::strerror(number); }

/// Returns 0, or the error number of the failure.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) return errno;
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

int write_in_place(const std::string& path, std::string_view bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) return errno;
    const int failure = write_all(file, bytes);
    return ::close(file) != 0 && failure == 0 ? errno : failure;
}

/// A new, empty file in the folder, open for writing.
struct Draft {
    int file = -1;
    std::string path;
};

Draft open_draft(const fs::path& folder) {
    Draft draft;
    for (int attempt = 0; attempt < 100 && draft.file < 0; ++attempt) {
        draft.path = (folder / message(".candelabra-", ::getpid(), "-", attempt)).string();
        draft.file = ::open(draft.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (draft.file < 0 && errno != EEXIST) break;
    }
    return draft;
}

int replace(const fs::path& path, std::string_view bytes, const struct stat* old) {
    const Draft draft = open_draft(path.has_parent_path() ? path.parent_path() : fs::path("."));
    // The file may be writable even though its folder is not.
    if (draft.file < 0) return old ? write_in_place(path.string(), bytes) : errno;
    int failure = write_all(draft.file, bytes);
    if (old && failure == 0 && ::fchmod(draft.file, old->st_mode & 07777) != 0) failure = errno;
    // Without this, a power failure could leave the new name with none of the bytes. Some file
    // systems do not support it.
    if (failure == 0 && ::fdatasync(draft.file) != 0 && errno != EINVAL) failure = errno;
    if (::close(draft.file) != 0 && failure == 0) failure = errno;
    if (failure == 0 && ::rename(draft.path.c_str(), path.c_str()) != 0) failure = errno;
    if (failure != 0) ::unlink(draft.path.c_str());
    return failure;
}

/// Returns the status of the file at the path, following links; nothing if there is no file.
std::optional<struct stat> state_of(const std::string& path) {
    struct stat state {};
    if (::stat(path.c_str(), &state) != 0) return std::nullopt;
    return state;
}

int write_to(const std::string& path, std::string_view bytes) {
    if (path == "-") return write_all(STDOUT_FILENO, bytes);
    const auto old = state_of(path);
    if (!old) return replace(path, bytes, nullptr);
    if (!S_ISREG(old->st_mode)) return S_ISDIR(old->st_mode) ? EISDIR : write_in_place(path, bytes);
    std::error_code failed;
    const fs::path target = fs::canonical(path, failed);  // a link stays a link
    return replace(failed ? fs::path(path) : target, bytes, &*old);
}

}  // namespace

bool write_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics) {
    const int failure = write_to(path, bytes);
    if (failure == 0) return true;
    const std::string what = path == "-" ? "standard output" : message("`", printable(path), "`");
    diagnostics.add(error(Fault::io, {}, message("cannot write ", what, ": ", reason(failure))));
    return false;
}

std::string problem_with_destination(const std::string& path) {
    if (path == "-") return {};
    const std::string name = printable(path);
    if (const auto old = state_of(path)) {
        if (S_ISDIR(old->st_mode)) return message("cannot write `", name, "`: it is a folder");
        if (::access(path.c_str(), W_OK) != 0)
            return message("cannot write `", name, "`: ", reason(errno));
        return {};
    }
    const std::string folder =
        fs::path(path).has_parent_path() ? fs::path(path).parent_path().string() : ".";
    const auto there = state_of(folder);
    if (!there)
        return message("cannot write `", name, "`: there is no folder `", printable(folder), "`");
    if (!S_ISDIR(there->st_mode))
        return message("cannot write `", name, "`: `", printable(folder), "` is not a folder");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return message("cannot write `", name, "` in its folder: ", reason(errno));
    return {};
}

}  // namespace candelabra
