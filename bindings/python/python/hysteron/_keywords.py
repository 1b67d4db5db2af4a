"""Names of the words of commands, from their usages: keyword arguments, signatures and help."""

import difflib
import inspect
import re
from functools import cache

from . import _hysteron
from ._hysteron import OpenSeesError

_USAGES = {name: (usage, kinds) for name, usage, kinds in _hysteron.script_usages()}
_NOTE = re.compile(r" \([^)]*\)")


def _usage(name, kind):
    """Usage in the notation of scripts of a command with a kind."""
    usage, kinds = _USAGES[name]
    return next((u for names, u in kinds if kind in names), usage)


def _group(words):
    """Nested lists of words: what is in angle brackets is a list."""
    out = []
    for word in words:
        if word == ">":
            break
        out.append(_group(words) if word == "<" else word)
    return out


class _Form:
    """One form of a usage: places by their names, and options."""

    def __init__(self, words, kind):
        #: Names of the places behind the kind; True for those that may be left out.
        self.places = []
        #: Option with its name in a usage, by the names that stand for it.
        self.options = {}
        #: Words of which one is chosen stand among the places.
        self.has_alternatives = "|" in words
        self._take(words, False)
        if kind is not None and self.places and self.places[0][0] is None:
            self.places.pop(0)

    def _take(self, words, optional):
        option = None
        for word in words:
            if isinstance(word, list):
                self._take(word, True)
            elif word.startswith("-"):
                option = word.split("|")[0]
                self.options.setdefault(option[1:], option)
            elif word.startswith("$"):
                names = [n.lstrip("$") for n in word.split("|")]
                for name in names:
                    if option is not None:
                        self.options.setdefault(name, option)
                if option is None:
                    self.places.append((names[0], optional))
            elif option is None and word not in ("|", "..."):
                # A word that stands as it is, such as the kind.
                self.places.append((None, optional))

    def _named(self, name):
        """The name in the usage that stands for a name: `E` for `E0`, and in small or large letters, where that is clear."""
        names = self.names
        if name in names:
            return name
        alike = [n for n in names if n.rstrip("0").lower() == name.lower()] or [n for n in names if n.lower() == name.lower()]
        return alike[0] if len(set(alike)) == 1 else name

    def place(self, given, keywords):
        """Words behind the kind; None and the reason where a name has no place."""
        words, left = list(given), {self._named(name): value for name, value in keywords.items()}
        unknown = next((n for n in left if n not in self.names), None)
        if unknown is not None:
            return None, f"there is no argument {unknown!r}"
        for i, (name, optional) in enumerate(self.places):
            if i < len(given):
                if name in left:
                    return None, f"{name!r} is given twice"
            elif name in left:
                words.append(left.pop(name))
            elif any(n in left for n, _ in self.places[i + 1 :]):
                return None, f"{name!r} is missing"
            elif not optional:
                return None, f"{name!r} is missing"
            else:
                break
        for name, value in left.items():
            if value is not False:
                words += [self.options[name], *([] if value is True else [value])]
        return words, None

    @property
    def names(self):
        return [*(n for n, _ in self.places if n), *self.options]


def _forms(name, kind):
    """Forms of a usage, such as those for the plane and for space."""
    first, *others = _NOTE.sub("", _usage(name, kind).split(": ")[0]).split(" or ")

    def tokens(text):
        text = re.sub(r"([<>])", r" \1 ", text.split("{")[0])
        return text.split()

    head = tokens(first)[1:]
    forms = [_Form(_group(iter(head)), kind)]
    for other in others:
        words = tokens(other)
        # A further form begins where it differs: with the first of its words that the first form has too.
        start = head.index(words[0]) if words and words[0] in head else len(head)
        forms.append(_Form(_group(iter(head[:start] + words)), kind))
    return forms


@cache
def _known_forms(name, kind):
    return _forms(name, kind)


