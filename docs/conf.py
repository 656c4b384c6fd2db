"""The site: pages of this folder, notebooks, and the library from its docstrings.

``make site`` builds it into ``site/``. Nothing is fetched while it is built or read.
"""

from __future__ import annotations

import json
from typing import Any

from myst_parser.parsers.sphinx_ import MystParser

from scenewright import __version__

project, author, release = "Scenewright", "The Scenewright developers", __version__
extensions = ["myst_parser", "sphinx.ext.autodoc"]
root_doc = "index"
html_theme = "furo"
html_title = f"Scenewright {release}"
html_show_sphinx = False
html_copy_source = False
myst_heading_anchors = 3
autodoc_typehints = "none"  # the signature tells them
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
add_module_names = False


class NotebookParser(MystParser):  # type: ignore[misc]
    """A notebook as a page: its text and its code, without outputs."""

    supported = ("ipynb",)

    def parse(self, inputstring: str, document: Any) -> None:
        """Parse the cells of a notebook as one Markdown text."""
        cells = json.loads(inputstring)["cells"]
        texts = [(cell["cell_type"], "".join(cell["source"])) for cell in cells]
        parts = [f"```python\n{text}\n```" if kind == "code" else text for kind, text in texts]
        super().parse("\n\n".join(parts), document)


def setup(app: Any) -> None:
    """Let notebooks be pages."""
    app.add_source_suffix(".ipynb", "ipynb")
    app.add_source_parser(NotebookParser)
