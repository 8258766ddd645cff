# Writes the man page OUT of program KERF, version VERSION, from its help and that of its subcommands.
cmake_policy(VERSION 3.25)

string(ASCII 1 semicolon)
string(ASCII 2 left)
string(ASCII 3 right)

# Escapes text for troff, so that no part of it is a request.
function(escaped result text)
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REGEX REPLACE "(^|\n)([.'])" "\\1\\\\&\\2" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

function(help_of result)
  execute_process(COMMAND ${KERF} ${ARGN} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${help}" PARENT_SCOPE)
endfunction()

# Appends a help without its first line, the purpose: the usage, a tagged paragraph for each argument and option, the
# other text unfilled. Lists of CMake end at semicolons and stumble over brackets, so both are replaced meanwhile.
function(append_help help)
  string(FIND "${help}" "\n" end)
  string(SUBSTRING "${help}" ${end} -1 help)
  string(REGEX REPLACE "\n+Subcommands:.*" "\n" help "${help}")
  string(REGEX REPLACE "\n+Example:\n.*" "\n" help "${help}")
  string(REPLACE ";" "${semicolon}" help "${help}")
  string(REPLACE "[" "${left}" help "${help}")
  string(REPLACE "]" "${right}" help "${help}")
  string(REPLACE "\n" ";" lines "${help}")
  set(unfilled "")
  foreach(line IN LISTS lines)
    string(REPLACE "${semicolon}" ";" line "${line}")
    string(REPLACE "${left}" "[" line "${line}")
    string(REPLACE "${right}" "]" line "${line}")
    escaped(text "${line}")
    if(line MATCHES "^Usage: ")
      string(REPLACE "Usage: " "" text "${text}")
      string(APPEND page ".PP\n${text}\n")
    elseif(line MATCHES "^(Positionals|Options):$" OR line STREQUAL "")
      if(unfilled)
        string(APPEND unfilled "\n")
      endif()
    elseif(NOT unfilled AND text MATCHES "^  ([^ ]+)(( (TEXT|INT|UINT|FLOAT|REQUIRED|[.][.][.]|Needs: [^ ]+))*)  *([^ ].*)$")
      set(name "${CMAKE_MATCH_1}")
      set(meaning "${CMAKE_MATCH_5}")
      string(STRIP "${CMAKE_MATCH_2}" kind)
      string(REGEX REPLACE " ?(REQUIRED|Needs: [^ ]+)" "" kind "${kind}")
      if(NOT name MATCHES "^.?.?\\\\-")  # an argument, whose name is its kind
        string(REGEX REPLACE "^TEXT ?" "" kind "${kind}")
      endif()
      string(APPEND page ".TP\n\\fB${name}\\fR \\fI${kind}\\fR\n${meaning}.\n")
    else()
      string(APPEND unfilled "${text}\n")
    endif()
  endforeach()
  string(STRIP "${unfilled}" stripped)
  if(stripped)
    string(APPEND page ".PP\n.nf\n${unfilled}.fi\n")
  endif()
  set(page "${page}" PARENT_SCOPE)
endfunction()

help_of(help)
set(page ".TH KERF 1 \"\" \"kerf ${VERSION}\" \"User Commands\"\n.SH NAME\nkerf \\- cut triangle meshes with a laser, live\n")
string(APPEND page ".SH SYNOPSIS\n.B kerf\n[\\fIOPTIONS\\fR] [\\fIFILE\\fR...]\n.br\n.B kerf\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n")
string(APPEND page ".SH DESCRIPTION\nKerf cuts triangle meshes with the beam of a laser. Without a command it opens the files in the editor. "
  "All other commands but\n.B play\nneed no display. Lengths are in metres, angles in degrees, power in watts, temperatures in kelvin.\n")
string(APPEND page ".SH OPTIONS\n")
append_help("${help}")

string(APPEND page ".SH COMMANDS\n")
set(examples "")
string(REGEX REPLACE "^.*\nSubcommands:\n" "\n" list "${help}")
string(REGEX MATCHALL "\n  [a-z]+ " names "${list}")
foreach(name IN LISTS names)
  string(STRIP "${name}" name)
  help_of(help ${name})
  string(REGEX MATCH "^[^\n]*" purpose "${help}")
  escaped(purpose "${purpose}")
  string(APPEND page ".SS kerf ${name}\n${purpose}.\n")
  append_help("${help}")
  string(REGEX MATCH "Example:\n *([^\n]*)" example "${help}")
  string(REPLACE "assets/" "/usr/share/kerf/" example "${CMAKE_MATCH_1}")
  escaped(example "${example}")
  string(APPEND examples ".PP\n${purpose}:\n.PP\n.RS\n.nf\n${example}\n.fi\n.RE\n")
endforeach()

string(APPEND page [[
.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
It could not be done: a full disk, no OpenGL, a hash that differs.
.TP
.B 2
The input or the command line is wrong.
.TP
.BR 130 ", " 143
Stopped by Ctrl\-C or by SIGTERM.
.PP
With 1 and 2, one line on standard error states what failed, where, and what to do.
.SH ENVIRONMENT
.TP
.B KERF_THREADS
Maximum number of threads, from 1 to 1024. Default: one per processor.
.TP
.B KERF_SIMD
Instruction set of tree queries: \fBplain\fR, \fBsse4\fR or \fBavx2\fR. Results do not depend on it.
Default: the best one of the processor.
.TP
.B KERF_ASSERTS=fatal
Ends the program at the first violated precondition and names its place.
.TP
.BR DISPLAY ", " WAYLAND_DISPLAY
Display of the editor and the game.
.TP
.BR XDG_CONFIG_HOME ", " XDG_STATE_HOME
Folders of settings and of autosaved journals. Defaults: \fI~/.config\fR and \fI~/.local/state\fR.
.SH FILES
.TP
.I /usr/share/kerf
Meshes, scenes, materials and shaders; \fIPREFIX/share/kerf\fR for another prefix.
.TP
.I $XDG_CONFIG_HOME/kerf
Settings of the editor and the game, and the window layout.
.TP
.I $XDG_STATE_HOME/kerf
Autosaved journals, high scores, and worlds of matches opened in the editor.
.SH EXAMPLES
]])
string(APPEND page "${examples}")
string(APPEND page ".SH BUGS\nThe best report of a bug is a journal: save the document after the fault, or pass\n.B \\-\\-journal\nto\n.BR \"kerf cut\" .\n")
file(WRITE ${OUT} "${page}")
