"""Files of CAD, BIM, print and maps: ``scenewright bench exchange``.

A row a format: the library it needs and the megabytes that takes, the lines of our code, seconds of
the processor that writing a scene takes the second time (its ratio is to writing the same scene as
JSON), seconds that reading it back takes where it is read, and the verdict of a checker that is not
ours. Formats that are only read come from their own programs: GDAL and osmium write the files.
"""

from __future__ import annotations

import contextlib
import io
import json
import resource
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

from benchmarks.damaged_maps import sound_map

Record = dict[str, Any]
Progress = Callable[[float, str], None]
SOURCE = Path(__file__).parent.parent / "src" / "scenewright"
HOME, SITE = "sample:home-flat", "sample:village-hamlet"


class Exchanged(NamedTuple):
    """A format: its suffix, the distributions it needs, where our code for it lies, the checker
    (name and function from a file to a verdict), the sample written, whether it is slow to check,
    and what makes the content of one that we only read, given a folder for spare files."""

    suffix: str
    libraries: tuple[str, ...]
    code: tuple[str, ...]
    checker: str
    check: Callable[[Path], str]
    sample: str = HOME
    slow: bool = False
    made: Callable[[Path], bytes] | None = None


def check_dxf(path: Path) -> str:
    """Errors and repairs by the auditor of ezdxf."""
    import ezdxf

    audit = ezdxf.readfile(path).audit()
    return f"{len(audit.errors)} errors, {len(audit.fixes)} fixes"


def check_ifc(path: Path) -> str:
    """Errors by the validator of ifcopenshell with its express rules."""
    import ifcopenshell.validate

    log = ifcopenshell.validate.json_logger()
    with contextlib.redirect_stdout(io.StringIO()):
        ifcopenshell.validate.validate(ifcopenshell.open(str(path)), log, express_rules=True)
    return f"{len(log.statements)} errors"


def check_pdf(path: Path) -> str:
    """Pages and letters of text by pypdf."""
    import pypdf

    pages = pypdf.PdfReader(path).pages
    return f"{len(pages)} pages, {sum(len(page.extract_text()) for page in pages)} letters"


def check_xml(path: Path) -> str:
    """Elements of well-formed XML."""
    return f"{sum(1 for _ in ElementTree.parse(path).iter())} elements"


def check_glb(path: Path) -> str:
    """Meshes and triangles by trimesh."""
    import trimesh

    meshes = trimesh.load(path, force="scene").geometry.values()
    return f"{len(meshes)} meshes, {sum(len(mesh.faces) for mesh in meshes)} triangles"


def check_layers(path: Path) -> str:
    """Layers and features by GDAL."""
    import pyogrio

    names = [row[0] for row in pyogrio.list_layers(path)]
    counts = [pyogrio.read_info(path, layer=name)["features"] for name in names]
    return f"{len(names)} layers, {sum(counts)} features"


def check_objects(path: Path) -> str:
    """Objects of OpenStreetMap by osmium."""
    import osmium

    return f"{sum(1 for _ in osmium.FileProcessor(str(path)))} objects"


def check_json(path: Path) -> str:
    """Whether it is JSON."""
    return f"{len(json.loads(path.read_text(encoding='utf-8')))} keys"


GIS = ("formats/gis.py", "ground/geodata")
ROWS = (
    Exchanged(
        ".dxf", ("ezdxf",), ("formats/dxf", "drawing/dxf", "building/drawn"), "ezdxf", check_dxf
    ),
    Exchanged(".3d.dxf", ("ezdxf",), ("formats/dxf/solids.py",), "ezdxf", check_dxf),
    Exchanged(
        ".pdf",
        ("fpdf2", "fonttools", "fontpkg-noto-sans", "pypdfium2"),
        ("formats/pdf.py", "formats/drawing_set.py", "drawing/pdf", "formats/painted/pdf.py"),
        "pypdf",
        check_pdf,
    ),
    Exchanged(
        ".ifc", ("ifcopenshell",), ("formats/ifc",), "ifcopenshell.validate", check_ifc, slow=True
    ),
    Exchanged(
        ".svg",
        ("svgelements",),
        ("formats/svg.py", "drawing/svg.py", "formats/painted/svg.py"),
        "ElementTree",
        check_xml,
    ),
    Exchanged(".glb", (), ("formats/glb.py",), "trimesh", check_glb),
    Exchanged(".gpkg", ("pyogrio",), ("formats/gpkg.py", *GIS), "pyogrio", check_layers, SITE),
    Exchanged(".geojson", (), ("formats/geojson.py",), "pyogrio", check_layers, SITE),
    Exchanged(".city.json", (), ("ground/buildings/city_objects.py",), "json", check_json, SITE),
    *(
        Exchanged(suffix, (library,), GIS, library, check, made=sound_map(suffix))
        for suffix, library, check in (
            (".zip", "pyogrio", check_layers),
            (".kml", "pyogrio", check_layers),
            (".osm", "osmium", check_objects),
            (".pbf", "osmium", check_objects),
        )
    ),
)
"""The table: a format of a further kind is a row more."""


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """Two records a format: writing, and reading back where it is read."""
    from scenewright.workflow.arrange import arrange

    solved = {}
    with tempfile.TemporaryDirectory() as folder:
        for number, row in enumerate(ROWS):
            if progress is not None:
                progress(number / len(ROWS), f"writing {row.suffix}")
            if row.made is not None:
                yield _measure_read(row, row.made, Path(folder))
                continue
            if row.sample not in solved:
                home = row.sample == HOME
                made = arrange(row.sample, steps=200) if home else arrange(row.sample, layouts=1)
                solved[row.sample] = made.solution
            yield from _measure(row, solved[row.sample], Path(folder), quick)


