#pragma once

#include <nlohmann/json.hpp>

// The members of both kinds of JSON values are compiled once, in json.cpp, not in each source that uses them.
extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
