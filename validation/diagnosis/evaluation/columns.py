"""A table of decimal numbers in few bytes, column by column and without loss.

A number is an integer and its count of decimals. What is kept of it is its difference from an extrapolation of the numbers above it, as bytes of equal
weight one after the other, so that a compressor of bytes finds what they share. Words that are no such number are kept as they are.
"""

import json
import re

DECIMAL = re.compile(r"-?(?:0|[1-9]\d*)(?:\.(\d+))?")
NO_NUMBER = 255
ORDERS = range(4)


def split(word):
    """The integer and the count of decimals of a word, or None if they do not give the word again."""
    found = DECIMAL.fullmatch(word)
    if not found or len(found[1] or "") >= NO_NUMBER:
        return None
    integer = int(word.replace(".", ""))
    # A negative zero would lose its sign.
    return None if integer == 0 and word.startswith("-") else (integer, len(found[1] or ""))


def joined(integer, decimals):
    """The word of an integer and a count of decimals."""
    digits = str(abs(integer)).rjust(decimals + 1, "0")
    whole = len(digits) - decimals
    return ("-" if integer < 0 else "") + (digits[:whole] + "." + digits[whole:] if decimals else digits)


class Extrapolation:
    """The next number by a polynomial through the last ones, at the finest decimals of the column."""

    def __init__(self, order, finest):
        self.order, self.finest, self.last = order, finest, (0, 0, 0)

    def next(self, decimals):
        a, b, c = self.last
        step = 10 ** (self.finest - decimals)
        return ((0, a, 2 * a - b, 3 * a - 3 * b + c)[self.order] + step // 2) // step

    def add(self, integer, decimals):
        self.last = (integer * 10 ** (self.finest - decimals), *self.last[:2])


def differences(numbers, order, finest):
    """The difference of each number from the extrapolation of an order; 0 in place of words."""
    guess, left = Extrapolation(order, finest), []
    for number in numbers:
        if number is None:
            left.append(0)
            continue
        left.append(number[0] - guess.next(number[1]))
        guess.add(*number)
    return left


def encoded_column(column):
    """(entry of the head, bytes) of a column of words."""
    numbers = [split(word) for word in column]
    decimals = bytes(NO_NUMBER if n is None else n[1] for n in numbers)
    words = "\n".join(w for w, n in zip(column, numbers) if n is None).encode()
    finest = max((n[1] for n in numbers if n), default=0)
    order, left = min(((o, differences(numbers, o, finest)) for o in ORDERS), key=lambda x: sum(abs(v).bit_length() for v in x[1]))
    unsigned = [2 * v if v >= 0 else -2 * v - 1 for v in left]
    width = (max(unsigned).bit_length() + 7) // 8
    planes = b"".join(bytes(v >> (8 * k) & 255 for v in unsigned) for k in reversed(range(width)))
    return [order, finest, width, len(words)], decimals + words + planes


def encode(text):
    """The bytes of a table whose rows end with a newline and have the same number of cells, or None for any other text."""
    *lines, rest = text.split("\n")
    rows = [line.split(",") for line in lines]
    if rest or not rows or len({len(row) for row in rows}) != 1:
        return None
    heads, parts = zip(*(encoded_column(column) for column in zip(*rows)))
    return json.dumps([len(rows), heads]).encode() + b"\n" + b"".join(parts)


def decoded_column(entry, count, data, at):
    """The words of a column that begins at a byte, and where the next begins."""
    order, finest, width, length = entry
    decimals, at = data[at:at + count], at + count
    words, at = iter(data[at:at + length].decode().split("\n")), at + length
    unsigned = [0] * count
    for k in range(width):
        unsigned = [v << 8 | b for v, b in zip(unsigned, data[at + k * count:at + (k + 1) * count])]
    guess, column = Extrapolation(order, finest), []
    for v, d in zip(unsigned, decimals):
        if d == NO_NUMBER:
            column.append(next(words))
            continue
        integer = guess.next(d) + (-(v + 1) // 2 if v & 1 else v // 2)
        guess.add(integer, d)
        column.append(joined(integer, d))
    return column, at + width * count


def decode(data):
    """The text that `encode` made these bytes of."""
    at = data.index(b"\n") + 1
    count, heads = json.loads(data[:at])
    columns = []
    for entry in heads:
        column, at = decoded_column(entry, count, data, at)
        columns.append(column)
    return "".join(",".join(row) + "\n" for row in zip(*columns))
