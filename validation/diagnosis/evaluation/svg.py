"""Charts in SVG: rates with their intervals, and matrices of what was concealed against what was answered."""

from .rates import wilson

INK, PALE, MARK = "#1b1f24", "#d0d7de", "#0b62a8"


class Picture:
    def __init__(self, width, height):
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="11" fill="{INK}">',
                      f'<rect width="{width}" height="{height}" fill="#ffffff"/>']

    def line(self, x1, y1, x2, y2, colour=INK, width=1.0, dash=""):
        dash = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" stroke-width="{width}"{dash}/>')

    def text(self, x, y, said, anchor="middle", turn=0, size=11, colour=INK):
        turn = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" fill="{colour}"{turn}>{said}</text>')

    def box(self, x, y, w, h, fill, edge="none"):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{w:.1f}" height="{h:.1f}" fill="{fill}" stroke="{edge}"/>')

    def dot(self, x, y, r=3.0):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" fill="{MARK}"/>')

    def svg(self):
        return "\n".join(self.parts) + "\n</svg>\n"


def axes(p, x, y, w, h, title, xticks, across, up):
    for v in (0, 50, 100):
        level = y + h * (1 - v / 100)
        p.line(x, level, x + w, level, PALE)
        p.text(x - 5, level + 4, f"{v}", "end", size=9)
    p.line(x, y + h, x + w, y + h)
    for at, said in xticks:
        p.line(x + w * at, y + h, x + w * at, y + h + 3)
        p.text(x + w * at, y + h + 13, said, size=9)
    p.text(x + w / 2, y - 6, title)
    if across:
        p.text(x + w / 2, y + h + 26, across, size=9)
    if up:
        p.text(x - 28, y + h / 2, up, turn=-90, size=9)


def bars(p, x, y, w, h, groups):
    """Rates with intervals: (place 0..1, hits, n)."""
    last = None
    for at, hits, n in groups:
        if not n:
            continue
        cx, cy = x + w * at, y + h * (1 - hits / n)
        low, high = wilson(hits, n)
        p.line(cx, y + h * (1 - low), cx, y + h * (1 - high), MARK, 1.0)
        if last:
            p.line(*last, cx, cy, MARK, 1.4)
        p.dot(cx, cy)
        p.text(cx + 5, cy - 4 if hits < n else cy + 11, f"{n}", "start", size=8, colour="#57606a")
        last = cx, cy


def matrix(pairs, legend):
    """A picture of pairs (concealed, told)."""
    truths = sorted({c for c, _ in pairs}, key=lambda c: (c in ("none", "unknown"), c))
    said = truths + sorted({v for _, v in pairs} - set(truths))
    cell, left, top = 22, 170, 170
    p = Picture(left + cell * len(said) + 100, top + cell * len(truths) + 40)
    for j, name in enumerate(said):
        p.text(left + cell * (j + 0.5) + 4, top - 6, name.replace("_", " "), "start", turn=-60, size=10)
    for i, name in enumerate(truths):
        mine = [v for c, v in pairs if c == name]
        p.text(left - 6, top + cell * (i + 0.5) + 4, f"{name.replace('_', ' ')} ({len(mine)})", "end", size=10)
        for j, other in enumerate(said):
            n = mine.count(other)
            share = n / len(mine)
            shade = tuple(round(255 + share * (c - 255)) for c in ((11, 98, 168) if name == other else (178, 60, 40)))
            p.box(left + cell * j, top + cell * i, cell, cell, "rgb(%d,%d,%d)" % shade, PALE)
            if n:
                p.text(left + cell * (j + 0.5), top + cell * (i + 0.5) + 4, str(n), size=10, colour="#ffffff" if share > 0.55 else INK)
    p.text(10, top + cell * len(truths) + 22, legend, "start", size=10)
    return p.svg()
