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

constexpr auto leads_out = "it is a link that leads out of its folder";

/// Whether the name itself, rather than a folder before it, is a link.
bool is_link(const std::string& path) {
    struct stat state {};
    return ::lstat(path.c_str(), &state) == 0 && S_ISLNK(state.st_mode);
}

/// Whether the name is a link to something in another folder. The system's own links, such as
/// /dev/stdout, lead where the user wants. A link that leads nowhere is none that is followed.
bool is_link_out(const std::string& path) {
    if (!is_link(path)) return false;
    std::error_code failed;
    const fs::path folder = fs::path(path).parent_path();
    const fs::path here = fs::canonical(folder.empty() ? "." : folder, failed);
    for (const char* system : {"/dev", "/proc"})
        if (here == system || here.string().starts_with(std::string(system) + "/")) return false;
    const fs::path target = fs::canonical(path, failed);
    return !failed && target.parent_path() != here;
}

OpenedFile open_in_place(const std::string& path) {
    // The system's own links are those that are left.
    const int links = is_link(path) ? 0 : O_NOFOLLOW;
    return OpenedFile(
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOCTTY | O_CLOEXEC | links, 0666));
}

int write_in_place(const std::string& path, std::string_view bytes) {
    OpenedFile file = open_in_place(path);
    if (!file) return errno;
    const int failure = write_all(file.descriptor(), bytes);
    return ::close(file.release()) != 0 && failure == 0 ? errno : failure;
}

/// A new file in the folder, open for writing. It gets its name when it is complete, where the file
/// system can do that, so that nothing is left if the program ends before.
struct Draft {
    int file = -1;
    std::string path;  ///< empty: it has no name yet
};

Draft open_draft(const fs::path& folder, bool nameless) {
    Draft draft;
    if (nameless) {
        draft.file = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
        return draft;
    }
    for (int attempt = 0; attempt < 100 && draft.file < 0; ++attempt) {
        draft.path = (folder / message(".candelabra-", ::getpid(), "-", attempt)).string();
        draft.file = ::open(draft.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (draft.file < 0 && errno != EEXIST) break;
    }
    return draft;
}

/// Gives a draft without a name one. Returns false on failure.
bool name_draft(Draft& draft, const fs::path& folder) {
    const std::string link = message("/proc/self/fd/", draft.file);
    for (int attempt = 0; attempt < 100 && draft.path.empty(); ++attempt) {
        const std::string name =
            (folder / message(".candelabra-", ::getpid(), "-", attempt)).string();
        if (::linkat(AT_FDCWD, link.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0)
            draft.path = name;
        else if (errno != EEXIST)
            break;
    }
    return !draft.path.empty();
}

/// Fills a draft and puts it into the place of the path. Returns 0, an error number, or -1 if this
/// kind of draft is not possible here.
int replace_by_draft(const fs::path& path, std::string_view bytes, const struct stat* old,
                     bool nameless) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    Draft draft = open_draft(folder, nameless);
    if (draft.file < 0) return -1;
    int failure = write_all(draft.file, bytes);
    if (old && failure == 0 && ::fchmod(draft.file, old->st_mode & 07777) != 0) failure = errno;
    // Without this, a power failure could leave the new name with none of the bytes. Some file
    // systems do not support it.
    if (failure == 0 && ::fdatasync(draft.file) != 0 && errno != EINVAL) failure = errno;
    if (failure == 0 && nameless && !name_draft(draft, folder)) failure = -1;
    if (::close(draft.file) != 0 && failure == 0) failure = errno;
    if (failure == 0 && ::rename(draft.path.c_str(), path.c_str()) != 0) failure = errno;
    if (failure != 0 && !draft.path.empty()) ::unlink(draft.path.c_str());
    return failure;
}

int replace(const fs::path& path, std::string_view bytes, const struct stat* old) {
    for (const bool nameless : {true, false})
        if (const int failure = replace_by_draft(path, bytes, old, nameless); failure != -1)
            return failure;
    // The file may be writable even though its folder is not.
    const int why = errno;
    return old ? write_in_place(path.string(), bytes) : why;
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

int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) return errno;
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

OpenedFile open_growing_file(const std::string& path) {
    if (is_link_out(path)) return {};
    const auto old = state_of(path);
    if (is_link(path) && !old) ::unlink(path.c_str());  // it leads nowhere, perhaps elsewhere
    std::error_code failed;
    const bool regular = old && S_ISREG(old->st_mode);
    const fs::path target = regular ? fs::canonical(path, failed) : fs::path(path);
    return open_in_place(failed ? path : target.string());
}

bool write_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics) {
    const bool out = is_link_out(path);
    const int failure = out ? ELOOP : write_to(path, bytes);
    if (failure == 0) return true;
    const std::string what = path == "-" ? "standard output" : message("`", printable(path), "`");
    diagnostics.add(
        error(Fault::io, {},
              message("cannot write ", what, ": ", out ? leads_out : reason(failure)))
            .with_help(out ? "remove the link, or name the file that it leads to" : ""));
    return false;
}

std::string problem_with_destination(const std::string& path) {
    if (path == "-") return {};
    const std::string name = printable(path);
    if (is_link_out(path)) return message("cannot write `", name, "`: ", leads_out);
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
