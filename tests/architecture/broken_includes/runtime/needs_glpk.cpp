// SPDX-License-Identifier: BSD-3-Clause
// Not compiled: the include check must find this line.
#include <glpk.h>
