#!/usr/bin/env python3
"""Fails on a link of a Markdown page that leads nowhere.

links.py ROOT prints `page:line: why` for each link or picture below ROOT whose file, or whose heading in a page, is not
there, and exits with 1 if there is one. Links to other sites are not followed.
"""
import os
import re
import sys

BUILD_FOLDER = re.compile(r'build(-.*)?$')
FENCE = re.compile(r'\s*(```|~~~)')
CODE = re.compile(r'(`+).*?\1')
# [text](target), ![text](target "title"), [name]: target, <img src="target">, <a href="target">.
LINKS = [re.compile(r'\]\(\s*<?([^)\s>]*)'), re.compile(r'^\s*\[[^\]]+\]:\s*<?([^\s>]+)'),
         re.compile(r'<(?:img|a)\b[^>]*?\b(?:src|href)\s*=\s*["\']([^"\']*)')]
ELSEWHERE = re.compile(r'[A-Za-z][A-Za-z0-9+.-]*:')


def broken_links(root):
    """Every link below root that leads nowhere, as (page, line, why); the page is relative to root."""
    found = []
    for page in pages(root):
        folder = os.path.dirname(os.path.join(root, page))
        for number, line in lines_of_text(os.path.join(root, page)):
            for link in links_of(line):
                why = objection(root, folder, os.path.join(root, page), link)
                if why:
                    found.append((page, number, f'{link}: {why}'))
    return found


def pages(root):
    """The Markdown files below root, without those of hidden folders and of builds."""
    for folder, folders, files in os.walk(root):
        top = folder == root
        folders[:] = sorted(f for f in folders if not f.startswith('.') and not (top and BUILD_FOLDER.match(f)))
        for name in sorted(files):
            if name.endswith('.md'):
                yield os.path.relpath(os.path.join(folder, name), root)


def lines_of_text(page):
    """(number, line) of a page, without blocks of code."""
    fence = None
    with open(page, encoding='utf-8') as lines:
        for number, line in enumerate(lines, 1):
            mark = FENCE.match(line)
            if mark and fence in (None, mark[1]):
                fence = None if fence else mark[1]
            elif not fence:
                yield number, line


def links_of(line):
    text = CODE.sub('', line)
    return [link for pattern in LINKS for link in pattern.findall(text)]


def objection(root, folder, page, link):
    """Why the link of a page in this folder leads nowhere, or None where it leads somewhere."""
    if ELSEWHERE.match(link):
        return None
    path, _, anchor = link.partition('#')
    if path.startswith('/'):
        return 'is no path from the page'
    target = os.path.normpath(os.path.join(folder, path)) if path else page
    if os.path.relpath(target, root).startswith('..'):
        return 'leads out of the repository'
    if not os.path.exists(target):
        return 'is not there'
    if anchor and (not target.endswith('.md') or anchor not in anchors(target)):
        return 'has no such heading'
    return None


def anchors(page):
    """The names by which links reach the headings of a page, as GitHub makes them."""
    names, times = set(), {}
    for _, line in lines_of_text(page):
        heading = re.match(r'#{1,6} +(.*?)(?: +#+)?\s*$', line)
        if heading:
            name = re.sub(r'[^\w\- ]', '', heading[1].lower()).replace(' ', '-')
            times[name] = times.get(name, -1) + 1
            names.add(f'{name}-{times[name]}' if times[name] else name)
    return names


def main(root):
    found = broken_links(root)
    for page, line, why in found:
        print(f'{page}:{line}: {why}')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
