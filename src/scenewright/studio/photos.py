"""Photographs of what is shown, from where a person stands: one at a time, in a thread."""

from __future__ import annotations

from io import BytesIO
from threading import Event, RLock, Thread
from typing import NamedTuple

from PIL import Image

from scenewright import domains
from scenewright.catalog.loading import catalog_of
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.extras import install_line, is_installed
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.render.observations.world import build_world
from scenewright.render.photo.photograph import SAMPLES, SIZE, photograph_view
from scenewright.studio.breeding import Tell
from scenewright.workflow.observe import check_rooms
from scenewright.workflow.photograph import check_photo

DENOISER = "pyoidn"
"""What the extra ``photo`` brings."""


class View(NamedTuple):
    """Where one stands and looks: (x, y, z) of the eye in metres, the heading in radians; the hour,
    the size in pixels and the paths of light a pixel."""

    eye: tuple[float, float, float]
    heading: float
    hour: str = "day"
    size: tuple[int, int] = SIZE
    samples: int = SAMPLES


class Photos:
    """The photographer of a session; ``tell`` hears how far it is, and what came of it."""

    def __init__(self, tell: Tell) -> None:
        self.tell = tell
        self.lock, self.stopping = RLock(), Event()
        self.worker: Thread | None = None
        self.picture = b""

    def begin(self, solution: Solution, plan: Plan, view: View) -> None:
        """Photograph a scene from a view; InputError where that cannot be."""
        check_photo(view.hour, view.size, view.samples, 0)
        check_rooms(solution.brief.domain, plan.spaces)
        with self.lock:
            if self.worker is not None and self.worker.is_alive():
                raise InputError("a photograph is being taken", "wait, or stop it first")
            self.stopping.clear()
            self.worker = Thread(target=self._take, args=(solution, plan, view), daemon=True)
            self.worker.start()

    def stop(self) -> None:
        """Give up the photograph that is being taken."""
        self.stopping.set()

    def last(self) -> bytes:
        """The photograph taken last, a PNG."""
        if not self.picture:
            raise InputError("no photograph was taken yet", "walk there and press Photo")
        return self.picture

    def _take(self, solution: Solution, plan: Plan, view: View) -> None:
        try:
            if not is_installed(DENOISER):
                self.tell({"notice": f"less noise in photographs: {install_line(DENOISER)}"})
            self.tell({"photo": 0.0})
            scene, catalog = domains.scene_of(solution, plan), catalog_of(solution.brief.catalogs)
            world = build_world(scene, catalog)
            how = (view.hour, view.size, view.samples, self._hear)
            pixels = photograph_view(world, catalog, view.eye, view.heading, *how)
            kept = BytesIO()
            Image.fromarray(pixels).save(kept, "PNG")
            self.picture = kept.getvalue()
            self.tell({"photo": 1.0})
        except CancelledError:
            self.tell({"photo": None, "notice": "stopped: no photograph was taken"})
        except InputError as error:
            self.tell({"photo": None, "fault": str(error)})

    def _hear(self, share: float) -> None:
        if self.stopping.is_set():
            raise CancelledError
        self.tell({"photo": round(min(share, 0.99), 3)})
