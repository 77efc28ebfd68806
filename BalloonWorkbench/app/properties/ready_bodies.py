# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ready bodies in a Bag object: a property for each of their sizes, so that expressions drive them."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import Property, show_in_editor
from BalloonWorkbench.core.bodies.ready import READY, ready_bag
from BalloonWorkbench.core.units import to_mm

#: No ready body: the panels come from elsewhere.
NONE = "None"


def names() -> list[str]:
    """What they are called."""
    return [body.label for body in READY.values()]


def called(text: str) -> str | None:
    """The body that is called so, whatever the capitals; None where there is none."""
    known = {name.lower(): body.label for key, body in READY.items() for name in (key, body.label)}
    return known.get(text.lower())


def _sizes() -> tuple[Property, ...]:
    """A property for each size that a body has; bodies share those of the same name."""
    made = {}
    for body in READY.values():
        for size in body.sizes:
            kind = "Integer" if size.is_count else "Length"
            name = _property_name(size.name)
            made[name] = made.get(name) or Property(
                kind, name, "Ready body", "A size of the ready body", label=size.label
            )
    return tuple(made.values())


def _property_name(size: str) -> str:
    return "".join(map(str.capitalize, size.split("_")))


SIZES = _sizes()
PROPERTIES = (
    Property(
        "Enumeration",
        "Ready",
        "Ready body",
        "A ready body, made to measure",
        label="Ready body",
        entries=lambda: (NONE, *names()),
    ),
    *SIZES,
)


def _chosen(obj):
    """The name of the chosen body, and the body; None for none."""
    return next(((name, body) for name, body in READY.items() if body.label == obj.Ready), None)


def begin(obj) -> None:
    """A body that was just chosen begins with its usual sizes; one that follows an expression keeps it."""
    chosen = _chosen(obj)
    if chosen is None:
        return
    driven = {path for path, _ in obj.ExpressionEngine}
    for size in chosen[1].sizes:
        name = _property_name(size.name)
        if name not in driven:
            setattr(obj, name, int(size.default) if size.is_count else to_mm(size.default))


def follow(obj, own: bool) -> None:
    """Offer the sizes of the chosen body. own: it is what the panels come from."""
    chosen = _chosen(obj)
    used = {_property_name(size.name) for size in chosen[1].sizes} if own and chosen else set()
    show_in_editor(obj, **{item.name: "edit" if item.name in used else "hide" for item in SIZES})


def bag(obj):
    """The chosen body with the object's sizes. Raises InputError."""
    from BalloonWorkbench.app.properties.quantities import metres

    name, body = _chosen(obj)
    values = {size.name: getattr(obj, _property_name(size.name)) for size in body.sizes}
    counts = {size.name for size in body.sizes if size.is_count}
    return ready_bag(
        name, **{key: value if key in counts else metres(value) for key, value in values.items()}
    )
