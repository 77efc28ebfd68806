# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts that a user may type and a program may take for something else."""

from __future__ import annotations

#: Texts to be drawn as they are typed: DejaVu Sans has each letter.
PLAIN = (
    "US$5 or $6",
    "$$",
    "$",
    "$\\foo$",
    "\\$5",
    "$x^2_i$ {a}",
    "\\frac{1}{2} \\n \\",
    "%s %d 100 % {0} {film} {",
    "a < b > c & d; &amp; <b>x</b> <!--",
    "\"double\" 'single' `back`",
    "_under_ ^up^ ~tilde~ #5 @home |x|",
    "é ü ß ø Å Œ ¿ ½ µ °",
    "Привет Ωμέγα",
    "(paren) [box] /slash/ ]]>",
    "😀 ☺ ♥",
    "AVAToTe WA fi ffl",
)
#: Texts that are drawn as another one.
SAME = {
    "no\u00a0break \u2009thin  two": "no break thin two",
    "line\nline\ttab\r\nend": "line line tab end",
    "soft\u00adhyphen zero\u200bwidth \ufeffmark \u200eleft": "softhyphen zerowidth mark left",
    "e\u0301 A\u030a n\u0303": "é Å ñ",
    "☺\ufe0f": "☺",
}
#: Texts with nothing to draw.
BLANK = ("", " ", "\n\t ", "\u00a0\u2003", "\u200b\ufeff", "\u00ad")
#: Texts that no line of letters can show, and the letters for which that is so.
UNSHOWN = {
    "nul\0": ["U+0000"],
    "bell\x07 \x1b[31m": ["U+0007", "U+001B"],
    "lone\ud800 \udfff": ["U+D800", "U+DFFF"],
    "private \ue000": ["U+E000"],
    "\U0010fffd plane": ["U+10FFFD"],
    "שלום": ["ש (U+05E9)", "ל (U+05DC)", "ו (U+05D5)", "ם (U+05DD)"],
    "مرحبا": ["م (U+0645)"],
    "x\u0304 q\u0301": ["U+0304", "U+0301"],
    "नमस्ते": ["U+094D"],
}
#: Texts for which a system may have a font.
PERHAPS = (
    "日本語 ひらがな",
    "한국어",
    "中文简体",
    "🎈 🎉",
    "a漢b",
    "👨\u200d👩\u200d👧",
    "𝔉",
    "ไทย",
    "🏳\ufe0f\u200d🌈",
)
LONG = "x" * 200
