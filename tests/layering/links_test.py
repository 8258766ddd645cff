#!/usr/bin/env python3
"""The test of links can fail: each small bad tree yields its one broken link, and a good tree yields none."""
import os
import tempfile
import unittest

import links

GOOD = {
    'README.md': '# Front\n[in](sub/README.md#two-words) ![picture](sub/a.png "title") [out](https://example.org/x#y)\n'
                 '`[code](gone.md)`\n```\n[code](gone.md)\n# no-heading\n```\n[here](#front) [twice](sub/README.md#again-1)\n'
                 '[![picture](sub/a.png)](sub/README.md) [folder](sub) <img src="sub/a.png">\n',
    'sub/README.md': '# Two words\n## Again\n## Again\n[up](../README.md#front)\n',
    'sub/a.png': '',
    'build/x.md': '[nowhere](gone.md)\n', '.cache/x.md': '[nowhere](gone.md)\n',
}


def broken(files):
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            full = os.path.join(root, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, 'w', encoding='utf-8') as out:
                out.write(text)
        return links.broken_links(root)


class Links(unittest.TestCase):
    def refuses(self, text, why, page='sub/bad.md'):
        found = broken({**GOOD, page: '# Bad\n' + text + '\n'})
        self.assertEqual([(page, 2)], [each[:2] for each in found], found)
        self.assertIn(why, found[0][2])

    def test_accepts_links_with_an_existing_target(self):
        self.assertEqual([], broken(GOOD))

    def test_rejects_a_missing_page_or_image(self):
        self.refuses('[page](README2.md)', 'is not there')
        self.refuses('![picture](b.png)', 'is not there')
        self.refuses('<img src="b.png">', 'is not there')
        self.refuses('[the page]: gone.md', 'is not there')

    def test_rejects_a_path_valid_only_in_another_folder(self):
        self.refuses('[page](sub/README.md)', 'is not there')

    def test_rejects_an_image_inside_a_link(self):
        self.refuses('[![picture](b.png)](README.md)', 'is not there')
        self.refuses('[![picture](a.png)](gone.md)', 'is not there')

    def test_rejects_a_missing_heading(self):
        self.refuses('[heading](README.md#three-words)', 'no such heading')
        self.refuses('[heading](#good)', 'no such heading')
        self.refuses('[heading](README.md#again-2)', 'no such heading')
        self.refuses('[heading](../README.md#no-heading)', 'no such heading')

    def test_rejects_paths_outside_the_repository_or_from_its_root(self):
        self.refuses('[page](/sub/README.md)', 'no path from the page')
        self.refuses('[page](../../other/README.md)', 'leads out of the repository')


if __name__ == '__main__':
    unittest.main()
