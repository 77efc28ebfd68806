# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pages are made of: any text is only text, nothing comes from elsewhere, charts show their numbers."""

from __future__ import annotations

import base64
import hashlib
import math
import re
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from hostile_texts import PLAIN, SAME, UNSHOWN

from BalloonWorkbench.core.web_pages.charts import Bar, axis_of, histogram_chart, scatter_chart, tornado_chart
from BalloonWorkbench.core.web_pages.page import TABLE, VIEWER, Markup, data_uri, element, markup, web_page
from BalloonWorkbench.core.web_pages.study_page import (
    CHOSEN,
    MOST_CHARTS,
    MOST_ROWS,
    RESULT,
    StudyColumn,
    StudyPage,
    study_page,
)

WEB = Path(__file__).parents[3] / "resources" / "web"
NASTY = [
    "</title><script>alert(1)</script>",
    '" onload="alert(1)',
    "' x='",
    "<!--",
    "]]>",
    "&lt;",
    "a\0b\x1b",
    *PLAIN,
]
NASTY += [*UNSHOWN, *SAME]


class Read(HTMLParser):
    """A page as a browser takes it: elements with attributes, and the texts in them by element."""

    def __init__(self, content: bytes) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[tuple[str, str]] = []
        self._open: list[str] = []
        self.feed(content.decode("utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in ("img", "meta", "br"):
            self._open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append((self._open[-1] if self._open else "", data))

    def of(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.elements if name == tag]

    def inside(self, tag: str) -> str:
        return "".join(text for name, text in self.texts if name == tag)


def shown(text: str) -> str:
    """A text as a page shows it: a sign for what is no letter."""
    valid = "".join("\ufffd" if "\ud800" <= letter <= "\udfff" else letter for letter in text)
    return re.sub(r"[\x00-\x08\x0b-\x1f]", "\ufffd", valid.replace("\r\n", "\n"))


@pytest.mark.parametrize("text", NASTY)
def test_any_text_is_only_text(text: str) -> None:
    content = web_page(text, "en", [element("p", text, title=text)], [TABLE])
    page = Read(content)
    assert [tag for tag, _ in page.elements] == [
        "html", "head", "meta", "meta", "meta", "title", "style", "body", "p", "script",
    ]  # fmt: skip
    assert page.inside("p") == shown(text)
    (paragraph,) = page.of("p")
    assert paragraph == {"title": shown(text)}


def test_markup_stays_and_is_made_by_us_alone() -> None:
    assert markup(["<", element("b", "&"), Markup("<br>")]) == "&lt;<b>&amp;</b><br>"
    assert (
        element("img", alt="", src=None, data_value=3, class_="a") == '<img alt="" data-value="3" class="a">'
    )


def test_only_our_scripts_run_and_nothing_is_fetched() -> None:
    """The policy names the SHA-256 of each script and of the style alone; no address leaves the page."""
    content = web_page("a", "de", [element("p", "b")], [VIEWER, TABLE])
    page = Read(content)
    (policy,) = [
        meta["content"] for meta in page.of("meta") if meta.get("http-equiv") == "Content-Security-Policy"
    ]
    sums = set(re.findall(r"'sha256-([^']+)'", str(policy)))
    programs = [text for tag, text in page.texts if tag in ("script", "style")]
    assert len(programs) == 3
    assert sums == {base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() for text in programs}
    assert str(policy).startswith("default-src 'none'; img-src data:;")
    assert "unsafe" not in str(policy)
    assert not re.search(r"""(src|href)=["'](?!data:)""", content.decode())
    assert page.of("html") == [{"lang": "de"}]
    assert content == web_page("a", "de", [element("p", "b")], [VIEWER, TABLE])


def test_no_script_could_end_its_element() -> None:
    for path in WEB.glob("*.js"):
        assert not re.search(r"</script|<!--", path.read_text(encoding="utf-8"), re.IGNORECASE)
        assert not re.search(r"\bimport\b|\beval\b|innerHTML|https?:", path.read_text(encoding="utf-8"))


def luminance(colour: str) -> float:
    """Relative luminance of WCAG 2.2."""
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return float(np.dot(linear, (0.2126, 0.7152, 0.0722)))


def test_all_text_can_be_read_light_and_dark() -> None:
    """At least 4.5 to 1, as WCAG asks of small text."""
    style = (WEB / "page.css").read_text(encoding="utf-8")
    themes = [dict(re.findall(r"--(\w+): (#\w{6})", part)) for part in style.split("@media")[:2]]
    for theme in themes:
        for ink in ("ink", "soft", "accent", "second"):
            for ground in ("paper", "card"):
                low, high = sorted((luminance(theme[ink]), luminance(theme[ground])))
                assert (high + 0.05) / (low + 0.05) >= 4.5, (ink, ground, theme)


def svg(chart: Markup) -> ElementTree.Element:
    figure = ElementTree.fromstring(chart)  # well-formed
    drawing = figure.find("svg")
    assert drawing is not None
    return drawing


def ticks(drawing: ElementTree.Element, anchor: str) -> dict[float, float]:
    """Places of the numbers along an axis, by number."""
    along = "x" if anchor == "middle" else "y"
    found = {}
    for text in drawing.iter("text"):
        if text.get("text-anchor") == anchor and re.fullmatch(r"-?[\d.]+", text.text or ""):
            found[float(str(text.text))] = float(str(text.get(along)))
    return found


def test_points_are_where_the_axes_have_them() -> None:
    x, y = [1.5, 8.0, math.nan, 4.25], [-200.0, 1000.0, 3.0, 430.0]
    drawing = svg(scatter_chart("a & b", ("width <mm>", x), ("volume", y), ["one", "<two>", "gone", "four"]))
    across, up = (ticks(drawing, anchor) for anchor in ("middle", "end"))
    points = list(drawing.iter("circle"))
    assert [point.findtext("title") for point in points] == [
        "one: 1.5, -200",
        "<two>: 8, 1000",
        "four: 4.25, 430",
    ]
    for point, at in zip(points, [(1.5, -200.0), (8.0, 1000.0), (4.25, 430.0)], strict=True):
        for name, value, places, shift in (("cx", at[0], across, 0.0), ("cy", at[1], up, -4.0)):
            known = sorted(places)
            wanted = np.interp(value, known, [places[tick] + shift for tick in known])
            assert float(str(point.get(name))) == pytest.approx(wanted, abs=0.05)


def test_all_is_counted_in_a_histogram() -> None:
    values = [*np.random.default_rng(1).normal(5.0, 1.0, 400).tolist(), math.inf, math.nan]
    drawing = svg(histogram_chart("Volume", ("l", values), "balloons"))
    bars = list(drawing.iter("rect"))
    counts = [int(str(bar.findtext("title")).rpartition(": ")[2]) for bar in bars]
    assert sum(counts) == 400
    tallest = max(bars, key=lambda bar: float(str(bar.get("height"))))
    assert counts[bars.index(tallest)] == max(counts)


def test_the_longest_bar_of_a_tornado_is_on_top() -> None:
    bars = [Bar("thickness", 90.0, 110.0), Bar("modulus <GPa>", 130.0, 70.0), Bar("none", math.nan, 1.0)]
    drawing = svg(tornado_chart("Safe pressure", "Pa", 100.0, bars))
    names = [str(text.text) for text in drawing.iter("text") if text.get("text-anchor") == "end"]
    assert names == ["modulus <GPa>", "thickness"]
    widths = [float(str(bar.get("width"))) for bar in drawing.iter("rect")]
    assert widths[0] == pytest.approx(3.0 * widths[2], abs=0.2)


@pytest.mark.parametrize(
    ("values", "ends"),
    [([0.3, 9.7], (0, 10)), ([5.0], (2, 8)), ([0.0, 0.0], (-1, 1)), ([-3e-7, 1e-7], (-3e-7, 1e-7)),
     ([1e9, 1e9 + 1], (1e9, 1e9 + 1))],
)  # fmt: skip
def test_axes_end_at_round_numbers(values: list[float], ends: tuple[float, float]) -> None:
    axis = axis_of("", values)
    assert axis.least <= min(values) <= max(values) <= axis.most
    assert (axis.least, axis.most) == pytest.approx(ends, rel=1e-12, abs=1e-12)
    assert 2 <= len(axis.ticks) <= 9


def test_charts_of_nothing_are_there() -> None:
    nothing = ("", [math.nan])
    for chart in (
        scatter_chart("a", nothing, nothing, [""]),
        histogram_chart("a", nothing, ""),
        tornado_chart("a", "", 1.0, []),
    ):
        assert not list(svg(chart).iter("line"))


def rows(count: int) -> list[dict[str, object]]:
    return [
        {
            "row": k + 1, "key": f"k{k}", "input": NASTY[k % len(NASTY)], "width": f"{100 + k}mm",
            "gores": 7777, "volume_m3": None if k == 2 else 1e-3 * (k + 1),
            "max_tension_N_per_m": None if k == 2 else 100.0 - k,
            "reached": None if k == 2 else True, "failure": "The <film> is torn." if k == 2 else "",
        }
        for k in range(count)
    ]  # fmt: skip


def study(count: int, **more: object) -> bytes:
    number = {f"{100 + k}mm": 100.0 + k for k in range(count)}
    columns = [
        StudyColumn("row"), StudyColumn("input"), StudyColumn("width", CHOSEN, number),
        StudyColumn("gores", CHOSEN),
        StudyColumn("volume_m3", RESULT), StudyColumn("max_tension_N_per_m", RESULT), StudyColumn("failure"),
    ]  # fmt: skip
    return study_page(StudyPage("A <study>", columns, rows(count), **more))  # type: ignore[arg-type]


def test_a_study_tells_all_of_its_rows() -> None:
    page = Read(study(30, pictures={"k1": b"png"}, links={"k1": "results/k 1?/report.html"}))
    assert len(page.of("tr")) == 1 + 30 + 1
    assert page.inside("p") == "Rows: 30, without a balloon: 1"
    assert "The <film> is torn." in page.inside("span")
    assert ("td", "7777") in page.texts  # the same for all: told once
    assert [text for tag, text in page.texts if tag == "td"].count("7777") == 1
    assert page.of("img") == [
        {"src": data_uri("image/png", b"png"), "alt": "Balloon of row 2", "loading": "lazy"}
    ]
    assert page.of("a") == [{"href": "results/k%201%3F/report.html"}]
    assert [text for tag, text in page.texts if tag == "figcaption"] == [
        "volume m3 over width", "max tension N/m over width",
    ]  # fmt: skip
    assert len(page.of("circle")) == 2 * 29


def test_what_was_chosen_of_results_comes_first() -> None:
    page = Read(study(5, shown=["max_tension_N_per_m"]))
    assert next(text for tag, text in page.texts if tag == "figcaption") == "max tension N/m over width"


def test_without_numbers_that_were_chosen_results_are_counted() -> None:
    columns = [StudyColumn("row"), StudyColumn("volume_m3", RESULT)]
    page = Read(study_page(StudyPage("a", columns, rows(5))))
    assert len(page.of("rect")) == 5
    assert not page.of("circle")


def test_a_large_study_stays_a_page() -> None:
    many = [
        {
            "row": k,
            "key": str(k),
            "a": k,
            "b": k % 7,
            **{f"r{n}": float(k * n) for n in range(1, 6)},
            "failure": "",
        }
        for k in range(MOST_ROWS + 10)
    ]
    columns = [
        StudyColumn("a", CHOSEN),
        StudyColumn("b", CHOSEN),
        *(StudyColumn(f"r{n}", RESULT) for n in range(1, 6)),
    ]
    page = Read(study_page(StudyPage("a", columns, many)))
    assert len(page.of("tr")) == 1 + MOST_ROWS
    assert f"The first {MOST_ROWS} rows" in page.inside("caption")
    assert len(page.of("figure")) == MOST_CHARTS


def test_a_study_of_nothing_is_a_page() -> None:
    page = Read(study_page(StudyPage("a", [StudyColumn("row")], [])))
    assert page.inside("p") == "Rows: 0, without a balloon: 0"


def test_the_same_study_gives_the_same_bytes() -> None:
    assert study(6) == study(6)