def _measure(row: Exchanged, solution: Any, folder: Path, quick: bool) -> Iterator[Record]:
    from scenewright import formats

    path, plain = folder / f"scene{row.suffix}", folder / "scene.json"
    baseline = time_of(lambda: formats.write(solution, plain))
    wrote = time_of(lambda: formats.write(solution, path))
    verdict = "not asked (--quick)" if quick and row.slow else row.check(path)
    facts = _facts(row, path, verdict)
    yield _record(row, "write", wrote, baseline) | facts
    if any(one.reader and one.suffix == row.suffix for one in formats.formats()):
        read = time_of(lambda: formats.read(path), times=1)
        yield _record(row, "read", read, baseline) | facts


def _measure_read(row: Exchanged, made: Callable[[Path], bytes], folder: Path) -> Record:
    """The record of reading a file that another program wrote."""
    from scenewright.ground.geodata.reading import load_map

    spare = folder / f"spare{row.suffix}"
    spare.mkdir()
    path = folder / f"map{row.suffix}"
    path.write_bytes(made(spare))
    took = time_of(lambda: load_map(path), times=1)
    return _record(row, "read", took, None) | _facts(row, path, row.check(path))


def _facts(row: Exchanged, path: Path, verdict: str) -> Record:
    return {
        "library": ", ".join(row.libraries) or "none",
        "megabytes": round(sum(map(installed_size, row.libraries)) / 2**20, 1),
        "lines": sum(map(count_lines, row.code)),
        "checker": row.checker,
        "verdict": verdict,
        "kilobytes": max(round(path.stat().st_size / 1024), 1),
    }


def _record(row: Exchanged, metric: str, seconds: float, baseline: float | None) -> Record:
    return {
        "case": row.suffix,
        "metric": metric,
        "unit": "s of processor",
        "ours": round(seconds, 3),
        "baseline": None if baseline is None else round(baseline, 3),
        "baseline_name": "" if baseline is None else "writing JSON",
        "ratio": None if baseline is None else round(seconds / baseline, 1),
        "runs": 1,
    }


def time_of(run: Callable[[], Any], times: int = 2) -> float:
    """Seconds of the processor, of this process and those it starts, that the last of some runs
    takes."""
    took = 0.0
    for _ in range(times):
        before = _used()
        run()
        took = _used() - before
    return took


def _used() -> float:
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def installed_size(distribution: str) -> int:
    """Bytes of the files of a distribution."""
    files = metadata.distribution(distribution).files or []
    places = (Path(str(file.locate())) for file in files)
    return sum(place.stat().st_size for place in places if place.is_file())


def count_lines(place: str) -> int:
    """Lines of our code in a file or folder."""
    top = SOURCE / place
    files = [top] if top.is_file() else sorted(top.rglob("*.py"))
    return sum(len(file.read_text(encoding="utf-8").splitlines()) for file in files)


COLUMNS = ("format", "library", "MB", "lines", "write s", "× JSON", "read s", "KB", "checker")


def markdown_lines(found: Iterable[Record]) -> list[str]:
    """The table, a row a format."""
    rows: dict[str, Record] = {}
    for record in found:
        rows.setdefault(record["case"], dict(record))[record["metric"]] = record["ours"]
    lines = [f"| {' | '.join(COLUMNS)} |", "|---|---|---:|---:|---:|---:|---:|---:|---|"]
    for case, row in rows.items():
        cells = [f"`{case}`", row["library"], row["megabytes"], row["lines"]]
        cells += [
            row.get("write", ""),
            row["ratio"] if "write" in row else "",
            row.get("read", ""),
            row["kilobytes"],
        ]
        cells += [f"{row['checker']}: {row['verdict']}"]
        lines.append(f"| {' | '.join(map(str, cells))} |")
    return lines
