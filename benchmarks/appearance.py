"""Writes the table of how the shipped styles look, and tells them in order.

python -m benchmarks.appearance
"""

from __future__ import annotations

from pathlib import Path

from scenewright.catalog import appearance
from scenewright.catalog.appearance import Facts
from scenewright.catalog.assets import shipped

TABLE = Path(appearance.__file__).with_name("appearance.csv")


def styles() -> dict[str, Facts]:
    """The facts of every shipped building, computed anew."""
    return {
        asset.id: appearance.facts_of(asset.mesh(asset.usual)) for asset in shipped().of("building")
    }


def ranking(rows: dict[str, Facts]) -> list[str]:
    """Lines of a table in Markdown, best first by our measure, with the place by the printed."""
    printed = sorted(rows, key=lambda name: -rows[name].printed)
    lines = [
        "| style | quality | its place as printed | tone | symmetry |",
        "|---|---|---|---|---|",
    ]
    best = max(row.relief for row in rows.values())
    for name in sorted(rows, key=lambda name: -rows[name].relief):
        row = rows[name]
        lines.append(
            f"| {shipped().assets[name].name} | {row.relief / best:.2f} "
            f"| {printed.index(name) + 1} | {row.tone:.2f} | {row.symmetry:.2f} |"
        )
    return lines


def main() -> None:
    """Write the table."""
    rows = styles()
    TABLE.write_text(appearance.table(rows), encoding="utf-8")
    print("\n".join(ranking(rows)))


if __name__ == "__main__":
    main()
