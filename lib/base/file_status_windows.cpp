// SPDX-License-Identifier: BSD-3-Clause
// See file_status.h.
#include "base/file_status.h"

#include <io.h>
#include <windows.h>

#include <algorithm>

namespace base {
namespace {

FileStatus status_of_handle(HANDLE file) {
    const DWORD type = GetFileType(file);
    if (type == FILE_TYPE_PIPE) return {FileKind::pipe, {}};
    BY_HANDLE_FILE_INFORMATION info = {};
    if (type != FILE_TYPE_DISK || !GetFileInformationByHandle(file, &info)) return {FileKind::other, {}};
    const auto whole = [](DWORD high, DWORD low) { return uint64_t(high) << 32 | low; };
    const uint64_t changed = whole(info.ftLastWriteTime.dwHighDateTime, info.ftLastWriteTime.dwLowDateTime);
    const bool folder = info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY;
    return {folder ? FileKind::folder : FileKind::ordinary,
            {info.dwVolumeSerialNumber, whole(info.nFileIndexHigh, info.nFileIndexLow),
             whole(info.nFileSizeHigh, info.nFileSizeLow), changed / 10000000, changed % 10000000 * 100}};
}

}  // namespace

FileStatus status_of(const std::string& path) {
    const DWORD anyone = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    const HANDLE file = CreateFileA(path.c_str(), FILE_READ_ATTRIBUTES, anyone, nullptr, OPEN_EXISTING,
                                    FILE_FLAG_BACKUP_SEMANTICS, nullptr);  // folders, too
    if (file == INVALID_HANDLE_VALUE) {
        may_read(path);  // says why
        return {};
    }
    const FileStatus status = status_of_handle(file);
    CloseHandle(file);
    return status;
}

FileStatus status_of(int descriptor) {
    const HANDLE file = reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
    return file == INVALID_HANDLE_VALUE ? FileStatus{} : status_of_handle(file);
}

bool is_absolute(const std::string& path) { return path[0] == '/' || path[0] == '\\' || path.find(':') == 1; }
const char between_folders = ';';

bool may_read(const std::string& path) { return _access(path.c_str(), 4) == 0; }
bool may_write_in(const std::string& folder) { return _access(folder.c_str(), 2) == 0; }

std::vector<std::string> files_like(const std::string& pattern) {
    std::vector<std::string> files;
    WIN32_FIND_DATAA found;
    const HANDLE search = FindFirstFileA(pattern.c_str(), &found);
    if (search == INVALID_HANDLE_VALUE) return files;
    const std::string folder = pattern.substr(0, pattern.rfind('/') + 1);
    do
        if (found.cFileName[0] != '.') files.push_back(folder + found.cFileName);
    while (FindNextFileA(search, &found));
    FindClose(search);
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace base
