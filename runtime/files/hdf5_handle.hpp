// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <hdf5.h>

namespace dem::runtime {

/// An open identifier of HDF5, closed by the function that belongs to its kind.
class Hdf5Handle {
  public:
    Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Hdf5Handle() {
        if (id_ >= 0) close_(id_);
    }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;

    operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor)
    bool is_valid() const { return id_ >= 0; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// What the innermost failed call of HDF5 says, without the library's own way there: the system's
/// message where there is one ("No space left on device"), else HDF5's.
std::string hdf5_reason();

/// Errors are thrown as ours; the library would print its whole stack.
void silence_hdf5();

}  // namespace dem::runtime
