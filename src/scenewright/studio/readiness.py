"""What is made ready while the page is looked at: the kernels of the kind of scene that is open."""

from __future__ import annotations

from threading import Event, Thread

from scenewright.core.errors import CancelledError
from scenewright.geometry.compiled import is_cold
from scenewright.studio.breeding import Tell
from scenewright.workflow.warming import SAMPLES, solve_briefly


class Readiness:
    """Kernels loaded, or compiled once on a machine, in a thread; ``tell`` hears it begin and
    end."""

    def __init__(self, tell: Tell) -> None:
        self.tell, self.stopping = tell, Event()
        self.now, self.ready = "", set[str]()
        self.cold = False

    def begin(self, kind: str) -> None:
        """Make a kind of scene ready, unless it is, or something else is being made so."""
        if self.now or kind in self.ready or kind not in SAMPLES:
            return
        self.now, self.cold = kind, is_cold()
        Thread(target=self._make, args=(kind,), daemon=True).start()

    def state(self) -> dict[str, object]:
        """The kind being made ready, and whether that is the first time on this machine."""
        return {"kind": self.now, "first": self.cold}

    def stop(self) -> None:
        """Give it up: the next search does what is left."""
        self.stopping.set()

    def _make(self, kind: str) -> None:
        self.tell({"ready": self.state()})
        try:
            solve_briefly(kind, SAMPLES[kind][0], self.stopping.is_set)
            self.ready.add(kind)
        except CancelledError:
            pass
        finally:
            self.now = ""
            self.tell({"ready": self.state()})
