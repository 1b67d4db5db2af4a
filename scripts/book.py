#!/usr/bin/env python3
"""Preprocessor of mdbook: links that lead out of docs/ become the file's name in the repository, and pictures there become part of the page.

mdbook calls it as book.toml says. It reads the book as JSON and writes it again.

    python3 scripts/book.py check target/book    # after `mdbook build`: fails if a link of the book leads nowhere
"""

import base64
import html
import json
import pathlib
import re
import sys

TARGET = re.compile(r'(?:href|src)="([^"#]+)')
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s#]+)(#[^)\s]*)?\)")


def outside(source, page, link):
    """The file in the repository that a link of a page names, if it is not in the book."""
    if "://" in link:
        return None
    target = (source / page).parent.joinpath(link).resolve()
    return None if target.is_relative_to(source) else target


def rewritten(source, page, text):
    def replace(match):
        picture, words, link, _ = match.groups()
        target = outside(source, page, link)
        if target is None:
            return match.group(0)
        if picture:
            data = base64.b64encode(target.read_bytes()).decode()
            return f"![{words}](data:image/svg+xml;base64,{data})"
        name = target.relative_to(source.parent).as_posix()
        return f"`{name}`" if words.strip("`") == name else f"{words} (`{name}` in the repository)"

    return LINK.sub(replace, text)


def walk(source, items):
    for item in items:
        chapter = item.get("Chapter") if isinstance(item, dict) else None
        if chapter:
            if chapter["path"]:
                chapter["content"] = rewritten(source, chapter["path"], chapter["content"])
            walk(source, chapter["sub_items"])


def broken(folder):
    """Links of the pages of a built book that lead to no file, and the number of all links."""
    links = [(page, html.unescape(link)) for page in sorted(folder.rglob("*.html")) for link in TARGET.findall(page.read_text())]
    local = [(page, link) for page, link in links if "://" not in link and not link.startswith(("data:", "mailto:"))]
    return [f"{page}: {link}" for page, link in local if not (page.parent / link).exists()], len(local)


def main():
    if sys.argv[1:2] == ["supports"]:
        return
    if sys.argv[1:2] == ["check"]:
        wrong, number = broken(pathlib.Path(sys.argv[2]))
        if wrong:
            sys.exit("\n".join(wrong))
        print(f"{number} links, all lead to a file")
        return
    context, book = json.load(sys.stdin)
    source = pathlib.Path(context["root"], context["config"]["book"]["src"]).resolve()
    walk(source, book.get("items", book.get("sections")))
    json.dump(book, sys.stdout)


if __name__ == "__main__":
    main()
