"""What each command does; the names of the functions are the names of the commands.

Each imports what it alone needs: most of a short command is the time that imports take.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path, PurePath
from typing import BinaryIO

import resources
from app.cli import preflight
from sgb_core.document.file import project_file
from sgb_core.document.file.atomic import write_whole
from sgb_core.fields.kinds import Choice
from sgb_core.findings.errors import FindingError
from sgb_core.findings.exports import NoFormat
from sgb_core.findings.files import IsTheProject
from sgb_core.findings.refusal import Unknown

DONE, FAULT = 0, 1


def presets(_: argparse.Namespace) -> int:
    """List the presets, a line each: the name, then a description."""
    found = resources.presets()
    width = max(len(preset.name) for preset in found)
    for preset in found:
        print(f"{preset.name:<{width}}  {preset.description}")
    return DONE


def new(options: argparse.Namespace) -> int:
    """Write a preset as a project file."""
    _write(options.out, resources.load_preset(options.preset))
    return DONE


def check(options: argparse.Namespace) -> int:
    """Say what a file holds, and warnings."""
    from app.cli.measures_table import contents
    from sgb_core.document.evaluation import evaluate

    _know_textures()
    print(contents(evaluate(project_file.load(options.file))))
    return DONE


def measure(options: argparse.Namespace) -> int:
    """Print the measures, as a table or as JSON."""
    from app.cli.measures_table import table
    from sgb_core.document.evaluation import evaluate
    from sgb_core.document.measures import measures

    _know_textures()
    measured = measures(evaluate(project_file.load(options.file)))
    if options.json:
        print(json.dumps(measured, ensure_ascii=False, allow_nan=False, indent=2))
    else:
        print(table(measured))
    return DONE


def sample(options: argparse.Namespace) -> int:
    """Write the generatrix, at θ = 0 where a law varies it, as CSV."""
    from app.cli import figure_record

    document = figure_record.document_of(Path(options.file))
    _keep_input(options.file, options.out)
    if options.curvature and options.out is not None:
        from app.cli import pages
        from sgb_core.drawings.curvature_figure import curvature_figure

        if pages.is_drawn(options.out):
            figure, command = curvature_figure(document), ["sample", "--curvature"]
            pages.write_figure(document, figure, options.out, command, options.dpi)
            return DONE
    from sgb_core.exchange import csv_profile

    per_segment = options.per_segment or csv_profile.PER_SEGMENT
    make = csv_profile.curvature_lines if options.curvature else csv_profile.csv_lines
    text = "\n".join(make(document.surface, per_segment)) + "\n"
    if options.out is None:
        sys.stdout.write(text)
    else:
        _write(options.out, text.encode("ascii"))
    return DONE


def export(options: argparse.Namespace) -> int:
    """Write the body in the format that the suffix names."""
    from sgb_core import exchange
    from sgb_core.surfaces.fineness import Fineness

    # The cheap question first: a wrong suffix needs no file to be seen.
    wanted = exchange.format_for(options.out)
    samples = tuple(options.samples) if options.samples else None
    document = project_file.load(options.file)
    _know_textures()
    told = _percentages() if options.progress else None
    exchange.write(document, options.out, tolerance=options.tolerance, samples=samples, report=told)
    if not wanted.meshed and wanted.tolerance is not None:
        # A mesh is as near as was asked for; how near a fit came is worth a line.
        print(wanted.contents(exchange.Request(document, Fineness(options.tolerance))))
    return DONE


def render(options: argparse.Namespace) -> int:
    """Draw a picture off screen."""
    suffix = PurePath(options.out).suffix.lower()
    if suffix != ".png":
        raise FindingError(NoFormat(options.out, suffix, (".png",)))
    document = project_file.load(options.file)
    _know_textures()
    if options.look is not None:
        from sgb_core.document import edits

        document = edits.apply_look(document, _look(options.look))
    preflight.check_drawing()
    from app.scene.offscreen import render_png

    picture = render_png(
        document,
        size=options.size,
        view=options.view,
        show=options.show,
        transparent=options.transparent,
    )
    _write(options.out, picture)
    return DONE


def animate(options: argparse.Namespace) -> int:
    """Draw a film off screen."""
    preflight.check_drawing()
    from app.cli.animate import write_animation

    write_animation(options)
    return DONE


def _look(name: str) -> dict[str, object]:
    looks = {look.name: look.appearance for look in resources.looks()}
    if name not in looks:
        raise FindingError(Unknown("look", name, Choice(looks)))
    return looks[name]


def figures(options: argparse.Namespace) -> int:
    """Write the paper's figures."""
    preflight.check_drawing()
    from app.cli.figures import write_figures

    again = None if options.again is None else Path(options.again)
    write_figures(Path(options.out), options.only, options.dpi, again)
    return DONE


def plate(options: argparse.Namespace) -> int:
    """Write the figure plate that a project, or the file beside such a plate, holds."""
    from app.cli import figure_record

    document = figure_record.document_of(Path(options.file))
    _keep_input(options.file, options.out)
    preflight.check_drawing()
    from app.cli.figures import write_plate

    told = _percentages() if options.progress else None
    write_plate(document, Path(options.out), told, options.dpi)
    return DONE


