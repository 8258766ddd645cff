#pragma once

#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

// Record the command line, the name of the program first, and the input files as the user named them, for
// the reports of this run.
void record_command(std::vector<std::string> words);
void record_inputs(std::vector<std::string> files);
// Records the unit of mesh files that state none, for all reports of this run; by default the metre.
void record_mesh_unit(FileUnit unit);

// Returns the units of the numbers of a report, and that of mesh files.
nlohmann::ordered_json units_json();

// Returns the report with the version, the command line, the inputs and the units of all numbers in front.
nlohmann::ordered_json with_run_description(const nlohmann::ordered_json& report);

}  // namespace kerf
