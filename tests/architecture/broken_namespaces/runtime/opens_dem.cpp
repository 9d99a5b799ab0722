// SPDX-License-Identifier: BSD-3-Clause
namespace dem {
int of_both_programs();
}
