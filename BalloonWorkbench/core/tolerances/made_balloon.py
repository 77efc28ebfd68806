# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon as it comes out of the workshop: a sample's panel, film and filling, inflated and measured."""

from __future__ import annotations

from dataclasses import dataclass, replace

from BalloonWorkbench.core.design.compare import laid_on, misfit
from BalloonWorkbench.core.design.design import Design, Residual
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import trimmed
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.filling import AIR, GAS_CONSTANT, Filling, air_pressure
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.making.safety import safety_with
from BalloonWorkbench.core.making.trade_figures import making
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.results.film_state import thickness
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.tolerances.made_seam import MadeSeam, made_seam
from BalloonWorkbench.core.tolerances.samples import Sample, Tolerances
from BalloonWorkbench.core.tolerances.sealed_gas import at_temperature
from BalloonWorkbench.core.tolerances.spread import ErrorSource
from BalloonWorkbench.core.units import number_text

#: Balloons that differ by little are told apart: both from the nominal one and from the flat film, the volume
#: comes out the same to 1e-6, and the silhouette to a few micrometres; as usual 1e-4 and tens of them.
AT_REST = NewtonSettings(tolerance=1e-7)


@dataclass(frozen=True)
class Nominal:
    """A balloon as it is meant to be.

    film_area  of one panel with weld, allowance and intake [m2]
    valve      weight of the intake's own pieces [kg]
    """

    target: Outline
    inflation: Inflation
    film: Film
    filling: Filling
    film_area: float
    valve: float

    @property
    def spots(self) -> int:
        """How many of the panel's last loops are sealed but not cut."""
        return len(self.target.spots)


@dataclass(frozen=True)
class Made:
    """What there is to measure of a balloon that was made.

    volume [m3], thickness [m], lift and weight [kg], silhouette with its distance from the drawing [m],
    pressure at its temperature and the safe one [Pa], None where no strength is known; at_rest: the film came
    to rest. seam: its panel; inflation: the balloon at its temperature.
    """

    volume: float
    thickness: float
    lift: float
    weight: float
    silhouette: Outline
    silhouette_error: Residual
    pressure: float
    safe_pressure: float | None
    at_rest: bool
    seam: MadeSeam
    inflation: Inflation


def nominal_of(design: Design, film: Film, filling: Filling, film_area: float, valve: float) -> Nominal:
    """The nominal balloon of a design; see Nominal. Raises InputError for other than two equal panels."""
    inflation = design.inflation
    if not inflation.assembly.mirror or inflation.lower is not None:
        raise InputError(
            "Tolerances are worked out for two equal panels, of which one is simulated: leave out"
            " --two-panels, and take a drawing."
        )
    solved = inflation.report
    settled = inflate(
        inflation.panel,
        film,
        solved.pressure,
        start=inflation,
        backend=solved.backend,
        model=solved.model,
        settings=AT_REST,
    )
    return Nominal(design.target, settled, film, filling, film_area, valve)


def made_balloon(nominal: Nominal, sample: Sample, tolerances: Tolerances, *, warm: bool = True) -> Made:
    """The balloon of a sample, set out from the nominal one; warm False: from the flat film.

    Raises InputError for errors that leave no film, no pressure or no seam, and what inflate raises.
    """
    seam = made_seam(nominal.inflation.panel, nominal.spots, sample, tolerances)
    film, filling = _film_of(nominal.film, sample, tolerances), nominal.filling
    solved = nominal.inflation.report
    pressure = _strayed(solved.pressure, sample, tolerances, ErrorSource.PRESSURE)
    filled = inflate(
        seam.panel,
        film,
        pressure,
        start=nominal.inflation if warm and seam.kept else None,
        backend=solved.backend,
        model=solved.model,
        settings=AT_REST,
    )
    warmer = replace(
        filling,
        air_temperature=_strayed(filling.air_temperature, sample, tolerances, ErrorSource.TEMPERATURE),
    )
    warmer.lightness()  # a temperature out of all range shows here
    outside = air_pressure(filling.altitude)
    gas = (outside + pressure) * filled.volume / (GAS_CONSTANT * filling.temperature)  # mol
    resting, volume, inside = at_temperature(
        filled, film, outside, warmer.temperature / filling.temperature, AT_REST
    )
    air = outside * AIR / (GAS_CONSTANT * warmer.air_temperature)
    weight = 2.0 * film.areal_density * (nominal.film_area + seam.grown) + nominal.valve
    figures = making()
    strength = 1.0 + sample.deviations.get(ErrorSource.STRENGTH, 0.0)
    weld = figures.seal_strength(replace(film, max_stress=nominal.film.max_stress))
    safe = safety_with(filled, film, None if weld is None else weld * strength, figures.safety)
    visible, error = _as_seen(nominal.target, resting)
    return Made(
        volume,
        float(thickness(resting).max()),
        air * volume - gas * filling.gas.molar_mass - weight,
        weight,
        visible,
        error,
        inside,
        safe.safe_pressure,
        filled.report.converged and resting.report.converged and safe.at_rest,
        seam,
        resting,
    )


def _as_seen(drawing: Outline, inflation: Inflation) -> tuple[Outline, Residual]:
    """A balloon's silhouette laid on the drawing as nearly as may be, and how far they are apart [m]."""
    laid = laid_on(inflation, silhouette(trimmed(inflation)), drawing)
    visible = silhouette(trimmed(laid))
    return visible, misfit(drawing, visible).residual


def _film_of(film: Film, sample: Sample, tolerances: Tolerances) -> Film:
    """The film of a sample: a thicker one is heavier and stronger, too; a stiffer one is so both ways."""
    thickness = _strayed(film.thickness, sample, tolerances, ErrorSource.THICKNESS)
    modulus = _strayed(film.young_modulus, sample, tolerances, ErrorSource.MODULUS)
    stiffer, strength = modulus / film.young_modulus, 1.0 + sample.deviations.get(ErrorSource.STRENGTH, 0.0)
    across, shear, breaking = film.young_modulus_across, film.shear_modulus, film.max_stress
    return replace(
        film,
        thickness=thickness,
        areal_density=film.areal_density * thickness / film.thickness,
        young_modulus=modulus,
        young_modulus_across=None if across is None else stiffer * across,
        shear_modulus=None if shear is None else stiffer * shear,
        max_stress=None if breaking is None else strength * breaking,
    )


def _strayed(value: float, sample: Sample, tolerances: Tolerances, source: ErrorSource) -> float:
    """A nominal value with its deviation. Raises InputError where nothing is left of it."""
    deviation = sample.deviations.get(source, 0.0)
    if deviation == 0.0:
        return value
    strayed = value * (1.0 + deviation) if tolerances.spreads[source].relative else value + deviation
    if not strayed > 0.0:
        raise InputError(
            f"The {source.title} strays by {number_text(100.0 * abs(strayed / value - 1.0))} % in sample"
            f" {sample.name}, which leaves nothing of it: give a smaller spread."
        )
    return strayed
