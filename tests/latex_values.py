"""Formulas in LaTeX, read back as numbers: what is printed must mean what was computed."""

from __future__ import annotations

import cmath
import re
from collections.abc import Mapping

TOKEN = re.compile(
    r"\\(?:left|right|Bigl|Bigr|quad|qquad|cdot)(?![A-Za-z])\s*|\\[,;]|(?P<token>"
    r"\\overline\{(?:\\?[A-Za-z]+)(?:_\{[^{}]*\})?\}"
    r"|(?:\\[A-Za-z]+|[A-Za-z])(?:_\{[^{}]*\}|_[A-Za-z0-9])?"
    r"|\d+|[-+(){}\[\]^=&.])"
)
FUNCTIONS = {"\\cos": cmath.cos, "\\sin": cmath.sin, "\\sqrt": cmath.sqrt}
CLOSING = {"(": ")", "{": "}", "[": "]"}


def balanced(text: str, whole: bool = True) -> bool:
    """Whether braces match and large brackets come in pairs; big ones only in a whole formula."""
    for opening, closing in (("\\left", "\\right"), ("\\Bigl", "\\Bigr"))[: 1 + whole]:
        if len(re.findall(re.escape(opening) + r"\b", text)) != len(
            re.findall(re.escape(closing) + r"\b", text)
        ):
            return False
    depth = 0
    for character in re.sub(r"\\[{}]", "", text):
        depth += (character == "{") - (character == "}")
        if depth < 0:
            return False
    return depth == 0


class Reader:
    """A recursive reader of sums of products; juxtaposition multiplies."""

    def __init__(self, text: str, values: Mapping[str, complex]) -> None:
        self.values = values
        self.tokens: list[str] = []
        position = 0
        while position < len(text):
            if text[position].isspace():
                position += 1
                continue
            match = TOKEN.match(text, position)
            assert match, f"cannot read {text[position:]!r}"
            if match["token"] and match["token"] != "&":
                self.tokens.append(match["token"])
            position = match.end()

    def peek(self) -> str:
        return self.tokens[0] if self.tokens else ""

    def take(self, wanted: str = "") -> str:
        assert self.tokens, f"{wanted!r} expected, nothing left"
        token = self.tokens.pop(0)
        assert not wanted or token == wanted, f"{wanted!r} expected, {token!r} read"
        return token

    def sum(self) -> complex:
        total = 0j
        sign = 1
        while True:
            while self.peek() in ("+", "-"):
                sign *= -1 if self.take() == "-" else 1
            total += sign * self.product()
            if self.peek() not in ("+", "-"):
                return total
            sign = 1

    def product(self) -> complex:
        assert self.peek() not in ("", ")", "}", "]"), "a factor is missing"
        result = 1 + 0j
        while self.peek() not in ("", "+", "-", ")", "}", "]", "="):
            result *= self.power()
        return result

    def power(self) -> complex:
        base = self.atom()
        if self.peek() == "^":
            self.take()
            if self.peek() == "{":
                return base ** self.group()
            return base ** int(self.take())
        return base

    def group(self) -> complex:
        closing = CLOSING[self.take()]
        value = self.sum()
        self.take(closing)
        return value

    def atom(self) -> complex:
        token = self.peek()
        if token in CLOSING:
            return self.group()
        self.take()
        if token == "\\frac":
            return self.group() / self.group()
        if token in FUNCTIONS:
            if self.peek() == "^":
                self.take()
                exponent = self.group()
                return FUNCTIONS[token](self.group()) ** exponent
            return FUNCTIONS[token](self.group())
        if token.isdigit():
            if self.peek() == ".":
                self.take()
                return complex(f"{token}.{self.take()}")
            return complex(token)
        return complex(self.values[token])


def value(text: str, values: Mapping[str, complex]) -> complex:
    """The number that a formula stands for.

    Parameters
    ----------
    text : str
        Without relation signs.
    values : mapping
        LaTeX of a symbol, with its subscript → number.
    """
    reader = Reader(text, {"i": 1j, "e": cmath.e, "\\pi": cmath.pi, **values})
    result = reader.sum()
    assert not reader.tokens, f"{reader.tokens} left over"
    return result