def trace(options: argparse.Namespace) -> int:
    """Take profiles from sources, write the projects and say how near they are."""
    from app.cli import trace as cli_trace

    return DONE if cli_trace.trace(options) else FAULT


def fit(options: argparse.Namespace) -> int:
    """Fit the profile, write the result and print the deviations."""
    from app.cli.fit import fitted_document

    document = project_file.load(options.file)
    fitted, report = fitted_document(document, options)
    project_file.save(fitted, options.out)
    print(report)
    return DONE


def fair(options: argparse.Namespace) -> int:
    """Make the profile fair, write the result and print what moved."""
    from app.cli import fair as cli_fair

    faired, report = cli_fair.faired(project_file.load(options.file), options)
    project_file.save(faired, options.out)
    print(report)
    return DONE


def solve(options: argparse.Namespace) -> int:
    """Reach the targets, write the result and print what was reached and moved."""
    from app.cli import solve as cli_solve

    document = project_file.load(options.file)
    _know_textures()
    result, report = cli_solve.solved(document, options)
    project_file.save(result, options.out)
    print(report)
    return DONE


def variants(options: argparse.Namespace) -> int:
    """Write variants that keep all that is locked, the fairest first."""
    from app.cli import variants as cli_variants

    print(cli_variants.written(project_file.load(options.file), options))
    return DONE


def toolpath(options: argparse.Namespace) -> int:
    """Write the path of a printer as G-code and print what it comes to."""
    from app.cli import toolpath as cli_toolpath
    from sgb_core.toolpaths.gcode import write_gcode
    from sgb_core.toolpaths.preview import preview

    document = project_file.load(options.file)
    _keep_input(options.file, options.out)
    _know_textures()
    path = cli_toolpath.made(document, options)
    write_gcode(path, options.out, document.name, picture=preview(path))
    print(cli_toolpath.report(path, options.json))
    return DONE


def printers(options: argparse.Namespace) -> int:
    """List the printers, or print the data file of one."""
    from app.cli import toolpath as cli_toolpath

    print(cli_toolpath.list_printers(options.name))
    return DONE


def drawing(options: argparse.Namespace) -> int:
    """Draw on paper and say at which scale."""
    from app.cli import drawing as cli_drawing
    from app.cli import pages

    # The cheap question first: a wrong suffix needs no file to be seen.
    pages.check_suffix(options.out)
    for file in options.files:
        _keep_input(file, options.out)
    drawn = cli_drawing.made(options)
    pages.write(drawn, options.out, options.dpi)
    print(cli_drawing.report(drawn))
    return DONE


def template(options: argparse.Namespace) -> int:
    """Draw a template at true size and say on how many pages."""
    from app.cli import template as cli_template
    from sgb_core.drawings.drawing import write_drawing

    _keep_input(options.file, options.out)
    drawn = cli_template.made(options)
    write_drawing(drawn, options.out)
    print(cli_template.report(drawn))
    return DONE


def compare(options: argparse.Namespace) -> int:
    """Draw other curves on the same polygons, and the fairest, with energies and deviations."""
    from app.cli import compare as cli_compare
    from app.cli import figure_record, pages
    from sgb_core.drawings.comparison_plate import all_curves, comparison_plate

    pages.check_suffix(options.out)
    _keep_input(options.file, options.out)
    document = figure_record.document_of(Path(options.file))
    found = all_curves(document)
    plate = comparison_plate(document, found)
    pages.write_figure(document, plate, options.out, ["compare"], options.dpi)
    print(cli_compare.report(found, str(document.unit), options.json))
    return DONE


def edit(options: argparse.Namespace) -> int:
    """Apply one edit, write the result and print the deviation or what a rule moved.

    Joints whose rule the edit could not keep are named in a line on standard error, each with the
    reason.
    """
    from app.cli.edit_verbs import VERBS
    from sgb_core.curves.unmet import newly_unmet
    from sgb_core.document import edits
    from sgb_core.findings.words import say

    document = project_file.load(options.file)
    _know_textures()
    edited, finding = VERBS[options.verb].apply(document, options)
    kept = edits.keep_locks(document, edited)
    edited, finding = kept.document, finding or kept.in_the_way
    project_file.save(edited, options.out)
    if finding is not None:
        print(say(finding))
    unmet = newly_unmet(edited.profile, document.profile)
    if unmet:
        print(f"sgb-studio: {'; '.join(map(say, unmet))}", file=sys.stderr)
    return DONE


def _percentages() -> Callable[[float], None]:
    """Return what prints each percentage once."""
    last = -1

    def tell(part: float) -> None:
        nonlocal last
        if round(100 * part) > last:
            last = round(100 * part)
            print(last, flush=True)

    return tell


def _know_textures() -> None:
    """Let the program's textures and colour tables be found; what draws does so by itself."""
    import_module("resources.library")


def _keep_input(source: str, target: str | None) -> None:
    """Refuse a slip that would replace the project by what was made from it."""
    if target is not None and os.path.exists(target) and os.path.samefile(source, target):
        raise FindingError(IsTheProject(target))


def _write(path: str, data: bytes) -> None:
    def writer(stream: BinaryIO) -> None:
        stream.write(data)

    write_whole(path, writer)
