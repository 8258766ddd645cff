#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kerf {

// The ten digits as bitmaps made for this program, rows from the top.
inline constexpr int kDigitWidth = 5, kDigitHeight = 8;
inline constexpr std::array<std::array<std::string_view, kDigitHeight>, 10> kDigits{{
    {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "},
    {"  #  ", " ##  ", "# #  ", "  #  ", "  #  ", "  #  ", "  #  ", "#####"},
    {" ### ", "#   #", "    #", "    #", "  ## ", " #   ", "#    ", "#####"},
    {" ### ", "#   #", "    #", "  ## ", "    #", "    #", "#   #", " ### "},
    {"   # ", "  ## ", " # # ", "#  # ", "#  # ", "#####", "   # ", "   # "},
    {"#####", "#    ", "#    ", "#### ", "    #", "    #", "#   #", " ### "},
    {" ### ", "#   #", "#    ", "#### ", "#   #", "#   #", "#   #", " ### "},
    {"#####", "    #", "    #", "   # ", "   # ", "  #  ", "  #  ", "  #  "},
    {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", "#   #", " ### "},
    {" ### ", "#   #", "#   #", "#   #", " ####", "    #", "#   #", " ### "},
}};

}  // namespace kerf
