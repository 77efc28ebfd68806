// SPDX-License-Identifier: LGPL-2.1-or-later
// Sorts the page's tables by the column whose head is pressed: by numbers where all cells have one, empty ones last.
"use strict";
for (const button of document.querySelectorAll("th > button")) {
  button.addEventListener("click", () => {
    const head = button.parentElement, body = head.closest("table").tBodies[0], column = head.cellIndex;
    const upward = head.getAttribute("aria-sort") !== "ascending";
    const valueOf = (row) => row.cells[column].textContent;
    const rows = [...body.rows].map((row) => [valueOf(row), row]);
    const numbers = rows.every(([value]) => value === "" || Number.isFinite(Number(value)));
    const before = (a, b) => (numbers ? a - b : a.localeCompare(b, undefined, { numeric: true }));
    rows.sort(([a], [b]) => (a === "") - (b === "") || (a === "" ? 0 : upward ? before(a, b) : before(b, a)));
    for (const each of head.parentElement.cells) each.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", upward ? "ascending" : "descending");
    body.append(...rows.map(([, row]) => row));
  });
}
