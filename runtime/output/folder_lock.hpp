// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace dem::runtime {

/// Keeps other runs out of a folder for as long as it lives, so that two of them cannot mix their
/// files. The system holds the lock for the process, however that ends: the file `.demrun.lock`
/// that stays behind blocks nobody. A folder that was made for a run that then wrote nothing goes.
class FolderLock {
  public:
    /// Makes the folder when it is missing. Throws Error when that is impossible, the folder cannot
    /// be written or another run has locked it. A file system without locks is taken as it is.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    std::filesystem::path folder_;
    bool is_new_ = false;  ///< made by this lock
    int descriptor_ = -1;
};

}  // namespace dem::runtime
