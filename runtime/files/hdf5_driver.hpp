// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/journaled_file.hpp"

#include <hdf5.h>

namespace dem::runtime {

/// Lets HDF5 work on a journaled file, for as long as that lives: sets the driver of a property
/// list for file access. HDF5 then never hears of a failure to write, after which it could not even
/// close the file; JournaledFile::commit tells it.
herr_t use_journaled_file(hid_t access, JournaledFile& file);

}  // namespace dem::runtime
