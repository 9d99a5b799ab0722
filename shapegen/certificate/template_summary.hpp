// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/wall_template.hpp"

#include <string>

/// What `shapegen inspect` prints about a template file.
namespace dem::shapegen {

/// For people: a few lines per shape; of a library of more than ten shapes the first ones and the
/// ranges. Ends with a line end.
std::string template_text(const TemplateFile& file);

/// For programs: the object described in docs/template-format.md. Ends with a line end.
std::string template_json(const TemplateFile& file);

/// The same of a wall; of `file` all but the shapes.
std::string template_text(const TemplateFile& file, const WallTemplate& wall);
std::string template_json(const TemplateFile& file, const WallTemplate& wall);

}  // namespace dem::shapegen