def place(name, args, keywords):
    """The words of a call, of which some are given by their names in the usage of the command."""
    kinds = _USAGES[name][1]
    kind = args[0] if kinds and args and isinstance(args[0], str) else None
    given = args[1:] if kind is not None else args
    reasons = []
    for form in _known_forms(name, kind):
        words, reason = form.place(given, keywords)
        if reason is None:
            return (*args[: len(args) - len(given)], *words)
        reasons.append((reason, form))
    # The form that the names fit best says what is wrong.
    reason, form = min(reasons, key=lambda r: sum(r[1]._named(n) not in r[1].names for n in keywords))
    wrong = next((n for n in keywords if form._named(n) not in form.names), None)
    near = difflib.get_close_matches(wrong, form.names, 1, 0.4) if wrong else []
    hint = f"\n  did you mean {near[0]!r}?" if near else ""
    usage = _hysteron.usage_in_python(_usage(name, kind))
    raise OpenSeesError(f"{name}: {reason}{hint}\n  usage: {usage}")


@cache
def signature(name, with_model):
    """Signature of a command for `inspect`, `help` and editors."""
    kind = inspect.Parameter
    parameters = [kind("model", kind.POSITIONAL_ONLY)] if with_model else []
    kinds = _USAGES[name][1]
    forms = [] if kinds else _known_forms(name, None)
    if len(forms) == 1 and not forms[0].has_alternatives:
        known = {}
        for word, optional in forms[0].places:
            if word is None or not word.isidentifier() or word in known or word == "model":
                break
            # Python has no parameter with a default before one without.
            if not optional and any(p.default is None for p in known.values()):
                known.clear()
                break
            known[word] = kind(word, kind.POSITIONAL_OR_KEYWORD, default=None if optional else kind.empty)
        parameters += known.values()
    elif kinds:
        parameters.append(kind("kind", kind.POSITIONAL_ONLY))
    return inspect.Signature([*parameters, kind("words", kind.VAR_POSITIONAL), kind("options", kind.VAR_KEYWORD)])


@cache
def _sections():
    return _hysteron.reference()


def _cells(line):
    row = [c.strip().replace("\0", "|") for c in line.replace("\\|", "\0").strip("|").split("|")]
    return None if row[0] in ("argument", "option", "kind", "---", "") else row


def _plain(text):
    """Markdown as text: no marks of code, and the words of scripts as those of Python."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.sub(r"\$(\w+)", r"\1", text.replace("`", ""))


def summary(name):
    """First sentences about a command."""
    inside = False
    for line in _sections().get(name, []):
        inside = inside != line.startswith("```")
        if line and not inside and line[0] not in "`|":
            return _plain(line)
    return ""


def about(name, kind=None):
    """Text about a command, or about one kind of what it makes: usage, meaning, arguments and responses."""
    if name not in _USAGES:
        raise OpenSeesError(f"unknown command {name!r}")
    kinds = _USAGES[name][1]
    if kind is not None and kinds and all(kind not in names for names, _ in kinds):
        near = difflib.get_close_matches(kind, [n for names, _ in kinds for n in names], 1)
        raise OpenSeesError(f"{name}: unknown kind {kind!r}" + (f"\n  did you mean {near[0]!r}?" if near else ""))
    preferred = next((names[0] for names, _ in kinds if kind in names), kind)
    lines = _sections().get(name if kind is None else f"{name} {preferred}", [])
    out = [_hysteron.usage_in_python(_usage(name, kind) if kind else _USAGES[name][0]), ""]
    inside = of_kinds = False
    for line in lines:
        # The kinds stand in a list of their own below.
        of_kinds = line.startswith("|") and (of_kinds or line.startswith("| kind "))
        if line.startswith("```"):
            inside = not inside
        elif inside or of_kinds or line.startswith("Known names"):
            continue
        elif line.startswith("|"):
            cells = _cells(line)
            if cells:
                said = ", ".join(_plain(c) for c in cells[1:] if c)
                out.append(f"    {_plain(cells[0])}: {said}".rstrip(": "))
        elif line or out[-1]:
            out.append(_plain(line))
    if kinds and kind is None:
        names = ", ".join(sorted((k[0][0] for k in kinds), key=str.lower))
        out += ["", f"Kinds: {names}.", "", f"hysteron.about({name!r}, kind) has the words of each."]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(out)).strip()
