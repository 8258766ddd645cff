#!/usr/bin/env python3
"""Wrong formats do not compile, and the search for formats that are not checked can fail.

formats_test.py COMPILER ROOT FLAG... compiles small sources with the flags of the project.
"""
import re
import subprocess
import sys
import unittest

import formats

HEAD = """
#include <imgui.h>
#include <cstdio>
#include "ui/window/number_text.h"
#include "ui/window/number_text.h"
void widget(kerf::RealFormat);
void whole(kerf::WholeFormat);
"""
GOOD = ['ImGui::Text("%d %% of", 1);', 'kerf::text_of("%.0f %% of %s", 1.0, "it");', 'widget("%.1f %%");',
        'whole("%d MB");', 'whole("all");', 'ImGui::TextUnformatted(text);', 'widget("%+-08.3e");']
BAD = ['ImGui::Text("%d", 1.0);', 'ImGui::Text("%.0f % of the way", 1.0);', 'ImGui::TextWrapped(text);',
       'ImGui::SetTooltip("%s", 1);', 'ImGui::TextDisabled(text, 1.0);', 'kerf::text_of("%.0f % of the way", 1.0);',
       'kerf::text_of("%s", 1.0);', 'kerf::text_of(text);', 'std::snprintf(room, sizeof room, text, 1.0);',
       'widget("%.0f % of");', 'widget("%d");', 'widget("%.1f %.1f");', 'widget("100 %");', 'whole("%.1f");',
       'whole("%ld");']


def refused_of(statements):
    """The statements that the compiler refuses, and what it says."""
    compiler, root, *flags = ARGUMENTS
    body = '\n'.join(statements)
    source = f'{HEAD}void body(const char* text, char (&room)[9]) {{\n(void)text, (void)room;\n{body}\n}}\n'
    done = subprocess.run([compiler, '-x', 'c++', '-std=c++20', '-fsyntax-only', '-Werror', '-I', root, *flags, '-'],
                          input=source, text=True, capture_output=True, check=False)
    first = source[:source.index(body)].count('\n') + 1
    lines = {int(line) for line in re.findall(r'<stdin>:(\d+):\d+: (?:error|  in .constexpr. expansion)', done.stderr)}
    return [statement for i, statement in enumerate(statements) if first + i in lines], done.stderr


class Formats(unittest.TestCase):
    def test_valid_formats_compile(self):
        refused, said = refused_of(GOOD)
        self.assertEqual(refused, [], said)

    def test_invalid_formats_do_not_compile(self):
        refused, said = refused_of(BAD)
        self.assertEqual(refused, BAD, said)

    def test_unchecked_formats_are_detected(self):
        bad = ['x(ImGui::SliderFloat("a", &x, f(1), 2, "%.2f m"));',
               'ImGui::InputScalar("a)", t, &x,\n nullptr, "%d");',
               'bool field(const char* format);', 'void f(const char *format, int);']
        good = ['ImGui::SliderFloat("a", &x, f(1), 2, RealFormat("%.2f \\" (m").c_str());',
                'ImGui::SliderInt("a", &x); y("%d");', 'bool field(const RealFormat& format);',
                'std::string text_of(const char* format, ...);']
        for text in bad:
            self.assertEqual(len(list(formats.breaches_in(text))), 1, text)
        for text in good:
            self.assertEqual(list(formats.breaches_in(text)), [], text)


if __name__ == '__main__':
    ARGUMENTS = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
